#include "scene/read_clump.h"

#include "base/text.h"
#include "scene/keys.h"
#include "scene/lines.h"
#include "scene/read_file.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

constexpr std::size_t largest_clump_file = 16 * 1024 * 1024;
constexpr std::size_t most_problems = 20;
constexpr double farthest = 100; // m; a body larger than a house is a file in millimetres
constexpr const char* form =
    "write each sphere as x,y,z,radius below a head of these words, or as x y z radius; metres";

class ClumpReader {
public:
    explicit ClumpReader(const std::string& source) : source_(source) {}

    Result<std::vector<Sphere>> read(std::string_view text) {
        Lines lines(text);
        Line line;
        bool started = false;
        while (problems_.size() < most_problems && lines.next(line)) {
            const std::string_view content = without_comment(line.text);
            if (trimmed(content).empty())
                continue;
            if (!started) {
                started = true;
                commas_ = content.find(',') != std::string_view::npos;
                if (commas_ && is_head(content))
                    continue;
            }
            sphere(content, line.number);
            if (spheres_.size() > most_spheres)
                return Problem{source_,
                               line.number,
                               1,
                               "",
                               fmt::format("more than {} spheres", most_spheres),
                               "use fewer, larger spheres"};
        }
        if (!problems_.empty())
            return problems_;
        if (spheres_.empty())
            return Problem{source_, 0, 0, "", "there is no sphere in this file", form};
        return spheres_;
    }

private:
    void refuse(int line, int column, std::string what) {
        problems_.push_back({source_, line, column, "", std::move(what), form});
    }

    /// Four words; a wrong or lacking head is met as numbers that cannot be read.
    static bool is_head(std::string_view content) {
        const auto fields = comma_fields(content);
        constexpr std::array<std::string_view, 4> head{"x", "y", "z", "radius"};
        if (fields.size() != head.size())
            return false;
        for (std::size_t i = 0; i < head.size(); ++i)
            if (fields[i].text != head[i])
                return false;
        return true;
    }

    void sphere(std::string_view content, int line) {
        const auto fields = commas_ ? comma_fields(content) : blank_fields(content);
        if (fields.size() != 4)
            return refuse(line, 1, fmt::format("{} values where a sphere has 4", fields.size()));
        std::array<double, 4> values{};
        bool right = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto value = parse_number(fields[i].text);
            if (!value || !(std::abs(*value) <= farthest)) {
                refuse(line, fields[i].column,
                       value ? fmt::format("{} m is too far for a body", plain(*value))
                             : fmt::format("'{}' is not a number", excerpt(fields[i].text)));
                right = false;
            } else
                values[i] = *value;
        }
        if (right && !(values[3] > 0)) {
            refuse(line, fields[3].column, fmt::format("the radius {} is not above 0", plain(values[3])));
            right = false;
        }
        if (right)
            spheres_.push_back({{values[0], values[1], values[2]}, values[3]});
    }

    const std::string& source_;
    bool commas_ = false;
    std::vector<Sphere> spheres_;
    Problems problems_;
};

} // namespace

Result<std::vector<Sphere>> parse_clump(std::string_view text, const std::string& source) {
    return ClumpReader(source).read(text);
}

Result<std::vector<Sphere>> read_clump(const std::filesystem::path& file) {
    const auto text = read_file(file, largest_clump_file);
    if (!text)
        return text.problems();
    return parse_clump(*text, file.string());
}

} // namespace tumble::scene

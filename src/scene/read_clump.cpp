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
constexpr double farthest_sphere = 100; // m; a body larger than a house is a file in millimetres
constexpr const char* sphere_form =
    "write each sphere as x,y,z,radius below a head of these words, or as x y z radius; metres";
constexpr const char* disc_form = "write each disc as x,y,radius below a head of these words, or as x y radius; metres";

class ClumpReader {
public:
    ClumpReader(const std::string& source, int dimension)
        : source_(source), heads_(dimension == 2 ? std::vector<std::string_view>{"x", "y", "radius"}
                                                 : std::vector<std::string_view>{"x", "y", "z", "radius"}),
          part_(dimension == 2 ? "disc" : "sphere"), form_(dimension == 2 ? disc_form : sphere_form) {}

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
                               fmt::format("more than {} {}s", most_spheres, part_),
                               fmt::format("use fewer, larger {}s", part_)};
        }
        if (!problems_.empty())
            return problems_;
        if (spheres_.empty())
            return Problem{source_, 0, 0, "", fmt::format("there is no {} in this file", part_), form_};
        return spheres_;
    }

private:
    void refuse(int line, int column, std::string what) {
        problems_.push_back({source_, line, column, "", std::move(what), form_});
    }

    /// The words of the head; a wrong or lacking head is met as numbers that cannot be read.
    [[nodiscard]] bool is_head(std::string_view content) const {
        const auto fields = comma_fields(content);
        if (fields.size() != heads_.size())
            return false;
        for (std::size_t i = 0; i < heads_.size(); ++i)
            if (fields[i].text != heads_[i])
                return false;
        return true;
    }

    void sphere(std::string_view content, int line) {
        const auto fields = commas_ ? comma_fields(content) : blank_fields(content);
        const std::size_t count = heads_.size();
        if (fields.size() != count)
            return refuse(line, 1, fmt::format("{} values where a {} has {}", fields.size(), part_, count));
        std::array<double, 4> values{};
        bool right = true;
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = parse_number(fields[i].text);
            if (!value || !(std::abs(*value) <= farthest_sphere)) {
                refuse(line, fields[i].column,
                       value ? fmt::format("{} m is too far for a body", plain(*value))
                             : fmt::format("'{}' is not a number", excerpt(fields[i].text)));
                right = false;
            } else
                values[i] = *value;
        }
        const double radius = values[count - 1];
        if (right && !(radius > 0)) {
            refuse(line, fields[count - 1].column, fmt::format("the radius {} is not above 0", plain(radius)));
            right = false;
        }
        if (right)
            spheres_.push_back({{values[0], values[1], count == 4 ? values[2] : 0.0}, radius});
    }

    const std::string& source_;
    std::vector<std::string_view> heads_;
    const char* part_;
    const char* form_;
    bool commas_ = false;
    std::vector<Sphere> spheres_;
    Problems problems_;
};

} // namespace

Result<std::vector<Sphere>> parse_clump(std::string_view text, const std::string& source, int dimension) {
    return ClumpReader(source, dimension).read(text);
}

Result<std::vector<Sphere>> read_clump(const std::filesystem::path& file, int dimension) {
    const auto text = read_file(file, largest_clump_file);
    if (!text)
        return text.problems();
    return parse_clump(*text, file.string(), dimension);
}

} // namespace tumble::scene

#include "scene/read_stl.h"

#include "base/text.h"
#include "scene/lines.h"
#include "scene/read_file.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace tumble::scene {
namespace {

constexpr std::size_t largest_stl_file = 512ull * 1024 * 1024;
constexpr std::size_t binary_head = 84;
constexpr std::size_t binary_triangle = 50;
constexpr double farthest_vertex =
    1e7; // file units: beyond it a float cannot tell neighbouring points of a machine apart
constexpr const char* export_again = "export the surface again as STL, or repair it in the program it came from";

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

bool is_binary(std::string_view bytes) {
    return bytes.size() >= binary_head &&
           bytes.size() == binary_head + binary_triangle * std::size_t{u32_at(bytes, 80)};
}

std::string lowered(std::string_view word) {
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

/// Collects triangles and what is wrong with them, whichever form they come in.
class Mesh {
public:
    explicit Mesh(const std::string& source) : source_(source) {}

    [[nodiscard]] bool full() const { return problems_.size() >= most_problems || triangles_.size() > most_triangles; }
    void refuse(int line, int column, std::string what, std::string fix = export_again) {
        problems_.push_back({source_, line, column, "", std::move(what), std::move(fix)});
    }

    /// Area is judged against the longest side: thinner than float rounding of the corners is none.
    void add(const Triangle& corners, int line) {
        ++count_;
        const Eigen::Vector3d a = corners[1] - corners[0];
        const Eigen::Vector3d b = corners[2] - corners[0];
        const double longest = std::max({a.norm(), b.norm(), (b - a).norm()});
        if (!(a.cross(b).norm() > 1e-9 * longest * longest))
            refuse(line, 0, fmt::format("triangle {} has no area", count_), "remove it, or export the surface again");
        triangles_.push_back(corners);
    }

    [[nodiscard]] std::size_t count() const { return count_; }

    Result<std::vector<Triangle>> result() {
        if (triangles_.size() > most_triangles)
            refuse(0, 0, fmt::format("more than {} triangles", most_triangles), "use a coarser surface");
        if (problems_.empty() && triangles_.empty())
            refuse(0, 0, "there is no triangle in this file");
        if (!problems_.empty())
            return problems_;
        return std::move(triangles_);
    }

private:
    const std::string& source_;
    std::size_t count_ = 0;
    std::vector<Triangle> triangles_;
    Problems problems_;
};

void read_binary(std::string_view bytes, Mesh& mesh) {
    for (std::size_t at = binary_head; at < bytes.size() && !mesh.full(); at += binary_triangle) {
        Triangle corners;
        bool finite = true;
        for (std::size_t k = 0; k < 9; ++k) {
            const double value = std::bit_cast<float>(u32_at(bytes, at + 12 + 4 * k));
            finite = finite && std::abs(value) <= farthest_vertex;
            corners[k / 3][static_cast<Eigen::Index>(k % 3)] = value;
        }
        if (finite)
            mesh.add(corners, 0);
        else
            return mesh.refuse(0, 0,
                               fmt::format("triangle {} has a corner that is not a usable number", mesh.count() + 1));
    }
}

class AsciiReader {
public:
    AsciiReader(std::string_view text, Mesh& mesh) : lines_(text), mesh_(mesh) {}

    void run() {
        if (!expect({"solid"}, 0))
            return;
        while (!mesh_.full() && next_line()) {
            const std::string first = lowered(fields_[0].text);
            if (first == "endsolid" || first == "solid")
                continue; // several solids may stand in one file
            if (first != "facet")
                return unexpected("facet");
            if (!facet())
                return;
        }
    }

private:
    bool next_line() {
        while (lines_.next(line_)) {
            fields_ = blank_fields(line_.text);
            if (!fields_.empty())
                return true;
        }
        return false;
    }

    void unexpected(const std::string& wanted) {
        mesh_.refuse(
            line_.number, fields_.empty() ? 1 : fields_[0].column,
            fmt::format("'{}' where '{}' was expected", fields_.empty() ? "" : excerpt(fields_[0].text), wanted));
    }

    /// The next line must begin with these words and have `more` further ones (solid may have any).
    bool expect(std::initializer_list<std::string_view> words, std::size_t more) {
        const std::string wanted(*words.begin());
        if (!next_line()) {
            mesh_.refuse(line_.number, 0, fmt::format("the file ends where '{}' was expected", wanted));
            return false;
        }
        std::size_t i = 0;
        for (const std::string_view word : words)
            if (i >= fields_.size() || lowered(fields_[i++].text) != word) {
                unexpected(wanted);
                return false;
            }
        if (wanted != "solid" && fields_.size() != words.size() + more) {
            mesh_.refuse(
                line_.number, fields_[0].column,
                fmt::format("'{}' has {} words where it needs {}", wanted, fields_.size(), words.size() + more));
            return false;
        }
        return true;
    }

    bool facet() {
        Triangle corners;
        const int line = line_.number;
        if (!expect({"outer", "loop"}, 0))
            return false;
        for (Eigen::Vector3d& corner : corners) {
            if (!expect({"vertex"}, 3))
                return false;
            for (std::size_t k = 0; k < 3; ++k) {
                const Field& field = fields_[k + 1];
                const auto value = parse_number(field.text);
                if (!value || !(std::abs(*value) <= farthest_vertex)) {
                    mesh_.refuse(line_.number, field.column,
                                 fmt::format("'{}' is not a usable number", excerpt(field.text)));
                    return false;
                }
                corner[static_cast<Eigen::Index>(k)] = *value;
            }
        }
        if (!expect({"endloop"}, 0) || !expect({"endfacet"}, 0))
            return false;
        mesh_.add(corners, line);
        return true;
    }

    Lines lines_;
    Mesh& mesh_;
    Line line_{"", 1};
    std::vector<Field> fields_;
};

} // namespace

Result<std::vector<Triangle>> parse_stl(std::string_view bytes, const std::string& source) {
    Mesh mesh(source);
    if (is_binary(bytes)) {
        read_binary(bytes, mesh);
        return mesh.result();
    }
    // A zero byte is in no text: a binary file of the wrong length deserves its own sentence.
    if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
        if (bytes.size() < binary_head)
            mesh.refuse(0, 0, fmt::format("{} bytes are too few for a binary STL file", bytes.size()));
        else
            mesh.refuse(0, 0,
                        fmt::format("a binary STL file of {} triangles has {} bytes, this one has {}",
                                    u32_at(bytes, 80), binary_head + binary_triangle * std::size_t{u32_at(bytes, 80)},
                                    bytes.size()));
        return mesh.result();
    }
    AsciiReader(bytes, mesh).run();
    return mesh.result();
}

Result<std::vector<Triangle>> read_stl(const std::filesystem::path& file) {
    const auto bytes = read_file(file, largest_stl_file);
    if (!bytes)
        return bytes.problems();
    return parse_stl(*bytes, file.string());
}

} // namespace tumble::scene

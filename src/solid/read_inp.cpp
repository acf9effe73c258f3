#include "base/text.h"
#include "solid/inp.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sstream>
#include <unordered_map>

namespace tumble::solid {

namespace {

constexpr std::size_t most_problems = 20;

std::string upper(std::string_view text) {
    std::string result(trimmed(text));
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

/// A keyword line: "*ELEMENT, TYPE=C3D8, ELSET=part".
struct Card {
    std::string name; // "*ELEMENT"; empty: none whose data are read
    std::unordered_map<std::string, std::string> options;

    [[nodiscard]] std::string option(const std::string& key) const {
        const auto found = options.find(key);
        return found == options.end() ? "" : found->second;
    }
};

class InpParser {
public:
    InpParser(std::string file, double scale) : scale_(scale) { mesh_.file = std::move(file); }

    Result<HexMesh> parse(std::string_view text) {
        for (const std::string_view piece : split(text, '\n')) {
            ++line_;
            const std::string_view line = trimmed(piece);
            if (line.empty() || line.starts_with("**"))
                continue;
            if (problems_.size() >= most_problems)
                break;
            if (line.front() == '*')
                begin(line);
            else
                data(line);
        }
        end_element();
        connect();
        if (!problems_.empty())
            return problems_;
        for (auto& [name, nodes] : mesh_.node_sets) {
            std::sort(nodes.begin(), nodes.end());
            nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        }
        return finished(std::move(mesh_));
    }

private:
    void say(std::string what, std::string fix, int line = 0) {
        problems_.push_back(
            {.file = mesh_.file, .line = line ? line : line_, .what = std::move(what), .fix = std::move(fix)});
    }

    void begin(std::string_view line) {
        end_element();
        begun_ = true;
        card_ = {};
        for (const std::string_view word : split(line, ',')) {
            const auto equals = word.find('=');
            if (card_.name.empty())
                card_.name = upper(word);
            else if (equals == std::string_view::npos)
                card_.options[upper(word)] = "";
            else
                card_.options[upper(word.substr(0, equals))] = upper(word.substr(equals + 1));
        }
        if (card_.name == "*NSET" && card_.option("NSET").empty())
            say("*NSET without a name", "write *NSET, NSET=name");
        if (card_.name == "*INCLUDE")
            say("*INCLUDE is not followed", "put the mesh into one file");
        if (card_.name != "*ELEMENT")
            return;
        const std::string type = card_.option("TYPE");
        if (!type.starts_with("C3D") && !type.empty())
            card_.name.clear(); // lines and surfaces, as gmsh writes them beside the solid
        else if (type != "C3D8" && type != "C3D8I" && type != "C3D8R")
            say(fmt::format("elements of type '{}' are not read", type),
                "mesh the part with C3D8, eight-node hexahedra");
    }

    void data(std::string_view line) {
        if (card_.name == "*NODE")
            node(line);
        else if (card_.name == "*ELEMENT")
            element(line);
        else if (card_.name == "*NSET")
            set(line);
        else if (!begun_)
            say("data before the first keyword", "begin the file with *NODE");
    }

    std::optional<int> whole(std::string_view word) {
        const auto number = parse_integer(trimmed(word));
        if (number && *number > 0 && *number <= 2'000'000'000)
            return static_cast<int>(*number);
        say(fmt::format("'{}' is no number of a node or element", excerpt(trimmed(word))), "numbers count from 1");
        return std::nullopt;
    }

    void node(std::string_view line) {
        const auto words = split(line, ',');
        if (words.size() < 4)
            return say(fmt::format("a node needs its number and three coordinates, here are {} values", words.size()),
                       "write number, x, y, z");
        const auto number = whole(words[0]);
        Eigen::Vector3d place;
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = parse_number(trimmed(words[static_cast<std::size_t>(axis) + 1]));
            if (!value)
                return say(
                    fmt::format("'{}' is no coordinate", excerpt(trimmed(words[static_cast<std::size_t>(axis) + 1]))),
                    "write it as 1.5e-3");
            place[axis] = scale_ * *value;
        }
        if (!number)
            return;
        if (!index_of_.emplace(*number, static_cast<int>(mesh_.nodes.size())).second)
            return say(fmt::format("node {} is there twice", *number), "give each node its own number");
        mesh_.nodes.push_back(place);
        mesh_.node_numbers.push_back(*number);
        if (const std::string name = card_.option("NSET"); !name.empty())
            mesh_.node_sets[name].push_back(static_cast<int>(mesh_.nodes.size()) - 1);
    }

    /// Nothing more comes of an element that has begun.
    void end_element() {
        if (!element_.empty())
            say(fmt::format("element {} ends after {} of its 8 nodes", element_.front(), element_.size() - 1),
                "list eight nodes behind its number", element_line_);
        element_.clear();
    }

    /// An element's nodes may go on in the next line.
    void element(std::string_view line) {
        if (element_.empty())
            element_line_ = line_;
        for (const std::string_view word : split(line, ','))
            if (!trimmed(word).empty()) {
                const auto number = whole(word);
                if (!number)
                    return element_.clear();
                element_.push_back(*number);
            }
        if (element_.size() < 9)
            return;
        if (element_.size() > 9)
            say(fmt::format("element {} has {} nodes instead of 8", element_.front(), element_.size() - 1),
                "list eight nodes behind its number", element_line_);
        else if (!known_elements_.emplace(element_.front(), element_line_).second)
            say(fmt::format("element {} is there twice", element_.front()), "give each element its own number",
                element_line_);
        else
            written_.push_back({element_, element_line_});
        element_.clear();
    }

    void set(std::string_view line) {
        const auto words = split(line, ',');
        if (card_.options.contains("GENERATE")) {
            std::vector<int> range;
            for (const std::string_view word : words)
                if (!trimmed(word).empty()) {
                    const auto number = whole(word);
                    if (!number)
                        return;
                    range.push_back(*number);
                }
            if (range.size() < 2 || range[1] < range[0])
                return say("GENERATE needs a first and a last number", "write first, last, step");
            for (std::int64_t n = range[0]; n <= range[1]; n += range.size() > 2 ? range[2] : 1)
                sets_.push_back({card_.option("NSET"), static_cast<int>(n), line_});
            return;
        }
        for (const std::string_view word : words) {
            if (trimmed(word).empty())
                continue;
            if (!parse_integer(trimmed(word))) { // another set's name
                sets_of_sets_.push_back({card_.option("NSET"), upper(word), line_});
                continue;
            }
            if (const auto number = whole(word))
                sets_.push_back({card_.option("NSET"), *number, line_});
        }
    }

    std::optional<int> find(int number, int line, const std::string& whose) {
        const auto found = index_of_.find(number);
        if (found != index_of_.end())
            return found->second;
        say(fmt::format("{} names node {}, which is not there", whose, number), "list it under *NODE", line);
        return std::nullopt;
    }

    /// Names may be used before their nodes are listed, so this comes last.
    void connect() {
        for (const auto& [numbers, line] : written_) {
            std::array<int, 8> nodes{};
            bool all = true;
            for (std::size_t k = 0; k < 8 && problems_.size() < most_problems; ++k) {
                const auto node = find(numbers[k + 1], line, fmt::format("element {}", numbers[0]));
                all = all && node;
                nodes[k] = node.value_or(0);
            }
            if (!all)
                continue;
            mesh_.hexes.push_back(nodes);
            mesh_.hex_numbers.push_back(numbers[0]);
        }
        for (const auto& [name, number, line] : sets_)
            if (problems_.size() < most_problems)
                if (const auto node = find(number, line, fmt::format("set {}", name)))
                    mesh_.node_sets[name].push_back(*node);
        for (const auto& [name, other, line] : sets_of_sets_) {
            const auto found = mesh_.node_sets.find(other);
            if (found == mesh_.node_sets.end())
                say(fmt::format("set {} names set {}, which is not there", name, other), "define it first", line);
            else {
                const std::vector<int> nodes = found->second;
                auto& into = mesh_.node_sets[name];
                into.insert(into.end(), nodes.begin(), nodes.end());
            }
        }
    }

    struct Written {
        std::vector<int> numbers; // the element's own, then its nodes'
        int line = 0;
    };
    struct Member {
        std::string set;
        int number = 0;
        int line = 0;
    };
    struct Subset {
        std::string set, other;
        int line = 0;
    };

    double scale_;
    HexMesh mesh_;
    Problems problems_;
    Card card_;
    bool begun_ = false; // a keyword has come
    int line_ = 0;
    std::vector<int> element_; // being read
    int element_line_ = 0;
    std::vector<Written> written_;
    std::vector<Member> sets_;
    std::vector<Subset> sets_of_sets_;
    std::unordered_map<int, int> index_of_, known_elements_;
};

} // namespace

Result<HexMesh> parse_inp(std::string_view text, const std::string& file, double scale) {
    return InpParser(file, scale).parse(text);
}

Result<HexMesh> read_inp(const std::filesystem::path& file, double scale) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf()))
        return Problem{.file = file.string(), .what = "cannot be read", .fix = "check the name and its permissions"};
    return parse_inp(text.str(), file.string(), scale);
}

Result<HexMesh> mesh_of(const MeshFile& part, const Place& place) {
    Result<HexMesh> mesh = read_inp(part.file, part.scale);
    if (!mesh)
        return mesh;
    for (int f = 0; f < static_cast<int>(mesh->facets.size()); ++f) {
        const double along = mesh->area_of(f).normalized().dot(place.axis);
        mesh->facet_sets[along > 0.9 ? "top" : along < -0.9 ? "base" : "side"].push_back(f);
    }
    return mesh;
}

} // namespace tumble::solid

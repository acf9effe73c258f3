#include "base/text.h"
#include "solid/gatherer.h"
#include "solid/inp.h"
#include "solid/msh.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <unordered_map>

namespace tumble::solid {

namespace {

std::string upper(std::string_view text) {
    std::string result(trimmed(text));
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

/// Without them the mesh would be another one.
constexpr std::array<std::string_view, 8> making{"*INSTANCE", "*SYSTEM", "*ELGEN", "*ELCOPY",
                                                 "*NGEN",     "*NCOPY",  "*NFILL", "*NMAP"};

constexpr int most_passed_over = 5; // of the keywords that were passed over

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
    InpParser(std::string file, double scale) : gathered_(std::move(file), "*NODE", scale) {}

    Result<HexMesh> parse(std::string_view text) {
        for (const std::string_view piece : split(text, '\n')) {
            ++line_;
            const std::string_view line = trimmed(piece);
            if (line.empty() || line.starts_with("**"))
                continue;
            if (gathered_.tired())
                break;
            if (line.front() == '*')
                begin(line);
            else
                data(line);
        }
        end_element();
        if (hexes_ == 0 && !said_ && !passed_over_.empty())
            say(fmt::format("no hexahedra come of it; passed over: {}", passed_over_),
                "list them behind *ELEMENT, TYPE=C3D8", first_passed_over_);
        return gathered_.finish();
    }

private:
    void say(std::string what, std::string fix, int line = 0) {
        said_ = true;
        gathered_.say(line ? line : line_, std::move(what), std::move(fix));
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
        const bool mesh = card_.name == "*NODE" || card_.name == "*ELEMENT" || card_.name == "*NSET";
        if (card_.name == "*INCLUDE" || (mesh && card_.options.contains("INPUT")))
            say(fmt::format("{} of another file is not followed", card_.name), "put the mesh into one file");
        if (std::find(making.begin(), making.end(), card_.name) != making.end())
            say(fmt::format("{} makes or moves nodes and elements, which is not done here", card_.name),
                "list all nodes and elements where they are; Abaqus: without parts and assemblies");
        else if (!mesh && ++keywords_passed_over_ <= most_passed_over) {
            passed_over_ += fmt::format("{}{} in line {}", passed_over_.empty() ? "" : ", ", card_.name, line_);
            first_passed_over_ = first_passed_over_ ? first_passed_over_ : line_;
        }
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

    void node(std::string_view line) {
        const auto words = split(line, ',');
        if (words.size() < 4)
            return say(fmt::format("a node needs its number and three coordinates, here are {} values", words.size()),
                       "write number, x, y, z");
        const auto number = gathered_.whole(words[0], line_);
        const auto place = gathered_.place(&words[1], line_);
        if (!number || !place)
            return;
        gathered_.node(*number, *place, line_);
        if (const std::string name = card_.option("NSET"); !name.empty())
            gathered_.member(name, *number, line_);
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
                const auto number = gathered_.whole(word, line_);
                if (!number)
                    return element_.clear();
                element_.push_back(*number);
            }
        if (element_.size() < 9)
            return;
        if (element_.size() > 9)
            say(fmt::format("element {} has {} nodes instead of 8", element_.front(), element_.size() - 1),
                "list eight nodes behind its number", element_line_);
        else {
            std::array<int, 8> nodes{};
            std::copy_n(element_.begin() + 1, 8, nodes.begin());
            gathered_.hex(element_.front(), nodes, element_line_);
            ++hexes_;
        }
        element_.clear();
    }

    void set(std::string_view line) {
        const auto words = split(line, ',');
        if (card_.options.contains("GENERATE")) {
            std::vector<int> range;
            for (const std::string_view word : words)
                if (!trimmed(word).empty()) {
                    const auto number = gathered_.whole(word, line_);
                    if (!number)
                        return;
                    range.push_back(*number);
                }
            if (range.size() < 2 || range[1] < range[0])
                return say("GENERATE needs a first and a last number", "write first, last, step");
            return gathered_.members(card_.option("NSET"), range[0], range[1], range.size() > 2 ? range[2] : 1, line_);
        }
        for (const std::string_view word : words) {
            if (trimmed(word).empty())
                continue;
            if (!parse_integer(trimmed(word))) { // another set's name
                gathered_.members_of(card_.option("NSET"), upper(word), line_);
                continue;
            }
            if (const auto number = gathered_.whole(word, line_))
                gathered_.member(card_.option("NSET"), *number, line_);
        }
    }

    Gatherer gathered_;
    Card card_;
    bool begun_ = false; // a keyword has come
    int line_ = 0;
    int hexes_ = 0;
    bool said_ = false;       // what is wrong with some line
    std::string passed_over_; // keywords that say nothing of the mesh, the first few
    int first_passed_over_ = 0, keywords_passed_over_ = 0;
    std::vector<int> element_; // being read
    int element_line_ = 0;
};

} // namespace

Result<HexMesh> parse_inp(std::string_view text, const std::string& file, double scale) {
    return InpParser(file, scale).parse(text);
}

Result<HexMesh> read_inp(const std::filesystem::path& file, double scale) {
    const auto text = mesh_text(file.string());
    if (!text)
        return text.problems();
    return parse_inp(*text, file.string(), scale);
}

bool is_gmsh(const std::filesystem::path& file) {
    return upper(file.extension().string()) == ".MSH";
}

Result<HexMesh> mesh_of(const MeshFile& part, const Place& place) {
    Result<HexMesh> mesh = is_gmsh(part.file) ? read_msh(part.file, part.scale) : read_inp(part.file, part.scale);
    if (!mesh)
        return mesh;
    for (int f = 0; f < static_cast<int>(mesh->facets.size()); ++f) {
        const double along = mesh->area_of(f).normalized().dot(place.axis);
        mesh->facet_sets[along > 0.9 ? "top" : along < -0.9 ? "base" : "side"].push_back(f);
    }
    return mesh;
}

} // namespace tumble::solid

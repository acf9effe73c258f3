#include "base/text.h"
#include "solid/gatherer.h"
#include "solid/msh.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

namespace tumble::solid {

namespace {

constexpr int hexahedron = 5; // gmsh's number of the type

/// gmsh's types of solid elements that are no hexahedra of eight nodes.
const std::map<int, const char*> other_solids{{4, "tetrahedra of 4 nodes"},  {6, "prisms of 6 nodes"},
                                              {7, "pyramids of 5 nodes"},    {11, "tetrahedra of 10 nodes"},
                                              {12, "hexahedra of 27 nodes"}, {13, "prisms of 18 nodes"},
                                              {14, "pyramids of 14 nodes"},  {17, "hexahedra of 20 nodes"},
                                              {18, "prisms of 15 nodes"},    {19, "pyramids of 13 nodes"}};

using Words = std::vector<std::string_view>;
using Entity = std::pair<int, std::int64_t>; // dimension and number, also of a physical group

class MshParser {
public:
    MshParser(std::string_view text, std::string file, double scale)
        : lines_(split(text, '\n')), gathered_(std::move(file), "$Nodes", scale) {}

    Result<HexMesh> parse() {
        while (!broken_ && !gathered_.tired() && next()) {
            const std::string_view head = words_.front();
            if (head == "$MeshFormat")
                read_format();
            else if (!head.starts_with('$') || version_ == 0)
                fail("this is no file of gmsh", "a .msh file begins with $MeshFormat");
            else if (head == "$PhysicalNames")
                read_names();
            else if (head == "$Entities" && version_ == 4)
                read_entities();
            else if (head == "$Nodes")
                version_ == 2 ? read_nodes_2() : read_nodes_4();
            else if (head == "$Elements")
                version_ == 2 ? read_elements_2() : read_elements_4();
            else
                pass_over(std::string(head.substr(1)));
        }
        name_sets();
        return gathered_.finish();
    }

private:
    /// To the next line that is not blank.
    bool next() {
        while (line_ < static_cast<int>(lines_.size())) {
            words_ = split_words(lines_[static_cast<std::size_t>(line_++)]);
            if (!words_.empty())
                return true;
        }
        return false;
    }

    /// What comes after cannot be understood.
    void fail(std::string what, std::string fix) {
        gathered_.say(line_, std::move(what), std::move(fix));
        broken_ = true;
    }

    /// The next line of a section, of which `least` values are needed.
    bool next_of(const char* section, std::size_t least) {
        if (broken_ || gathered_.tired())
            return false;
        if (!next() || words_.front().starts_with('$')) {
            fail(fmt::format("${} ends too early", section),
                 "its first lines say how many follow; save the mesh again");
            return false;
        }
        if (words_.size() < least) {
            fail(fmt::format("a line of ${} needs {} values, here are {}", section, least, words_.size()),
                 "save the mesh again");
            return false;
        }
        return true;
    }

    std::int64_t value(std::size_t word) {
        if (word >= words_.size()) {
            fail("the line is too short", "save the mesh again");
            return 0;
        }
        if (const auto number = parse_integer(words_[word]))
            return *number;
        fail(fmt::format("'{}' is no whole number", excerpt(words_[word])), "save the mesh again");
        return 0;
    }

    void end(const char* section) {
        if (broken_ || gathered_.tired())
            return;
        if (!next() || words_.front() != fmt::format("$End{}", section))
            fail(fmt::format("${} goes on where it should end", section), "its first lines say how many follow");
    }

    void pass_over(const std::string& section) {
        while (next())
            if (words_.front() == "$End" + section)
                return;
        fail(fmt::format("${} never ends", section), "save the mesh again");
    }

    void read_format() {
        if (!next_of("MeshFormat", 3))
            return;
        if (words_[1] != "0")
            return fail("the file is binary", "save it as ASCII: Mesh.Binary = 0");
        if (words_[0] != "2.2" && words_[0] != "4.1")
            return fail(fmt::format("format {} is not read", excerpt(words_[0])),
                        "save it as 4.1 or 2.2: Mesh.MshFileVersion = 4.1");
        version_ = words_[0] == "2.2" ? 2 : 4;
        end("MeshFormat");
    }

    void read_names() {
        if (!next_of("PhysicalNames", 1))
            return;
        for (std::int64_t left = value(0); left > 0 && next_of("PhysicalNames", 3); --left) {
            const std::string_view line = lines_[static_cast<std::size_t>(line_ - 1)];
            const auto open = line.find('"'), close = line.rfind('"');
            if (open == close)
                return fail("a physical group has no name in quotes", "save the mesh again");
            name_of_[{static_cast<int>(value(0)), value(1)}] = std::string(line.substr(open + 1, close - open - 1));
        }
        end("PhysicalNames");
    }

    /// Which physical groups each entity belongs to.
    void read_entities() {
        if (!next_of("Entities", 4))
            return;
        const std::array<std::int64_t, 4> counts{value(0), value(1), value(2), value(3)};
        for (int dimension = 0; dimension < 4; ++dimension) {
            const std::size_t groups = dimension == 0 ? 4 : 7; // where their count stands, behind point or box
            for (std::int64_t left = counts[static_cast<std::size_t>(dimension)];
                 left > 0 && next_of("Entities", groups + 1); --left)
                for (std::int64_t k = 0, count = value(groups); k < count && !broken_; ++k)
                    groups_of_[{dimension, value(0)}].push_back(value(groups + 1 + static_cast<std::size_t>(k)));
        }
        end("Entities");
    }

    void read_nodes_2() {
        if (!next_of("Nodes", 1))
            return;
        for (std::int64_t left = value(0); left > 0 && next_of("Nodes", 4); --left)
            node(gathered_.whole(words_[0], line_), 1);
        end("Nodes");
    }

    void node(std::optional<int> number, std::size_t first) {
        const auto place = gathered_.place(&words_[first], line_);
        if (number && place)
            gathered_.node(*number, *place, line_);
    }

    void read_nodes_4() {
        if (!next_of("Nodes", 4))
            return;
        for (std::int64_t blocks = value(0); blocks > 0 && next_of("Nodes", 4); --blocks) {
            std::vector<std::optional<int>> numbers;
            for (std::int64_t left = value(3); left > 0 && next_of("Nodes", 1); --left)
                numbers.push_back(gathered_.whole(words_[0], line_));
            for (std::size_t k = 0; k < numbers.size() && next_of("Nodes", 3); ++k)
                node(numbers[k], 0);
        }
        end("Nodes");
    }

    void read_elements_2() {
        if (!next_of("Elements", 1))
            return;
        for (std::int64_t left = value(0); left > 0 && next_of("Elements", 3); --left) {
            const auto tags = static_cast<std::size_t>(std::max<std::int64_t>(value(2), 0));
            const std::int64_t group = tags > 0 ? value(3) : 0; // 0: none
            element(static_cast<int>(value(1)), 3 + tags, group > 0 ? std::vector{group} : std::vector<std::int64_t>{});
        }
        end("Elements");
    }

    void read_elements_4() {
        if (!next_of("Elements", 4))
            return;
        for (std::int64_t blocks = value(0); blocks > 0 && next_of("Elements", 4); --blocks) {
            const auto type = static_cast<int>(value(2));
            const auto found = groups_of_.find({static_cast<int>(value(0)), value(1)});
            const std::vector<std::int64_t> groups =
                found == groups_of_.end() ? std::vector<std::int64_t>{} : found->second;
            for (std::int64_t left = value(3); left > 0 && next_of("Elements", 2); --left)
                element(type, 1, groups);
        }
        end("Elements");
    }

    /// The line is an element whose nodes begin at word `first`.
    void element(int type, std::size_t first, const std::vector<std::int64_t>& groups) {
        if (broken_)
            return;
        if (const auto solid = other_solids.find(type); solid != other_solids.end())
            return fail(
                fmt::format("{} (type {}) are not read", solid->second, type),
                "mesh the part with hexahedra of eight nodes: transfinite and recombined, Mesh.ElementOrder = 1");
        const auto number = gathered_.whole(words_[0], line_);
        std::vector<int> nodes;
        for (std::size_t word = first; word < words_.size(); ++word)
            if (const auto node = gathered_.whole(words_[word], line_))
                nodes.push_back(*node);
        if (type == hexahedron && words_.size() != first + 8)
            return gathered_.say(line_,
                                 fmt::format("element {} has {} nodes instead of 8", excerpt(words_[0]),
                                             words_.size() - std::min(first, words_.size())),
                                 "save the mesh again");
        if (!number || nodes.size() + first != words_.size())
            return;
        if (type == hexahedron) {
            std::array<int, 8> corners{};
            std::copy(nodes.begin(), nodes.end(), corners.begin());
            // Format 2.2 writes an element once more for each further group that it belongs to.
            if (version_ == 4 || known_.insert(corners).second)
                gathered_.hex(*number, corners, line_);
        }
        const int dimension = type == hexahedron ? 3 : type == 15 ? 0 : type == 1 || type == 8 ? 1 : 2;
        for (const std::int64_t group : groups)
            for (const int node : nodes)
                members_.push_back({{dimension, group}, node, line_});
    }

    /// Names may stand behind what they name.
    void name_sets() {
        for (const auto& [group, node, line] : members_) {
            const auto name = name_of_.find(group);
            gathered_.member(name == name_of_.end() ? fmt::format("{}", group.second) : name->second, node, line);
        }
    }

    struct Member {
        Entity group;
        int node = 0;
        int line = 0;
    };

    Words lines_;
    int line_ = 0; // of words_, from 1
    Words words_;
    int version_ = 0; // 2 or 4
    bool broken_ = false;
    Gatherer gathered_;
    std::map<Entity, std::string> name_of_;
    std::map<Entity, std::vector<std::int64_t>> groups_of_;
    std::vector<Member> members_;
    std::set<std::array<int, 8>> known_;
};

} // namespace

Result<HexMesh> parse_msh(std::string_view text, const std::string& file, double scale) {
    return MshParser(text, file, scale).parse();
}

Result<HexMesh> read_msh(const std::filesystem::path& file, double scale) {
    const auto text = mesh_text(file.string());
    if (!text)
        return text.problems();
    return parse_msh(*text, file.string(), scale);
}

} // namespace tumble::solid

#pragma once

#include "base/problem.h"
#include "solid/hex_mesh.h"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace tumble::solid {

/// Takes what the lines of a mesh file say, by its numbers and in any order, and makes a mesh of it.
class Gatherer {
public:
    /// `nodes_head`: where the file lists its nodes, for remedies. Coordinates are multiplied by `scale`.
    Gatherer(std::string file, std::string nodes_head, double scale);

    void say(int line, std::string what, std::string fix);
    /// So many problems that more would help nobody.
    [[nodiscard]] bool tired() const;

    /// The number of a node or element, or a problem.
    std::optional<int> whole(std::string_view word, int line);
    /// The three coordinates in words[0..2], or a problem.
    std::optional<Eigen::Vector3d> place(const std::string_view* words, int line);

    /// `number` was given by whole(). Nothing of a number that is there already, but a problem.
    void node(int number, const Eigen::Vector3d& place, int line);
    void hex(int number, const std::array<int, 8>& nodes, int line);
    /// Nodes of a set, by their numbers first, first + step, ... up to last; they may be listed later.
    void members(const std::string& set, int first, int last, int step, int line);
    void member(const std::string& set, int number, int line) { members(set, number, number, 1, line); }
    /// All nodes of another set; it may be defined later.
    void members_of(const std::string& set, const std::string& other, int line);

    /// Problems: those gathered, nodes and sets that are not there, those of finished().
    Result<HexMesh> finish();

private:
    std::optional<int> find(int number, int line, const std::string& whose);
    void connect();
    void fill_sets();

    struct Written {
        int number = 0;
        std::array<int, 8> nodes{};
        int line = 0;
    };
    struct Member {
        std::string set;
        int first = 0, last = 0, step = 1;
        int line = 0;
    };
    struct Subset {
        std::string set, other;
        int line = 0;
    };

    std::string nodes_head_;
    double scale_;
    HexMesh mesh_;
    Problems problems_;
    std::vector<Written> written_;
    std::vector<Member> members_;
    std::vector<Subset> subsets_;
    std::unordered_map<int, int> index_of_, known_elements_;
};

/// The text of a mesh file. Problem: it cannot be read.
Result<std::string> mesh_text(const std::string& file);

} // namespace tumble::solid

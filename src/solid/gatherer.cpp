#include "solid/gatherer.h"

#include "base/text.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sstream>

namespace tumble::solid {

namespace {

constexpr std::size_t most_problems = 20;

} // namespace

Gatherer::Gatherer(std::string file, std::string nodes_head, double scale)
    : nodes_head_(std::move(nodes_head)), scale_(scale) {
    mesh_.file = std::move(file);
}

void Gatherer::say(int line, std::string what, std::string fix) {
    problems_.push_back({.file = mesh_.file, .line = line, .what = std::move(what), .fix = std::move(fix)});
}

bool Gatherer::tired() const {
    return problems_.size() >= most_problems;
}

std::optional<int> Gatherer::whole(std::string_view word, int line) {
    const auto number = parse_integer(trimmed(word));
    if (number && *number > 0 && *number <= 2'000'000'000)
        return static_cast<int>(*number);
    say(line, fmt::format("'{}' is no number of a node or element", excerpt(trimmed(word))), "numbers count from 1");
    return std::nullopt;
}

std::optional<Eigen::Vector3d> Gatherer::place(const std::string_view* words, int line) {
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = trimmed(words[axis]);
        const auto value = parse_number(word);
        if (!value) {
            say(line, fmt::format("'{}' is no coordinate", excerpt(word)), "write it as 1.5e-3");
            return std::nullopt;
        }
        place[axis] = scale_ * *value;
    }
    return place;
}

void Gatherer::node(int number, const Eigen::Vector3d& place, int line) {
    if (!index_of_.emplace(number, static_cast<int>(mesh_.nodes.size())).second)
        return say(line, fmt::format("node {} is there twice", number), "give each node its own number");
    mesh_.nodes.push_back(place);
    mesh_.node_numbers.push_back(number);
}

void Gatherer::hex(int number, const std::array<int, 8>& nodes, int line) {
    if (!known_elements_.emplace(number, line).second)
        return say(line, fmt::format("element {} is there twice", number), "give each element its own number");
    written_.push_back({number, nodes, line});
}

void Gatherer::members(const std::string& set, int first, int last, int step, int line) {
    members_.push_back({set, first, last, step, line});
}

void Gatherer::members_of(const std::string& set, const std::string& other, int line) {
    subsets_.push_back({set, other, line});
}

std::optional<int> Gatherer::find(int number, int line, const std::string& whose) {
    const auto found = index_of_.find(number);
    if (found != index_of_.end())
        return found->second;
    say(line, fmt::format("{} names node {}, which is not there", whose, number), "list it under " + nodes_head_);
    return std::nullopt;
}

void Gatherer::connect() {
    for (const auto& [number, numbers, line] : written_) {
        std::array<int, 8> nodes{};
        bool all = true;
        for (std::size_t k = 0; k < 8 && !tired(); ++k) {
            const auto node = find(numbers[k], line, fmt::format("element {}", number));
            all = all && node;
            nodes[k] = node.value_or(0);
        }
        if (!all)
            continue;
        mesh_.hexes.push_back(nodes);
        mesh_.hex_numbers.push_back(number);
    }
}

void Gatherer::fill_sets() {
    for (const auto& [name, first, last, step, line] : members_)
        for (std::int64_t number = first; number <= last && !tired(); number += step)
            if (const auto node = find(static_cast<int>(number), line, fmt::format("set {}", name)))
                mesh_.node_sets[name].push_back(*node);
    for (const Subset& subset : subsets_)
        mesh_.node_sets[subset.set]; // there, if only of others
    for (auto& [name, nodes] : mesh_.node_sets) {
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    }
    // A set may name one that is filled further down, and that one the next: again, until none grows.
    for (bool grows = true; grows && !tired();) {
        grows = false;
        for (const auto& [name, other, line] : subsets_) {
            const auto found = mesh_.node_sets.find(other);
            if (found == mesh_.node_sets.end()) {
                say(line, fmt::format("set {} names set {}, which is not there", name, other), "define it");
                continue;
            }
            std::vector<int>& nodes = mesh_.node_sets[name];
            std::vector<int> both;
            std::set_union(nodes.begin(), nodes.end(), found->second.begin(), found->second.end(),
                           std::back_inserter(both));
            grows = grows || both.size() > nodes.size();
            nodes = std::move(both);
        }
        if (!problems_.empty())
            return;
    }
}

Result<HexMesh> Gatherer::finish() {
    connect();
    fill_sets();
    if (!problems_.empty())
        return problems_;
    return finished(std::move(mesh_));
}

Result<std::string> mesh_text(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    std::error_code code;
    if (stream && std::filesystem::is_regular_file(file, code) && std::filesystem::file_size(file, code) == 0)
        return Problem{.file = file, .what = "is empty", .fix = "write the mesh again"};
    if (!stream || !(text << stream.rdbuf()))
        return Problem{.file = file, .what = "cannot be read", .fix = "check the name and its permissions"};
    return text.str();
}

} // namespace tumble::solid

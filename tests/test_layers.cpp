// The architecture as a test: src/layers.txt says which folder may include which, and this reads every #include.
#include "base/text.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

using namespace tumble;

namespace {

struct Layer {
    int level = 0;
    std::vector<std::string> below;
};
using Layers = std::map<std::string, Layer>;

/// Path from src/ -> content.
using Tree = std::map<std::string, std::string>;
using Faults = std::vector<std::string>;

constexpr std::size_t longest_file = 500; // lines

/// Headers that only these folders may see, so that the library behind them can be exchanged there.
const std::multimap<std::string, std::string> private_libraries{
    {"toml++", "scene"}, {"GL/", "render"},    {"imgui", "render"}, {"imgui", "view"},    {"stb/", "render"},
    {"CLI/", "cli"},     {"box2d/", "hard2d"}, {"boost/", "view"},  {"turbojpeg", "view"}};

Layers read_layers(const std::string& list, Faults& faults) {
    Layers layers;
    for (const std::string_view line : split(list, '\n')) {
        const auto words = split_words(line);
        if (words.empty() || words[0].starts_with('#'))
            continue;
        const auto level = parse_integer(words[0]);
        if (words.size() < 4 || !level || words[2] != ":") {
            faults.push_back(fmt::format("layers.txt: '{}' is not 'level name : folders'", line));
            continue;
        }
        Layer layer{static_cast<int>(*level), {}};
        for (auto word = words.begin() + 3; word != words.end(); ++word) {
            if (*word == "-")
                continue;
            const auto below = layers.find(std::string(*word));
            if (below == layers.end() || below->second.level >= layer.level)
                faults.push_back(fmt::format("layers.txt: {} lists {}, which is not below it", words[1], *word));
            layer.below.emplace_back(*word);
        }
        layers[std::string(words[1])] = layer;
    }
    return layers;
}

std::string folder_of(const std::string& path) {
    const auto slash = path.find('/');
    return slash == std::string::npos ? std::string{} : path.substr(0, slash);
}

std::optional<std::string> fault_of_include(const Layers& layers, const Tree& tree, const std::string& from,
                                            const std::string& included, bool quoted) {
    const std::string to = folder_of(included);
    std::string owners;
    bool owned = false;
    for (const auto& [prefix, owner] : private_libraries)
        if (!quoted && included.starts_with(prefix)) {
            owners += (owners.empty() ? "" : " and ") + owner;
            owned = owned || from == owner;
        }
    if (!owners.empty() && !owned)
        return fmt::format("{} may not include <{}>, only {} may", from, included, owners);
    if (!quoted)
        return layers.contains(to) && tree.contains(included) ? std::optional(fmt::format("write \"{}\"", included))
                                                              : std::nullopt;
    if (!tree.contains(included))
        return fmt::format("\"{}\" is not a file of src, written from src/", included);
    const auto& below = layers.at(from).below;
    if (to != from && std::find(below.begin(), below.end(), to) == below.end())
        return fmt::format("{} may not include {}", from, to);
    return std::nullopt;
}

/// Everything in the tree that the list forbids, as "path:line: what".
Faults faults_of(const std::string& list, const Tree& tree) {
    Faults faults;
    const Layers layers = read_layers(list, faults);
    const std::regex include(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
    const std::regex speaks_or_quits(
        R"(.*(\bstd::c(out|err|log)\b|\b(f|v|vf)?printf\(|\bfmt::print\(|\b(std::)?exit\().*)");
    for (const auto& [path, content] : tree) {
        const std::string folder = folder_of(path);
        if (!layers.contains(folder)) {
            faults.push_back(fmt::format("{}: folder '{}' is not in layers.txt", path, folder));
            continue;
        }
        const auto lines = split(content, '\n');
        if (lines.size() - (content.ends_with('\n') ? 1 : 0) > longest_file)
            faults.push_back(fmt::format("{}: longer than {} lines", path, longest_file));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::string line(lines[i]);
            std::smatch match;
            std::optional<std::string> fault;
            if (line.size() < 1000 && std::regex_match(line, match, include))
                fault = fault_of_include(layers, tree, folder, match[2], match[1] == "\"");
            else if (folder != "cli" && line.size() < 1000 && std::regex_match(line, speaks_or_quits))
                fault = "only cli prints and exits";
            if (fault)
                faults.push_back(fmt::format("{}:{}: {}", path, i + 1, *fault));
        }
    }
    return faults;
}

std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file.good(), path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

const std::filesystem::path src = std::filesystem::path(TUMBLE_ROOT) / "src";
const std::filesystem::path tests = std::filesystem::path(TUMBLE_ROOT) / "tests";

Tree tree_of(const std::filesystem::path& root) {
    Tree tree;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
        if (const auto kind = entry.path().extension(); kind == ".h" || kind == ".cpp")
            tree[entry.path().lexically_relative(root).generic_string()] = content_of(entry.path());
    return tree;
}

/// Tests that compare by doctest's own measure: of what is far below 1 it accepts nearly anything.
Faults loose_comparisons(const Tree& tree) {
    Faults faults;
    const std::regex loose(R"(.*\bApprox\b.*)");
    for (const auto& [path, content] : tree) {
        const auto lines = split(content, '\n');
        for (std::size_t i = 0; path != "about.h" && i < lines.size(); ++i)
            if (lines[i].size() < 1000 && std::regex_match(std::string(lines[i]), loose))
                faults.push_back(fmt::format("{}:{}: compare with about() of tests/about.h", path, i + 1));
    }
    return faults;
}

const std::string small_list = "# a comment\n0 base : -\n1 scene : base\n2 run : base scene\n3 cli : run\n";
const Tree sound{{"base/hash.h", "#pragma once\n#include <string>\n"},
                 {"scene/scene.h", "#include \"base/hash.h\"\n"},
                 {"run/run.h", "#include \"run/run.h\"\n  #  include \"scene/scene.h\"\n"},
                 {"cli/main.cpp", "#include <CLI/CLI.hpp>\n#include \"run/run.h\"\nstd::cout << 1; std::exit(1);\n"}};

/// The sound tree with one file more.
Faults faults_with(const std::string& path, const std::string& content) {
    Tree tree = sound;
    tree[path] = content;
    return faults_of(small_list, tree);
}

} // namespace

TEST_CASE("every #include goes down the list in src/layers.txt") {
    const Tree tree = tree_of(src);
    CHECK(tree.size() > 10);
    for (const std::string& fault : faults_of(content_of(src / "layers.txt"), tree))
        FAIL_CHECK("src/" << fault);
}

TEST_CASE("the checker finds nothing in a sound tree") {
    CHECK(faults_of(small_list, sound).empty());
}

TEST_CASE("the checker finds each kind of fault in a made-up bad tree") {
    CHECK(faults_with("base/bad.h", "\n#include \"scene/scene.h\"\n") ==
          Faults{"base/bad.h:2: base may not include scene"});
    CHECK(faults_with("cli/bad.cpp", "#include \"base/hash.h\"") == Faults{"cli/bad.cpp:1: cli may not include base"});
    CHECK(faults_with("scene/bad.cpp", "#include \"scene.h\"") ==
          Faults{"scene/bad.cpp:1: \"scene.h\" is not a file of src, written from src/"});
    CHECK(faults_with("run/bad.cpp", "#include \"base/../scene/scene.h\"") ==
          Faults{"run/bad.cpp:1: \"base/../scene/scene.h\" is not a file of src, written from src/"});
    CHECK(faults_with("run/bad.cpp", "#include <base/hash.h>") == Faults{"run/bad.cpp:1: write \"base/hash.h\""});
    CHECK(faults_with("attic/old.cpp", "") == Faults{"attic/old.cpp: folder 'attic' is not in layers.txt"});
    CHECK(faults_with("stray.h", "") == Faults{"stray.h: folder '' is not in layers.txt"});
    CHECK(faults_with("run/bad.cpp", "#include <toml++/toml.h>") ==
          Faults{"run/bad.cpp:1: run may not include <toml++/toml.h>, only scene may"});
    CHECK(faults_with("run/bad.cpp", "std::cerr << 1;") == Faults{"run/bad.cpp:1: only cli prints and exits"});
    CHECK(faults_with("run/bad.cpp", "fprintf(f, \"\");") == Faults{"run/bad.cpp:1: only cli prints and exits"});
    CHECK(faults_with("run/fine.cpp", "std::snprintf(b, 9, \"\"); on_exit_(x);").empty());
}

TEST_CASE("every comparison of a test says how far it may be off, relative to its value") {
    const Tree tree = tree_of(tests);
    CHECK(tree.contains("about.h"));
    for (const std::string& fault : loose_comparisons(tree))
        FAIL_CHECK("tests/" << fault);
    const std::string of_doctest = std::string("Ap") + "prox";
    CHECK(loose_comparisons({{"a/test.cpp", "\nCHECK(x == doctest::" + of_doctest + "(1e-6));\n"}}) ==
          Faults{"a/test.cpp:2: compare with about() of tests/about.h"});
    CHECK(loose_comparisons({{"a/test.cpp", "CHECK(x.is" + of_doctest + "(y));\n"}}).empty()); // Eigen's is relative
}

TEST_CASE("files may have 500 lines and not one more") {
    std::string lines;
    for (int i = 0; i < 500; ++i)
        lines += "int i;\n";
    CHECK(faults_with("run/long.cpp", lines).empty());
    CHECK(faults_with("run/long.cpp", lines + "int j;\n") == Faults{"run/long.cpp: longer than 500 lines"});
    CHECK(faults_with("run/long.cpp", lines + "int j;") == Faults{"run/long.cpp: longer than 500 lines"});
}

TEST_CASE("the list itself may not point up or sideways, nor hold what it does not explain") {
    CHECK(faults_of("0 base : -\n1 scene : run\n2 run : base\n", {}) ==
          Faults{"layers.txt: scene lists run, which is not below it"});
    CHECK(faults_of("0 base : -\n1 a : base\n1 b : a\n", {}) == Faults{"layers.txt: b lists a, which is not below it"});
    CHECK(faults_of("base : -\n", {}) == Faults{"layers.txt: 'base : -' is not 'level name : folders'"});
}

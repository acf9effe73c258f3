// What README.md and docs/ say is held against the tree and the program.
#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;
using namespace tumble;

namespace {

const fs::path root = TUMBLE_ROOT;

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE_MESSAGE(file.good(), path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> pages() {
    std::vector<fs::path> found{root / "README.md"};
    for (const auto& entry : fs::recursive_directory_iterator(root / "docs"))
        if (entry.path().extension() == ".md")
            found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

struct Page {
    std::vector<std::string> prose;                            // lines outside fences
    std::vector<std::pair<std::string, std::string>> snippets; // language, text
};

Page read_page(const fs::path& path) {
    Page page;
    bool inside = false;
    const std::string text = content_of(path);
    for (const std::string_view line : split(text, '\n')) {
        if (const std::string_view mark = trimmed(line); mark.starts_with("```")) {
            inside = !inside;
            if (inside)
                page.snippets.emplace_back(mark.substr(3), "");
        } else if (inside) {
            page.snippets.back().second += std::string(line) + "\n";
        } else {
            page.prose.emplace_back(line);
        }
    }
    return page;
}

/// As the common Markdown hosts make it from a heading.
std::string anchor_of(std::string_view heading) {
    std::string anchor;
    for (const char c : trimmed(heading)) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '_' || c == '-' || byte >= 0x80)
            anchor += static_cast<char>(std::tolower(byte));
        else if (c == ' ')
            anchor += '-';
    }
    return anchor;
}

std::set<std::string> anchors_of(const fs::path& path) {
    std::set<std::string> anchors;
    for (const std::string& line : read_page(path).prose)
        if (const auto text = line.find_first_not_of('#'); text != 0 && text != std::string::npos && line[text] == ' ')
            anchors.insert(anchor_of(line.substr(text)));
    return anchors;
}

struct Link {
    std::string file, anchor;
};

std::vector<Link> links_of(const fs::path& path) {
    std::vector<Link> links;
    const std::regex link(R"(\]\(([^)#\s]*)(#([^)\s]*))?\))");
    for (const std::string& line : read_page(path).prose)
        for (auto match = std::sregex_iterator(line.begin(), line.end(), link); match != std::sregex_iterator{};
             ++match)
            if (!(*match)[1].str().starts_with("http"))
                links.push_back({(*match)[1], (*match)[3]});
    return links;
}

/// What the page shows, as paths seen from the root.
std::vector<fs::path> pictures_of(const fs::path& page) {
    std::vector<fs::path> pictures;
    const std::regex picture(R"(!\[[^\]]*\]\(([^)\s]*)\))");
    for (const std::string& line : read_page(page).prose)
        for (auto match = std::sregex_iterator(line.begin(), line.end(), picture); match != std::sregex_iterator{};
             ++match)
            pictures.push_back((page.parent_path() / (*match)[1].str()).lexically_normal().lexically_relative(root));
    return pictures;
}

/// First words of the lines that the program prints.
std::set<std::string> first_words_of(const std::string& arguments) {
    std::FILE* pipe = popen(fmt::format("'{}' {}", TUMBLE_PROGRAM, arguments).c_str(), "r");
    REQUIRE(pipe);
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        text += static_cast<char>(c);
    REQUIRE(pclose(pipe) == 0);
    std::set<std::string> words;
    for (const std::string_view line : split(text, '\n'))
        if (const auto all = split_words(line); !all.empty())
            words.emplace(all.front());
    return words;
}

/// Exit code of `build/release/tumble ...`, run as the program under test from a folder, its output thrown away.
int exit_code_of(const std::string& arguments, const fs::path& folder = root) {
    const std::string command =
        fmt::format("cd '{}' && '{}' {} >/dev/null 2>&1 </dev/null", folder.string(), TUMBLE_PROGRAM, arguments);
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Lines of a page's `sh` snippets, comments taken off.
std::vector<std::string> commands_of(const fs::path& page) {
    std::vector<std::string> commands;
    for (const auto& [language, text] : read_page(page).snippets)
        if (language == "sh")
            for (const std::string_view line : split(text, '\n'))
                if (const auto command = trimmed(line.substr(0, line.find('#'))); !command.empty())
                    commands.emplace_back(command);
    return commands;
}

} // namespace

TEST_CASE("headings become anchors as Markdown hosts make them") {
    CHECK(anchor_of(" What LIGGGHTS computes") == "what-liggghts-computes");
    CHECK(anchor_of(" run.json") == "runjson");
    CHECK(anchor_of(" Time, steps & cost") == "time-steps--cost");
}

TEST_CASE("every link in README and docs leads somewhere") {
    for (const fs::path& page : pages())
        for (const Link& link : links_of(page)) {
            const fs::path target = link.file.empty() ? page : page.parent_path() / link.file;
            CHECK_MESSAGE(fs::exists(target), page.string() << " links to " << link.file);
            if (!link.anchor.empty() && fs::exists(target))
                CHECK_MESSAGE(anchors_of(target).contains(link.anchor),
                              page.string() << " links to " << link.file << "#" << link.anchor);
        }
}

TEST_CASE("what README and docs show is made by the gallery, or by its lesson") {
    const std::set<std::string> gallery = first_words_of("gallery --list");
    std::set<fs::path> shown;
    for (const fs::path& page : pages())
        for (const fs::path& picture : pictures_of(page)) {
            const fs::path folder = picture.parent_path();
            const std::string name = picture.filename();
            const bool of_lesson = folder == fs::path("docs/lessons") / page.stem();
            CHECK_MESSAGE((of_lesson || (folder == "docs/gallery" && gallery.contains(name))),
                          page.string() << " shows " << picture.string());
            shown.insert(picture);
        }
    for (const std::string& name : gallery)
        CHECK_MESSAGE(shown.contains(fs::path("docs/gallery") / name), "no page shows docs/gallery/" << name);
    for (const auto& entry : fs::directory_iterator(root / "docs/gallery"))
        CHECK_MESSAGE(shown.contains(entry.path().lexically_relative(root)), "nobody shows " << entry.path());
}

TEST_CASE("docs/index.md leads to every page of docs, to lessons by their own index") {
    std::set<fs::path> linked{root / "docs" / "index.md", root / "README.md"};
    for (const fs::path& index : {root / "docs" / "index.md", root / "docs" / "lessons" / "index.md"})
        for (const Link& link : links_of(index))
            linked.insert((index.parent_path() / link.file).lexically_normal());
    for (const fs::path& page : pages())
        CHECK_MESSAGE(linked.contains(page), page.string());
}

TEST_CASE("README names the page that a newcomer should read, and the two commands, in its first screen") {
    const std::string readme = content_of(root / "README.md");
    const auto lines = split(readme, '\n');
    std::string screen;
    for (std::size_t i = 0; i < std::min<std::size_t>(lines.size(), 24); ++i)
        screen += std::string(lines[i]) + "\n";
    for (const char* name : {"./demo", "./check", "src/sim3d/step.cpp"})
        CHECK_MESSAGE(screen.find(name) != std::string::npos, name);
}

TEST_CASE("README's commands exist, and the quick ones succeed") {
    const std::string program = "build/release/tumble ";
    const std::string presets = content_of(root / "CMakePresets.json");
    int ran = 0;
    for (const std::string& command : commands_of(root / "README.md")) {
        CAPTURE(command);
        const auto words = split_words(command);
        if (command.starts_with("./")) {
            CHECK((fs::status(root / std::string(words[0])).permissions() & fs::perms::owner_exec) != fs::perms::none);
        } else if (const auto preset = command.find("--preset "); preset != std::string::npos) {
            CHECK(presets.find(fmt::format("\"{}\"", command.substr(preset + 9))) != std::string::npos);
        } else {
            REQUIRE(command.starts_with(program));
            const std::string arguments = command.substr(program.size());
            const bool quick = words[1] == "list" || words[1] == "check";
            CHECK(exit_code_of(quick ? arguments : fmt::format("{} --help", words[1])) == 0);
            ++ran;
        }
    }
    CHECK(ran >= 3);
}

TEST_CASE("README's scene is complete: the program takes it as it is printed") {
    int checked = 0;
    for (const auto& [language, text] : read_page(root / "README.md").snippets) {
        if (language != "toml")
            continue;
        const fs::path file = fs::temp_directory_path() / ("tumble-readme-scene-" + std::to_string(getpid()) + ".toml");
        std::ofstream(file) << text;
        CHECK(exit_code_of(fmt::format("check '{}'", file.string())) == 0);
        fs::remove(file);
        ++checked;
    }
    CHECK(checked == 1);
}

TEST_CASE("docs/first-scene.md: its scene is taken as it is printed, and every command runs") {
    const fs::path page = root / "docs" / "first-scene.md";
    const fs::path folder = fs::temp_directory_path() / ("tumble-first-scene-" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directory(folder);
    for (const auto& [language, text] : read_page(page).snippets)
        if (language == "toml")
            std::ofstream(folder / "first.toml") << text;
    const std::string program = "build/release/tumble ";
    int ran = 0;
    for (const std::string& command : commands_of(page)) {
        CAPTURE(command);
        REQUIRE(command.starts_with(program));
        CHECK(exit_code_of(command.substr(program.size()), folder) == 0);
        ++ran;
    }
    CHECK(ran >= 5);
    CHECK(!fs::is_empty(folder / "out" / "first" / "redrawn" / "free_speed"));
    fs::remove_all(folder);
}

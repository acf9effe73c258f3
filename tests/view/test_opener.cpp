#include "../folder.h"
#include "view/opener.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <mutex>
#include <thread>

using namespace tumble;
using namespace tumble::view;

namespace test_opener {

/// An xdg-open of our own, first in PATH, that keeps the words it was called with.
struct FakeBrowser {
    test::Folder folder;
    std::string path = std::getenv("PATH");

    explicit FakeBrowser(const std::string& rest) {
        const auto program = folder.path / "xdg-open";
        test::put(program, "#!/bin/sh\nprintf '%s' \"$*\" > \"" + (folder.path / "words.part").string() + "\"\nmv \"" +
                               (folder.path / "words.part").string() + "\" \"" + (folder.path / "words").string() +
                               "\"\n" + rest + "\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        ::setenv("PATH", (folder.path.string() + ":" + path).c_str(), 1);
    }
    FakeBrowser(const FakeBrowser&) = delete;
    FakeBrowser& operator=(const FakeBrowser&) = delete;
    ~FakeBrowser() { ::setenv("PATH", path.c_str(), 1); }

    std::string words() const {
        for (int i = 0; i < 6000 && !std::filesystem::exists(folder.path / "words"); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return test::content_of(folder.path / "words");
    }
};

const std::string link = "http://127.0.0.1:4711/?token=0123456789abcdef0123456789abcdef";

TEST_CASE("the link stands on no command line but in a page that only its owner can read, and that goes in the end") {
    const FakeBrowser browser("exit 0");
    auto opener = Opener::open(link, browser.folder.path / "kept", [](const std::string&) {});
    REQUIRE_MESSAGE(opener.ok(), to_string(opener.problems()));
    const std::string words = browser.words();
    CHECK(words.find("token") == std::string::npos);
    const std::filesystem::path page = words;
    CHECK(page.is_absolute());
    CHECK(std::filesystem::status(page).permissions() ==
          (std::filesystem::perms::owner_read | std::filesystem::perms::owner_write));
    CHECK(test::content_of(page).find("content=\"0;url=" + link + "\"") != std::string::npos);
    opener->reset();
    CHECK(!std::filesystem::exists(page));
}

TEST_CASE("an xdg-open that finds no browser is noticed by its exit status") {
    const FakeBrowser browser("exit 3");
    std::mutex mutex;
    std::string told;
    const auto opener = Opener::open(link, browser.folder.path / "kept", [&](const std::string& why) {
        const std::lock_guard lock(mutex);
        told = why;
    });
    REQUIRE(opener.ok());
    const auto heard = [&] {
        const std::lock_guard lock(mutex);
        return told;
    };
    for (int i = 0; i < 6000 && heard().empty(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(heard() == "no browser has opened (xdg-open ended with 3)");
}

} // namespace test_opener

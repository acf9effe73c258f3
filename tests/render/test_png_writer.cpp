#include "fixtures.h"
#include "render/png_writer.h"
#include "through.h"

#include <fstream>
#include <iterator>
#include <new>
#include <stb/stb_image.h>

namespace test_png_writer {

using namespace tumble;
using namespace tumble::render;
using namespace tumble::render::testing;

namespace {

Picture pattern(int width, int height) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int v : {x * 7, y * 5, x * y, 255}) {
                picture.rgba.push_back(static_cast<std::uint8_t>(v == 255 ? 255 : v % 256));
            }
        }
    }
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
        picture.rgba[i] = 255;
    }
    return picture;
}

std::vector<std::uint8_t> decoded(const std::filesystem::path& file, int& width, int& height) {
    int channels = 0;
    stbi_uc* pixels = stbi_load(file.c_str(), &width, &height, &channels, 4);
    REQUIRE(pixels != nullptr);
    std::vector<std::uint8_t> bytes(pixels, pixels + 4 * width * height);
    stbi_image_free(pixels);
    return bytes;
}

} // namespace

TEST_CASE("a PNG file decodes to the picture that was written") {
    const Folder folder;
    const Picture picture = pattern(97, 31);
    PngWriter writer;
    CHECK(writer.add(folder.path / "a.png", picture).ok());
    CHECK(writer.finish().ok());
    int width = 0;
    int height = 0;
    CHECK(decoded(folder.path / "a.png", width, height) == picture.rgba);
    CHECK(width == 97);
    CHECK(height == 31);
}

TEST_CASE("many pictures come out whole and in their own files through a queue of one") {
    const Folder folder;
    {
        PngWriter writer(1);
        for (int i = 1; i <= 20; ++i) {
            CHECK(writer.add(folder.path / (std::to_string(i) + ".png"), pattern(40 + i, 30)).ok());
        }
    } // the end of its life finishes too
    CHECK(folder.files() == 20);
    for (int i = 1; i <= 20; ++i) {
        int width = 0;
        int height = 0;
        CHECK(decoded(folder.path / (std::to_string(i) + ".png"), width, height) == pattern(40 + i, 30).rgba);
    }
}

TEST_CASE("a file in a folder that does not exist is a problem with the file's name, and stays one") {
    const Folder folder;
    PngWriter writer;
    CHECK(writer.add(folder.path / "nowhere" / "a.png", pattern(8, 8)).ok());
    const auto verdict = writer.finish();
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().file == (folder.path / "nowhere" / "a.png").string());
    CHECK(verdict.problems().front().what == "cannot write the file: No such file or directory");
    CHECK(verdict.problems().front().fix == "name a place in a folder that is there and where you may write");
    CHECK(!writer.add(folder.path / "b.png", pattern(8, 8)).ok());
    CHECK(folder.files() == 0);
}

TEST_CASE("a disk without room is a problem and leaves nothing behind") {
    const Folder folder;
    // The unfinished file's name leads to the device that is always full.
    std::filesystem::create_symlink("/dev/full", folder.path / "a.png.part");
    PngWriter writer;
    CHECK(writer.add(folder.path / "a.png", pattern(8, 8)).ok());
    const auto verdict = writer.finish();
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().what == "cannot write the file: No space left on device");
    CHECK(verdict.problems().front().fix == "free some space, or write to another disk");
    CHECK(folder.files() == 0);
}

TEST_CASE("an older picture is replaced only by a whole one") {
    const Folder folder;
    std::ofstream(folder.path / "a.png") << "older";
    std::filesystem::create_symlink("/dev/full", folder.path / "a.png.part");
    PngWriter writer;
    CHECK(writer.add(folder.path / "a.png", pattern(8, 8)).ok());
    CHECK(!writer.finish().ok());
    std::ifstream file(folder.path / "a.png");
    CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == "older");
}

TEST_CASE("an exception while a picture is written, as when memory runs out, becomes a problem and ends nothing else") {
    const Folder folder;
    const test::Through no_memory({.write = [](int, const void*, std::size_t) -> ssize_t { throw std::bad_alloc(); }});
    PngWriter writer;
    CHECK(writer.add(folder.path / "a.png", pattern(8, 8)).ok());
    const auto verdict = writer.finish();
    REQUIRE(!verdict.ok());
    CHECK(verdict.problems().front().file == (folder.path / "a.png").string());
    CHECK(verdict.problems().front().what == "the picture could not be written: there is not enough memory");
    CHECK(!std::filesystem::exists(folder.path / "a.png"));
}

} // namespace test_png_writer

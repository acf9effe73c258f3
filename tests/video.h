#pragma once

#include <cstdio>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <string>

/// What ffprobe says of a video.
namespace tumble::test {

/// Where one of them is missing a test of videos is left out: apt install ffmpeg.
inline bool can_check_videos() {
    const bool can = std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") == 0;
    if (!can)
        MESSAGE("skipped: needs ffmpeg and ffprobe (apt install ffmpeg)");
    return can;
}

/// Entries of its first stream, parted by commas: "160,90,30" of width, height and the frames, all of which are
/// unpacked for that. Empty for what is no video.
inline std::string probed(const std::filesystem::path& file,
                          const std::string& entries = "width,height,nb_read_frames") {
    const std::string command = "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entries +
                                " -of csv=p=0 '" + file.string() + "' 2> /dev/null";
    std::FILE* pipe = ::popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string words;
    for (int letter = std::fgetc(pipe); letter != EOF && letter != '\n'; letter = std::fgetc(pipe))
        words += static_cast<char>(letter);
    ::pclose(pipe);
    return words;
}

} // namespace tumble::test

#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace tumble {

/// How a file's name ends, in small letters and with its dot: ".png" of "A.PNG"; empty where it has no ending.
inline std::string ending_of(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return ending;
}

} // namespace tumble

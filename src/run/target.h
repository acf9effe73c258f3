#pragma once

#include "base/problem.h"

#include <filesystem>
#include <optional>
#include <string>

namespace tumble::run {

/// A file or folder to be filled; taken away again when nothing came of it and it was not there before.
class Target {
public:
    /// An empty path: nothing is wanted.
    explicit Target(std::filesystem::path place) : place_(std::move(place)) {}
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target();

    /// Before it is filled with files of that extension. Problem: it is there already and may not be overwritten.
    std::optional<Problem> claim(bool overwrite, const std::string& extension);

    void keep() { fresh_ = false; }

private:
    void remove_old(const std::string& extension) const;

    std::filesystem::path place_;
    bool fresh_ = false;
};

} // namespace tumble::run

#pragma once

#include "../folder.h"

#include <cstdlib>

namespace tumble::view::testing {

/// In place of ffmpeg a program that keeps the pictures of films as they come, for as long as it lives.
struct Keeper {
    test::Folder folder;
    std::string before = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
    Keeper() {
        const std::filesystem::path program = folder.path / "ffmpeg";
        test::put(program, "#!/bin/sh\nfor last; do :; done\n"
                           "case \"$*\" in *rawvideo*) cat > \"${last#file:}\";; esac\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        ::setenv("PATH", (folder.path.string() + ":" + before).c_str(), 1);
    }
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;
    ~Keeper() { ::setenv("PATH", before.c_str(), 1); }
};

} // namespace tumble::view::testing

#pragma once

#include "base/child_process.h"
#include "base/problem.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace tumble::view {

/// Shows a link in the browser of who sits at this machine, by xdg-open. Command lines can be read by everybody on it
/// (/proc), and the link lets in whoever has it: xdg-open gets a page, a file that only its owner can read, which leads
/// on to the link. The file goes with the opener.
class Opener {
public:
    /// `failed` is told, from a thread of its own, why no browser has opened. Problems: the page cannot be written into
    /// that folder, xdg-open cannot be started.
    static Result<std::unique_ptr<Opener>> open(const std::string& link, const std::filesystem::path& folder,
                                                std::function<void(const std::string& why)> failed);
    Opener(const Opener&) = delete;
    Opener& operator=(const Opener&) = delete;
    ~Opener();

private:
    explicit Opener(std::filesystem::path page) : page_(std::move(page)) {}

    std::filesystem::path page_;
    std::unique_ptr<ChildProcess> program_;
    std::jthread watch_;
};

} // namespace tumble::view

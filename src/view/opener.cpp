#include "view/opener.h"

#include "base/make_folder.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <unistd.h>

namespace tumble::view {

namespace {

constexpr std::chrono::milliseconds glance{50}; // between two looks at whether xdg-open has ended

/// 0, or the system's reason.
int write_for_owner(const std::filesystem::path& file, const std::string& text) {
    std::error_code none; // is no trouble
    std::filesystem::remove(file, none);
    const int place = ::open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0600);
    if (place < 0)
        return errno;
    const ssize_t written = ::write(place, text.data(), text.size());
    const int failed = written == static_cast<ssize_t>(text.size()) ? 0 : (written < 0 ? errno : ENOSPC);
    ::close(place);
    return failed;
}

} // namespace

Result<std::unique_ptr<Opener>> Opener::open(const std::string& link, const std::filesystem::path& folder,
                                             std::function<void(const std::string& why)> failed) {
    if (const auto made = make_folder(folder); !made)
        return made.problems();
    std::unique_ptr<Opener> opener(new Opener(folder / fmt::format("open-view-{}.html", ::getpid())));
    const std::string page = fmt::format("<!doctype html>\n<meta charset=\"utf-8\">\n<title>tumble</title>\n"
                                         "<meta http-equiv=\"refresh\" content=\"0;url={0}\">\n"
                                         "<a href=\"{0}\">The view</a>\n",
                                         link);
    if (const int reason = write_for_owner(opener->page_, page); reason != 0)
        return Problem{.file = opener->page_.string(),
                       .what = fmt::format("cannot be written: {}", std::strerror(reason)),
                       .fix = "open the link yourself"};
    std::error_code relative_it_stays;
    const auto whole = std::filesystem::absolute(opener->page_, relative_it_stays);
    opener->program_ = std::make_unique<ChildProcess>(std::vector<std::string>{"xdg-open", whole.string()});
    if (opener->program_->error() != 0)
        return Problem{.what = fmt::format("no browser opens by itself here (xdg-open: {})",
                                           std::strerror(opener->program_->error())),
                       .fix = "open the link yourself"};
    opener->watch_ =
        std::jthread([&program = *opener->program_, told = std::move(failed)](const std::stop_token& stop) {
            std::optional<int> status;
            while (!stop.stop_requested() && !(status = program.ended()))
                std::this_thread::sleep_for(glance);
            if (status && *status != 0)
                told(fmt::format("no browser has opened (xdg-open ended with {})", *status));
        });
    return opener;
}

Opener::~Opener() {
    watch_ = {};
    std::error_code gone_already;
    std::filesystem::remove(page_, gone_already);
}

} // namespace tumble::view

#include "cli/progress_line.h"

#include "base/text.h"
#include "cli/console.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tumble::cli {

namespace {

constexpr double redraw_every = 0.1;   // s, on a terminal
constexpr double first_line_after = 5; // s, elsewhere
constexpr double waiting_worth_a_word = 0.1;
constexpr double lines_stretch_by = 1.3; // each line comes when so many times the time of the last one has passed

std::size_t terminal_width() {
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 20 ? size.ws_col : 80;
}

std::string bar(double share) {
    constexpr int width = 20;
    const int full = static_cast<int>(share * width);
    const bool color = stderr_takes_color();
    return fmt::format("{}{}{}{}{}", color ? "\033[36m" : "", std::string(static_cast<std::size_t>(full), '#'),
                       color ? "\033[90m" : "", std::string(static_cast<std::size_t>(width - full), '-'),
                       color ? "\033[0m" : "");
}

double share_of(std::int64_t done, std::int64_t all) {
    return static_cast<double>(done) / static_cast<double>(std::max<std::int64_t>(all, 1));
}

std::string in_words(const run::Progress& now) {
    const double kinetic = now.books.kinetic_translation + now.books.kinetic_rotation;
    const std::string waits = now.waiting_share >= waiting_worth_a_word
                                  ? fmt::format(", {:.0f} % of the time waits for frames", 100 * now.waiting_share)
                                  : "";
    const std::string left = now.left_s && now.step < now.steps ? ", " + duration(*now.left_s) + " left" : "";
    return fmt::format("t = {:.4g} of {:.4g} s, {}, {:.3g} steps/s{}{}, kinetic energy {}", now.time, now.duration,
                       counted(now.books.bodies, "body", "bodies"), now.steps_per_s, left, waits,
                       format_si(kinetic, "J", 3));
}

} // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(stderr_is_terminal()) {
    next_ = terminal_ ? 0 : first_line_after;
}

void ProgressLine::started(const std::filesystem::path& folder, const run::Progress& now) {
    if (quiet_)
        return;
    end();
    const std::string from = now.step > 0 ? fmt::format(", on from t = {:.6g} s", now.time) : "";
    note(fmt::format("running {:.4g} s in {} steps into {}{}", now.duration, now.steps, folder.string(), from));
}

void ProgressLine::prepares(std::string_view what, std::int64_t done, std::int64_t all) {
    if (!quiet_)
        show(fmt::format("{} of {} {}", done, all, what), false, share_of(done, all), true);
}

void ProgressLine::brought_back(std::int64_t done, std::int64_t all) {
    if (!quiet_)
        show(fmt::format("frame {} of {} of before, drawn and written anew", done, all), done >= all,
             share_of(done, all));
}

void ProgressLine::nothing_left_to_do(const std::filesystem::path& folder) {
    if (!quiet_)
        note(fmt::format(
            "{}: this run has come to its end: nothing is left to do, and nothing was touched\n    a longer "
            "--duration goes on from there, --force in place of --resume runs it again",
            folder.string()));
}

void ProgressLine::progressed(const run::Progress& now) {
    if (!quiet_)
        show(in_words(now), now.step >= now.steps, now.steps > 0 ? share_of(now.step, now.steps) : 1.0);
}

void ProgressLine::frames(std::int64_t done, std::int64_t all) {
    if (!quiet_)
        show(fmt::format("frame {} of {}", done, all), done >= all, share_of(done, all));
}

void ProgressLine::working(const std::string& text) {
    if (!quiet_)
        show(text, false, std::nullopt);
}

void ProgressLine::show(const std::string& text, bool last, std::optional<double> share, bool passing) {
    const double now = std::chrono::duration<double>(Clock::now() - begun_).count();
    if (now < next_ && !(last && line_open_))
        return;
    if (!terminal_) {
        note(share ? fmt::format("{:3.0f} %  {}", 100 * *share, text) : text);
        next_ = std::max(now + first_line_after, now * lines_stretch_by);
        return;
    }
    const std::size_t room = terminal_width() - 1;
    constexpr std::size_t head_width = 27;
    const std::string head = share ? fmt::format("{:3.0f} % {} ", 100 * *share, bar(*share)) : "";
    const std::size_t taken = share ? head_width : 0;
    std::fputs(("\r\033[K" + head + text.substr(0, room > taken ? room - taken : 0)).c_str(), stderr);
    std::fflush(stderr);
    line_open_ = true;
    passing_ = passing;
    next_ = now + redraw_every;
}

void ProgressLine::end() {
    if (line_open_)
        std::fputs(passing_ ? "\r\033[K" : "\n", stderr);
    line_open_ = false;
}

void ProgressLine::warned(const std::string& sentence) {
    end();
    if (!quiet_)
        note((stderr_takes_color() ? "\033[33mwarning:\033[0m " : "warning: ") + sentence);
}

} // namespace tumble::cli

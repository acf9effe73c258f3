#pragma once

#include "run/run_scene.h"

#include <chrono>
#include <optional>
#include <string>

namespace tumble::cli {

/// Tells on stderr how a run goes: a line that is drawn over on a terminal, else a line now and then (rarer as a run
/// gets longer), nothing when quiet.
class ProgressLine : public run::RunListener {
public:
    explicit ProgressLine(bool quiet);

    /// On a terminal the line goes away again before anything else is said.
    void prepares(std::string_view what, std::int64_t done, std::int64_t all) override;
    void started(const std::filesystem::path& folder, const run::Progress& now) override;
    void progressed(const run::Progress& now) override;
    void warned(const std::string& sentence) override;
    void brought_back(std::int64_t frames, std::int64_t of) override;
    void nothing_left_to_do(const std::filesystem::path& folder) override;

    /// The same for work counted in frames, and for work of which nobody knows how much there will be.
    void frames(std::int64_t done, std::int64_t all);
    void working(const std::string& text);
    /// Leaves the terminal on a fresh line.
    void end();

private:
    using Clock = std::chrono::steady_clock;

    /// A passing line leaves nothing behind on a terminal.
    void show(const std::string& text, bool last, std::optional<double> share, bool passing = false);

    bool quiet_;
    bool terminal_;
    bool line_open_ = false;
    bool passing_ = false;
    Clock::time_point begun_ = Clock::now();
    double next_ = 0; // s after begun_
};

} // namespace tumble::cli

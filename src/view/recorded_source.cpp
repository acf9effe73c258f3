#include "view/recorded_source.h"

#include "base/thrown.h"
#include "observe/frame_file.h"
#include "run/redraw.h"
#include "run/replay.h"
#include "run/tracers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <mutex>
#include <thread>

namespace tumble::view {

namespace {

using Clock = std::chrono::steady_clock;

class RecordedSource final : public Source {
public:
    RecordedSource(std::filesystem::path folder, run::Recording recording, run::RedrawOptions words,
                   std::vector<double> times, bool contacts, std::function<void()> news)
        : folder_(std::move(folder)), recording_(std::move(recording)), times_(std::move(times)),
          words_(std::move(words)), has_contacts_(contacts), speed_(1 / words_.settings.slowdown()),
          news_(std::move(news)), clock_(times_.front()) {}
    RecordedSource(const RecordedSource&) = delete;
    RecordedSource& operator=(const RecordedSource&) = delete;
    ~RecordedSource() override { stop_film_ = true; }

    [[nodiscard]] std::shared_ptr<const observe::FrameLayout> layout() const override { return recording_.layout; }
    [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return recording_.bounds; }
    [[nodiscard]] bool can_seek() const override { return true; }
    [[nodiscard]] bool can_change() const override { return false; }
    [[nodiscard]] bool can_show_contacts() const override { return has_contacts_; }
    [[nodiscard]] std::vector<std::string> warnings() const override { return recording_.warnings; }

    [[nodiscard]] Result<Stretch> find(double from, double to) override {
        const auto is_in = [&](const run::RecordedFrame& frame) { return run::is_within(frame, from, to); };
        const auto& frames = recording_.frames;
        const auto first = std::find_if(frames.begin(), frames.end(), is_in);
        if (first == frames.end())
            return run::refuse_time(folder_.string(), times_, from, to);
        const auto last = std::find_if(frames.rbegin(), frames.rend(), is_in);
        return Stretch{first->time, last->time};
    }

    MomentPtr newest() override {
        tick();
        const std::size_t wanted = frame_at(clock_);
        if (moment_ && wanted == shown_)
            return moment_;
        shown_ = wanted;
        Result<observe::Frame> frame = observe::read_frame(recording_.frames[wanted].file, recording_.layout);
        trouble_ = frame ? "" : "this frame cannot be read: " + to_string(frame.problems().front());
        if (frame) {
            auto moment = std::make_shared<Moment>();
            moment->frame = std::move(*frame);
            moment->number = ++moments_;
            moment_ = std::move(moment);
        }
        return moment_;
    }

    [[nodiscard]] SourceState state() override {
        SourceState state;
        state.playing = playing_;
        state.ended = clock_ >= times_.back();
        state.time = times_[frame_at(clock_)];
        state.first = times_.front();
        state.last = times_.back();
        state.speed = speed_;
        state.pace = playing_ ? speed_ : 0;
        state.trouble = trouble_;
        const std::lock_guard lock(mutex_);
        state.filming = filming_;
        state.filmed = filmed_;
        return state;
    }

    void play(bool on) override {
        tick();
        if (on && clock_ >= times_.back())
            clock_ = times_.front(); // once more
        playing_ = on;
    }
    void step(std::int64_t count) override {
        playing_ = false;
        const auto last = static_cast<std::int64_t>(times_.size()) - 1;
        const auto frame = std::clamp(static_cast<std::int64_t>(frame_at(clock_)) + count, std::int64_t{0}, last);
        clock_ = times_[static_cast<std::size_t>(frame)];
    }
    void set_speed(double speed) override {
        tick();
        if (speed > 0)
            speed_ = speed;
    }
    void seek(double time) override {
        tick();
        clock_ = std::clamp(time, times_.front(), times_.back());
    }

    void film(const FilmLook& look, const std::filesystem::path& file) override {
        {
            const std::lock_guard lock(mutex_);
            if (filming_)
                return;
            filming_ = true;
        }
        stop_film_ = false;
        try {
            thread_ = std::jthread([this, look, file] { make_film(look, file); });
        } catch (const std::exception& error) { // the system refuses a thread
            tell_of_film(problem_of(error).what);
        }
    }
    void film_no_more() override { stop_film_ = true; }

private:
    void tick() {
        const Clock::time_point now = Clock::now();
        const double passed = std::chrono::duration<double>(now - std::exchange(ticked_, now)).count();
        if (!playing_)
            return;
        clock_ = std::min(clock_ + speed_ * passed, times_.back());
        playing_ = clock_ < times_.back();
    }

    /// Nearest in time.
    [[nodiscard]] std::size_t frame_at(double time) const {
        const auto after = std::lower_bound(times_.begin(), times_.end(), time);
        const auto index = static_cast<std::size_t>(after - times_.begin());
        if (index == 0 || index == times_.size())
            return std::min(index, times_.size() - 1);
        return time - times_[index - 1] <= times_[index] - time ? index - 1 : index;
    }

    void make_film(const FilmLook& look, const std::filesystem::path& file) {
        try {
            tell_of_film(redraw(look, file));
            news_();
        } catch (const std::exception& error) {
            tell_of_film(problem_of(error).what);
        }
    }

    /// A sentence about what has become of it.
    std::string redraw(const FilmLook& look, const std::filesystem::path& file) const {
        run::RedrawOptions options = words_;
        options.settings = look.settings;
        options.held = look.held;
        options.targets.video = file;
        options.when.stop = &stop_film_;
        options.when.duration = times_.back();
        const auto done = run::redraw(folder_, options, [](std::int64_t, std::int64_t) {});
        const Problems problems = done ? done->reason : done.problems();
        return problems.empty() ? fmt::format("{} with {} pictures", file.string(), done->frames)
                                : to_string(problems.front());
    }

    void tell_of_film(std::string sentence) {
        const std::lock_guard lock(mutex_);
        filming_ = false;
        filmed_ = std::move(sentence);
    }

    std::filesystem::path folder_;
    run::Recording recording_;
    std::vector<double> times_; // s, of its frames
    run::RedrawOptions words_;  // title and walls as they were asked for
    bool has_contacts_;         // in its frames
    double speed_;              // s of the run per s
    std::function<void()> news_;
    double clock_; // s of the run
    Clock::time_point ticked_ = Clock::now();
    bool playing_ = false;
    std::size_t shown_ = 0;
    MomentPtr moment_;
    std::uint64_t moments_ = 0;
    std::string trouble_;
    std::mutex mutex_; // of the two below
    bool filming_ = false;
    std::string filmed_;
    std::atomic<bool> stop_film_{false};
    std::jthread thread_;
};

} // namespace

Result<std::unique_ptr<Source>> open_recorded(const std::filesystem::path& folder, const scene::Scene& scene,
                                              std::function<void()> news) {
    Result<run::Recording> recording = run::open_recording(folder, {});
    if (!recording)
        return recording.problems();
    if (const auto found = run::check_trails({&*recording, 1}, scene.render.marks.trails); !found)
        return found.problems();
    run::RedrawOptions words; // of the film, and of what is seen
    words.settings = scene.render;
    words.title = scene.title;
    for (const scene::Wall& wall : scene.walls)
        words.wall_opacity.push_back(wall.opacity);
    words.traced = run::traced_bodies(scene.observe.measures);
    recording->layout = run::restyled_layout(*recording->layout, words);
    std::vector<double> times;
    bool contacts = false;
    for (const run::RecordedFrame& frame : recording->frames) {
        times.push_back(frame.time);
        contacts = contacts || frame.contacts;
    }
    return std::unique_ptr<Source>(std::make_unique<RecordedSource>(folder, std::move(*recording), std::move(words),
                                                                    std::move(times), contacts, std::move(news)));
}

} // namespace tumble::view

#include "view/live_source.h"

#include "base/thrown.h"
#include "run/frame_queue.h"
#include "run/picture_sink.h"
#include "run/schedule.h"
#include "run/simulation.h"
#include "run/view_box.h"
#include "scene/to_toml.h"
#include "view/carry_on.h"
#include "view/film.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <fmt/format.h>
#include <mutex>
#include <thread>

namespace tumble::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double stretch_s = 0.02; // of wall time between two looks at what is wanted

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

class LiveSource final : public Source {
public:
    LiveSource(SceneText text, const scene::Scene& scene, run::SimulationPtr simulation, int threads,
               std::function<void()> news)
        : text_(std::move(text)), running_(scene), wanted_(scene), simulation_(std::move(simulation)),
          layout_(simulation_->layout()), bounds_(run::view_box(scene, *layout_)), threads_(threads),
          news_(std::move(news)), all_steps_(std::llround(scene.duration / scene.step())),
          can_change_(scene.solver != scene::Solver::box2d) {
        state_.last = scene.duration;
        publish();
        thread_ = std::jthread([this] { work(); });
    }
    LiveSource(const LiveSource&) = delete;
    LiveSource& operator=(const LiveSource&) = delete;
    ~LiveSource() override {
        {
            const std::lock_guard lock(mutex_);
            orders_.close = true;
        }
        changed_.notify_all();
        thread_.join();
    }

    [[nodiscard]] std::shared_ptr<const observe::FrameLayout> layout() const override { return layout_; }
    [[nodiscard]] Eigen::AlignedBox3d bounds() const override { return bounds_; }
    [[nodiscard]] bool can_seek() const override { return false; }
    [[nodiscard]] bool can_change() const override { return can_change_; }
    [[nodiscard]] bool can_show_contacts() const override { return true; }

    [[nodiscard]] Result<Stretch> find(double from, double to) override {
        const double end = state().last;
        if (to < 0 || from > end)
            return Problem{.file = text_.file.string(),
                           .what = "this scene has nothing in the time asked for",
                           .fix = fmt::format("it goes from 0 to {:.6g} s", end)};
        return Stretch{std::max(from, 0.0), std::min(to, end)};
    }

    MomentPtr newest() override {
        const std::lock_guard lock(mutex_);
        orders_.look = true;
        return newest_;
    }
    [[nodiscard]] SourceState state() override {
        const std::lock_guard lock(mutex_);
        SourceState state = state_;
        state.playing = orders_.play;
        if (!state.playing) // at once, for the panel says it
            state.pace = state.steps_per_s = 0;
        state.speed = orders_.speed;
        state.filming = (state.filming || orders_.film) && !orders_.film_ends;
        return state;
    }
    void play(bool on) override {
        order([&] { orders_.play = on && !state_.ended; });
    }
    void step(std::int64_t count) override {
        order([&] {
            orders_.play = false;
            orders_.steps += state_.ended ? 0 : std::max<std::int64_t>(count, 0);
        });
    }
    void set_speed(double speed) override {
        order([&] { orders_.speed = std::max(speed, 0.0); });
    }
    void change(std::vector<scene::Override> changes) override {
        order([&] { orders_.changes = std::move(changes); });
    }
    void show_contacts(bool on) override {
        order([&] {
            orders_.look_again = orders_.look_again || on != orders_.contacts;
            orders_.contacts = on;
        });
    }
    void film(const FilmLook& look, const std::filesystem::path& file) override {
        order([&] {
            orders_.film = {look, file};
            orders_.film_ends = false; // whatever is filmed now ends with this
        });
    }
    void restyle_film(const FilmLook& look) override {
        order([&] { orders_.film_look = look; });
    }
    void film_no_more() override {
        order([&] { orders_.film_ends = true; });
    }

private:
    struct Orders {
        bool close = false;
        bool play = false;
        bool look = false; // the newest moment was taken
        bool contacts = false;
        bool look_again = false; // something else is to be seen of the same state
        std::int64_t steps = 0;
        double speed = 0;
        std::optional<std::vector<scene::Override>> changes;
        std::optional<std::pair<FilmLook, std::filesystem::path>> film;
        std::optional<FilmLook> film_look;
        bool film_ends = false;

        [[nodiscard]] bool any() const {
            return close || play || steps > 0 || changes || film || film_ends || look_again;
        }
    };

    template <class Change> void order(Change change) {
        {
            const std::lock_guard lock(mutex_);
            change();
        }
        changed_.notify_all();
    }

    void work() {
        while (true) {
            Orders now;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return orders_.any(); });
                now = orders_;
                state_.filming = state_.filming || orders_.film; // opening it takes a while
                orders_.changes.reset();
                orders_.film.reset();
                orders_.film_look.reset();
                orders_.film_ends = false;
                orders_.look_again = false;
            }
            if (now.close)
                break;
            try {
                obey(now);
            } catch (const std::exception& error) {
                halt(problem_of(error).what);
            }
        }
        try {
            end_film();
        } catch (const std::exception& error) {
            tell_of_film(problem_of(error).what);
        }
    }

    void obey(const Orders& now) {
        contacts_ = now.contacts;
        if (now.film)
            begin_film(now.film->first, now.film->second);
        if (film_ && now.film_look)
            film_->restyle(*now.film_look);
        if (now.film_ends)
            end_film();
        if (now.changes && !dead_)
            take_changes(*now.changes);
        const std::int64_t wanted = now.play ? stretch(now.speed) : std::min(now.steps, stretch(0));
        const std::int64_t before = simulation_->steps();
        const std::int64_t steps =
            dead_ ? 0 : std::min({wanted, all_steps_ - before, to_next_change(), to_next_shot()});
        if (steps > 0)
            advance(steps);
        settle(now, simulation_->steps() - before);
        if (now.play && now.speed > 0)
            keep_pace(now.speed);
    }

    void advance(std::int64_t steps) {
        const std::int64_t before = simulation_->steps();
        const Clock::time_point begun = Clock::now();
        const std::optional<Problem> problem = simulation_->advance(steps);
        const double seconds = seconds_since(begun);
        const std::int64_t done = simulation_->steps() - before;
        if (seconds > 0 && done > 0) {
            rate_ = static_cast<double>(done) / seconds;
            stretch_ = std::clamp(static_cast<std::int64_t>(stretch_s * rate_), std::int64_t{1}, 4 * stretch_);
        }
        if (problem)
            return halt(to_string(*problem));
        if (next_change_ && simulation_->time() >= *next_change_ - 0.25 * running_.step())
            adopt();
        if (film_ && film_->due(simulation_->steps()))
            shoot();
    }

    /// Steps until the clock is looked at again; with a speed that is wanted no more than that takes.
    [[nodiscard]] std::int64_t stretch(double speed) const {
        if (speed <= 0)
            return stretch_;
        const double due = std::ceil(speed * stretch_s / running_.step()); // may be more than a whole number holds
        return due < static_cast<double>(stretch_) ? std::max(static_cast<std::int64_t>(due), std::int64_t{1})
                                                   : stretch_;
    }

    [[nodiscard]] std::int64_t to_next_change() const {
        if (!next_change_)
            return all_steps_;
        const double steps = std::ceil((*next_change_ - simulation_->time()) / running_.step() - 1e-6);
        return std::max(static_cast<std::int64_t>(steps), std::int64_t{1});
    }

    [[nodiscard]] std::int64_t to_next_shot() const {
        return film_ ? std::max(film_->next() - simulation_->steps(), std::int64_t{1}) : all_steps_;
    }

    /// What the steps done change of the orders, and what others may see of it.
    void settle(const Orders& obeyed, std::int64_t done) {
        bool idle = false;
        bool look = false;
        {
            const std::lock_guard lock(mutex_);
            state_.ended = simulation_->steps() >= all_steps_ || dead_;
            if (!obeyed.play)
                orders_.steps = std::max(orders_.steps - done, std::int64_t{0});
            if (state_.ended) {
                orders_.play = false;
                orders_.steps = 0;
            }
            state_.change_waits = next_change_.has_value();
            state_.filming = film_ != nullptr;
            note_pace(obeyed);
            idle = !orders_.play && orders_.steps == 0;
            look = orders_.look;
        }
        if (look || idle)
            publish();
        else if (obeyed.changes || obeyed.film || obeyed.film_ends)
            news_();
    }

    /// Time and steps simulated over the same wall time, about half a second of it; unknown while nothing plays.
    void note_pace(const Orders& obeyed) {
        const bool goes_on = obeyed.play && !state_.ended;
        const double passed = seconds_since(paced_);
        if (goes_on && pacing_ && passed <= 0.5)
            return;
        const bool known = goes_on && pacing_ && simulation_->steps() >= paced_step_;
        state_.pace = known ? (simulation_->time() - paced_from_) / passed : 0;
        state_.steps_per_s = known ? static_cast<double>(simulation_->steps() - paced_step_) / passed : 0;
        pacing_ = goes_on;
        paced_ = Clock::now();
        paced_from_ = simulation_->time();
        paced_step_ = simulation_->steps();
    }

    void publish() {
        auto moment = std::make_shared<Moment>();
        moment->frame = frame(contacts_);
        moment->books = simulation_->books();
        moment->number = ++moments_;
        {
            const std::lock_guard lock(mutex_);
            newest_ = std::move(moment);
            state_.time = simulation_->time();
            orders_.look = false;
        }
        news_();
    }

    observe::Frame frame(bool with_contacts) const {
        observe::Frame frame = simulation_->frame();
        frame.layout = layout_; // one for all, however often the simulation was begun anew
        if (with_contacts)
            frame.contacts = contacts();
        return frame;
    }

    std::vector<observe::FrameContact> contacts() const {
        return kept_contacts_ && kept_at_ == simulation_->steps() ? *kept_contacts_ : simulation_->contacts();
    }

    void halt(const std::string& reason) {
        dead_ = true;
        const std::lock_guard lock(mutex_);
        state_.trouble = "the simulation cannot go on: " + reason;
        state_.ended = true;
        orders_.play = false;
        orders_.steps = 0;
    }

    void take_changes(const std::vector<scene::Override>& changes) {
        const Result<scene::Scene> wanted = text_.load(changes);
        if (!wanted)
            return refuse(wanted.problems());
        wanted_ = *wanted;
        refuse({}); // whatever was refused before is wanted no more
        adopt();
    }

    /// Goes on from here with as much of what is wanted as can be taken up now.
    void adopt() {
        const CarriedOn next = carry_on(running_, wanted_, simulation_->time());
        next_change_ = next.next;
        if (scene::to_toml(next.scene) == scene::to_toml(running_))
            return;
        Result<run::SimulationPtr> changed = run::restore(next.scene, threads_, simulation_->state());
        if (!changed)
            return refuse(changed.problems());
        kept_contacts_ = contacts(); // a state has none: the next step finds them anew
        kept_at_ = simulation_->steps();
        running_ = next.scene;
        simulation_ = std::move(*changed);
        refuse({});
    }

    void refuse(const Problems& problems) {
        const std::lock_guard lock(mutex_);
        if (!dead_)
            state_.trouble = problems.empty() ? "" : "this change was not taken up: " + to_string(problems.front());
    }

    void begin_film(const FilmLook& look, const std::filesystem::path& file) {
        end_film();
        auto film = Film::open(look, layout_, file, bounds_, running_.step());
        if (!film) {
            tell_of_film(to_string(film.problems().front()));
            return;
        }
        film_ = std::move(*film);
        shoot(); // what is seen as it begins
    }

    void shoot() {
        if (!film_->shoot(simulation_->steps(), frame(film_->shows_contacts())))
            end_film();
    }

    void end_film() {
        if (!film_)
            return;
        tell_of_film(film_->close());
        film_.reset();
    }

    void tell_of_film(const std::string& sentence) {
        const std::lock_guard lock(mutex_);
        state_.filmed = sentence;
    }

    /// Waits until the wall's clock has come as far as the scene's, or something else is wanted.
    void keep_pace(double speed) {
        if (speed != paced_speed_ || seconds_since(pace_begun_) > 5) {
            paced_speed_ = speed;
            pace_begun_ = Clock::now();
            pace_from_ = simulation_->time();
            return;
        }
        const double ahead = (simulation_->time() - pace_from_) / speed - seconds_since(pace_begun_);
        if (ahead < -0.5) { // cannot keep up: no rush later to make good for it
            paced_speed_ = 0;
            return;
        }
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, std::chrono::duration<double>(std::clamp(ahead, 0.0, 1.0)), [&] {
            return orders_.close || !orders_.play || orders_.speed != speed || orders_.changes || orders_.film ||
                   orders_.film_ends || orders_.look_again;
        });
    }

    SceneText text_;
    scene::Scene running_; // that the simulation has
    scene::Scene wanted_;
    run::SimulationPtr simulation_;
    std::shared_ptr<const observe::FrameLayout> layout_;
    Eigen::AlignedBox3d bounds_;
    int threads_;
    std::function<void()> news_;
    std::int64_t all_steps_;
    bool can_change_;
    bool dead_ = false;
    bool contacts_ = false;                                           // are wanted in moments
    std::optional<std::vector<observe::FrameContact>> kept_contacts_; // of a state that was changed
    std::int64_t kept_at_ = 0;                                        // step of that state
    std::optional<double> next_change_;                               // s
    std::int64_t stretch_ = 1;
    double rate_ = 0; // steps per s of wall time
    std::uint64_t moments_ = 0;
    std::unique_ptr<Film> film_;
    Clock::time_point paced_ = Clock::now(); // when the pace was last looked at
    double paced_from_ = 0;                  // s, of the scene then
    std::int64_t paced_step_ = 0;            // and the steps
    bool pacing_ = false;                    // it was playing then
    double paced_speed_ = 0;                 // that is being kept
    Clock::time_point pace_begun_ = Clock::now();
    double pace_from_ = 0; // s, of the scene then

    std::mutex mutex_; // of all below
    std::condition_variable changed_;
    Orders orders_;
    SourceState state_;
    MomentPtr newest_;
    std::jthread thread_;
};

} // namespace

Result<std::unique_ptr<Source>> open_live(const SceneText& text, const scene::Scene& scene, int threads,
                                          std::function<void()> news) {
    Result<run::SimulationPtr> simulation = run::simulate(scene, threads);
    if (!simulation)
        return simulation.problems();
    return std::unique_ptr<Source>(
        std::make_unique<LiveSource>(text, scene, std::move(*simulation), threads, std::move(news)));
}

} // namespace tumble::view

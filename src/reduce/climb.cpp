#include "reduce/climb.h"

#include "reduce/given_run.h"
#include "reduce/kept_run.h"
#include "run/scene_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <numeric>

namespace tumble::reduce {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string first_of(const Problems& problems) {
    return problems.empty() ? "" : problems.front().what;
}

class Climber {
public:
    Climber(std::vector<Rung> ladder, const Yardstick& stick, const ClimbOptions& options, ClimbListener& listener)
        : options_(options), listener_(listener), result_{stick, {}} {
        for (Rung& rung : ladder)
            result_.rungs.push_back({std::move(rung), Standing::waiting, "", 0, 0, 0, {}});
    }

    Result<Climb> climb() {
        if (const auto problem = unfit_reference(options_.references, result_.rungs.front().rung.scene, result_.stick))
            return *problem;
        for (Climbed& rung : result_.rungs)
            weigh(rung);
        if (const Result<Done> taken = take_references(); !taken)
            return taken.problems();
        std::vector<Climbed*> order;
        for (Climbed& rung : result_.rungs)
            if (rung.standing == Standing::waiting)
                order.push_back(&rung);
        std::stable_sort(order.begin(), order.end(),
                         [](const Climbed* a, const Climbed* b) { return a->work < b->work; });
        result_.all = static_cast<int>(order.size()) * options_.seeds;
        for (Climbed* rung : order) {
            if (const Result<Done> done = climb_to(*rung); !done)
                return done.problems();
            if (result_.stopped)
                break;
        }
        return std::move(result_);
    }

private:
    /// What a run of it takes, as far as that can be told before it.
    void weigh(Climbed& rung) const {
        const auto check =
            run::check_scene(prepared(rung, 0), options_.threads, [&](auto... told) { listener_.prepares(told...); });
        if (!check) {
            rung.standing = Standing::refused;
            rung.reason = first_of(check.problems());
            return;
        }
        rung.mass = check->mass;
        rung.bodies = static_cast<double>(check->wanted);
        rung.work = check->body_steps * static_cast<double>(check->parts) / std::max(1.0, rung.bodies);
    }

    Result<Done> take_references() {
        Climbed& whole = result_.rungs.front();
        for (const std::filesystem::path& folder : options_.references) {
            const auto given = read_given(folder, whole.rung.scene, result_.stick, whole.mass);
            if (!given)
                return given.problems();
            whole.runs.push_back(*given);
            whole.standing = Standing::finished;
        }
        return Done{};
    }

    [[nodiscard]] scene::Scene prepared(const Climbed& rung, int nth) const {
        scene::Scene scene = rung.rung.scene;
        result_.stick.prepare(scene);
        scene.seed += static_cast<std::uint64_t>(nth);
        return scene;
    }

    /// All seeds of a rung, as long as nothing keeps it from being of use.
    Result<Done> climb_to(Climbed& rung) {
        for (int nth = 0; nth < options_.seeds; ++nth) {
            const scene::Scene scene = prepared(rung, nth);
            const Result<std::string> name = name_of_run(rung.rung.name, scene);
            if (!name)
                return name.problems();
            const std::filesystem::path folder = options_.folder / "runs" / *name;
            const std::filesystem::path file = folder.string() + ".json";
            std::optional<KeptRun> kept = read_kept(file);
            if (!kept && beyond_budget(rung, options_.seeds - nth)) {
                result_.all -= options_.seeds - nth;
                return Done{};
            }
            listener_.begins(rung.rung.name, scene.seed, result_.made + 1, result_.all, kept.has_value());
            if (!kept) {
                const Result<bool> ended = perform(scene, folder, kept.emplace());
                if (!ended)
                    return ended.problems();
                if (!*ended)
                    return Done{};
                if (const Result<Done> written = write_kept(file, *kept); !written)
                    return written;
            }
            ++result_.made;
            pace_ = kept->core_s / rung.work;
            if (!kept->failure.empty()) {
                result_.all -= options_.seeds - nth - 1;
                rung.standing = Standing::failed;
                rung.reason = fmt::format("seed {}: {}", scene.seed, kept->failure);
                return Done{};
            }
            auto values = result_.stick.read(folder, rung.mass);
            if (!values)
                return values.problems();
            rung.runs.push_back({scene.seed, kept->core_s, kept->overlap, std::move(*values), std::move(kept->doubts)});
        }
        rung.standing = Standing::finished;
        return Done{};
    }

    /// By the pace of the last run, which was the one most like it. The first is made in any case.
    bool beyond_budget(Climbed& rung, int runs) const {
        const double takes = pace_ * rung.work * runs / options_.threads;
        if (pace_ == 0 || takes <= options_.budget - since(begun_))
            return false;
        rung.standing = Standing::left_out;
        rung.reason = fmt::format("would take about {:.2g} s more, which is beyond the budget", takes);
        return true;
    }

    /// False when it was stopped. Problems: what it failed by lies outside of the scene.
    Result<bool> perform(const scene::Scene& scene, const std::filesystem::path& folder, KeptRun& kept) {
        run::RunOptions options;
        options.folder = folder;
        options.threads = options_.threads;
        options.resume = true;
        options.stop = options_.stop;
        const Result<run::RunSummary> summary = run::run_scene(scene, options, listener_);
        if (stop_wanted(options_.stop) && (!summary || summary->state == "stopped")) {
            result_.stopped = true;
            return false;
        }
        if (!summary)
            return summary.problems();
        if (summary->state == "failed" && !summary->own_fault) // a full disk: the same command goes on once it is not
            return summary->reason;
        kept.core_s = summary->processor_s;
        kept.overlap = summary->overlap_ratio_max;
        kept.doubts = summary->warnings;
        if (summary->state == "failed")
            kept.failure = first_of(summary->reason);
        else if (!summary->unfilled.empty())
            kept.failure = "not all bodies found room: " + summary->unfilled.front();
        return true;
    }

    ClimbOptions options_;
    ClimbListener& listener_;
    Climb result_;
    Clock::time_point begun_ = Clock::now();
    double pace_ = 0; // s of processor time per sphere-step
};

} // namespace

double Climbed::core_s() const {
    double sum = 0;
    for (const Seeded& run : runs)
        sum += run.core_s;
    return sum / static_cast<double>(runs.size());
}

double Climbed::overlap() const {
    double most = 0;
    for (const Seeded& run : runs)
        most = std::max(most, run.overlap);
    return most;
}

Result<Climb> climb(std::vector<Rung> ladder, const Yardstick& stick, const ClimbOptions& options,
                    ClimbListener& listener) {
    return Climber(std::move(ladder), stick, options, listener).climb();
}

} // namespace tumble::reduce

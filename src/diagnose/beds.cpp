#include "diagnose/beds.h"

#include "base/hash.h"
#include "base/text.h"
#include "diagnose/bed_number.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

/// What most beds can be measured by; kept of every run, so that the table can tell what would be worth measuring.
constexpr const char* worth_measuring[] = {
    "circulation",    "surface_slope",  "bulk_height",       "centre_of_mass_y",   "mean_speed",
    "rms_velocity_x", "rms_velocity_y", "contacts_per_body", "surface_slope_left", "surface_slope_right"};

std::vector<std::string> measures_for(const std::vector<Bulk>& conditions) {
    std::vector<std::string> all;
    const auto add = [&](const std::string& measure) {
        if (std::find(all.begin(), all.end(), measure) == all.end())
            all.push_back(measure);
    };
    for (const Bulk& bulk : conditions)
        for (const BulkNumber& number : bulk.numbers)
            add(number.measure);
    for (const char* measure : worth_measuring)
        add(measure);
    std::sort(all.begin(), all.end());
    return all;
}

std::string label_of(const Pushes& pushes) {
    std::string label;
    for (const Push& push : pushes)
        label += (label.empty() ? "" : " ") + push.cause->id;
    return label;
}

bool broke_down(const BedRun& run) {
    return std::all_of(run.means.begin(), run.means.end(), [](const auto& mean) { return std::isnan(mean.second); });
}

std::string amplitudes_of(const Pushes& pushes) {
    std::string amplitudes;
    for (const Push& push : pushes)
        amplitudes += (amplitudes.empty() ? "" : " ") + shortest(push.amplitude);
    return amplitudes.empty() ? "0" : amplitudes;
}

} // namespace

Result<Beds> Beds::make(SceneText scene, std::vector<Bulk> conditions, Simulate simulate, BedOptions options) {
    Beds beds;
    beds.text_ = std::move(scene);
    beds.simulate_ = std::move(simulate);
    beds.options_ = std::move(options);
    beds.measures_ = measures_for(conditions);
    for (const std::string& name : beds.measures_) {
        auto head = head_of(bed_number_named(name));
        if (!head)
            return head.problems();
        beds.columns_.push_back(std::move(*head));
    }
    for (Bulk& bulk : conditions)
        if (const auto added = beds.add(std::move(bulk)); !added)
            return added.problems();
    auto table = ResponseTable::open(beds.options_.table, beds.columns_);
    if (!table)
        return table.problems();
    beds.table_ = std::move(*table);
    return beds;
}

Result<int> Beds::add(Bulk condition) {
    std::vector<scene::Override> sets = text_.sets;
    for (const std::string& set : condition.sets)
        sets.push_back({set});
    auto resolved = scene::load_scene_text(text_.toml, text_.file, sets);
    if (!resolved)
        return resolved.problems();
    if (condition.change)
        condition.change(*resolved);
    scene::Stretch stretch = scene::settled(*resolved);
    stretch = {condition.from.value_or(stretch.from), condition.until.value_or(stretch.until)};
    if (!(stretch.until - stretch.from >= 2 * resolved->observe.every))
        return Problem{.key = "bulk.from_s",
                       .what = fmt::format("{}: from {:.4g} to {:.4g} s there are fewer than two rows to average",
                                           condition.condition, stretch.from, stretch.until),
                       .fix = "let from_s and until_s be further apart, or make observe.every_s of the scene smaller"};
    resolved->duration = stretch.until;
    std::set<std::string> observed;
    for (const std::string& name : measures_)
        observed.insert(observed_for(bed_number_named(name)));
    resolved->observe.measures.assign(observed.begin(), observed.end());
    // Words and pictures do not date a run.
    resolved->title = resolved->claim = "";
    resolved->render = {};
    conditions_.push_back(std::move(condition));
    scenes_.push_back(std::move(*resolved));
    stretches_.push_back(stretch);
    return static_cast<int>(scenes_.size()) - 1;
}

scene::Scene Beds::scene_of(int condition, const Pushes& pushes, std::uint64_t seed) const {
    scene::Scene scene = scenes_[static_cast<std::size_t>(condition)];
    for (const Push& push : pushes)
        if (push.amplitude != 0)
            push.cause->extend(scene, push.amplitude);
    scene.seed += seed;
    return scene;
}

BedRun Beds::plan(int condition, const Pushes& pushes, std::uint64_t seed) const {
    scene::Scene scene = scene_of(condition, pushes, seed);
    scene.observe.measures.clear(); // what else is looked at does not change what is seen
    const scene::Stretch now = stretch(condition);
    Hash64 hash;
    hash.add(scene::to_toml(scene)).add(now.from).add(now.until).add(options_.version);
    Hash64 words; // of the scene as it is written: what programs make of it may differ
    const Bulk& bulk = conditions_[static_cast<std::size_t>(condition)];
    words.add(text_.toml).add(now.from).add(now.until);
    for (const scene::Override& set : text_.sets)
        words.add(set.text).add("\n");
    for (const std::string& set : bulk.sets)
        words.add(set).add("\n");
    return {.run = hash.hex(),
            .condition = bulk.condition,
            .cause = label_of(pushes),
            .amplitude = amplitudes_of(pushes),
            .seed = scene.seed,
            .from = now.from,
            .until = now.until,
            .scene = words.hex(),
            .means = {}};
}

const BedRun* Beds::kept(const BedRun& run) const {
    const BedRun* dated = table_.find(run.run);
    return dated || !options_.any_date ? dated : table_.find(run);
}

bool Beds::idle(int condition, const Pushes& pushes) const {
    return scene::to_toml(scene_of(condition, pushes, 0)) == scene::to_toml(scene_of(condition, {}, 0));
}

void Beds::charge(Budget& budget, int condition, const Pushes& pushes) const {
    for (int nth = 0; nth < options_.seeds; ++nth) {
        const BedRun run = plan(condition, pushes, static_cast<std::uint64_t>(nth));
        if (const BedRun* known = kept(run)) {
            ++budget.kept;
            if (broke_down(*known)) // the others are not run
                return;
            continue;
        }
        ++budget.runs;
        budget.simulated += run.until;
        double wall = 0, like = 0;
        for (const BedRun& old : table_.runs())
            if (old.condition == run.condition && old.wall > 0)
                wall += old.wall, like += old.until;
        budget.wall += like > 0 ? wall * run.until / like : 0;
    }
}

void Beds::note_means(BedRun& run, const Result<observe::Series>& series, const scene::Scene& scene) {
    if (!series)
        failure_ = series.problems();
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const BedNumberName name = bed_number_named(measures_[c]);
        const auto* values = series ? series->find(name.measure) : nullptr;
        run.means[columns_[c]] =
            values ? number_over(name.take, series->values[0], *values, run.from, run.until, scene.observe.every)
                   : std::nan("");
    }
    ++runs_;
    simulated_ += scene.duration;
}

Result<Done> Beds::perform(std::vector<BedRun*>& missing, int condition, const Pushes& pushes) {
    std::vector<scene::Scene> scenes;
    for (const BedRun* run : missing) {
        scenes.push_back(scene_of(condition, pushes, 0));
        scenes.back().seed = run->seed;
    }
    const auto begun = std::chrono::steady_clock::now();
    const auto all = simulate_.all(scenes);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    for (std::size_t k = 0; k < missing.size(); ++k) {
        missing[k]->wall = taken.count() / static_cast<double>(missing.size());
        note_means(*missing[k], all[k], scenes[k]);
        if (const auto written = table_.add(*missing[k]); !written)
            return written.problems();
    }
    missing.clear();
    return Done{};
}

Result<Ensemble> Beds::ensemble(int condition, const Pushes& pushes, std::uint64_t later_seeds) {
    Ensemble all(options_.seeds, static_cast<Eigen::Index>(columns_.size()));
    for (int first = 0; first < options_.seeds; first += simulate_.threads()) { // those are lost with a killed program
        std::vector<BedRun> runs;
        for (int nth = first; nth < std::min(options_.seeds, first + simulate_.threads()); ++nth)
            runs.push_back(plan(condition, pushes, later_seeds + static_cast<std::uint64_t>(nth)));
        std::vector<BedRun*> missing;
        for (BedRun& run : runs) {
            if (const BedRun* known = kept(run)) {
                if (known->run != run.run)
                    old_.insert(known->run);
                run = *known;
            } else {
                left_aside_ += options_.any_date && table_.has_of_another_scene(run) ? 1 : 0;
                missing.push_back(&run);
            }
        }
        if (const auto done = perform(missing, condition, pushes); !done)
            return done.problems();
        for (std::size_t k = 0; k < runs.size(); ++k) {
            for (std::size_t c = 0; c < columns_.size(); ++c)
                all(first + static_cast<int>(k), static_cast<Eigen::Index>(c)) = runs[k].means.at(columns_[c]);
            if (broke_down(runs[k])) // others would, too
                return Ensemble(Ensemble::Constant(1, all.cols(), std::nan("")));
        }
    }
    return all;
}

int Beds::column_of(const std::string& measure) const {
    return static_cast<int>(std::find(measures_.begin(), measures_.end(), measure) - measures_.begin());
}

scene::Stretch Beds::stretch(int condition) const {
    return stretches_[static_cast<std::size_t>(condition)];
}

} // namespace tumble::diagnose

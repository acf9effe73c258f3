#include "diagnose/model.h"

#include "base/text.h"
#include "diagnose/taken.h"
#include "observe/tracer.h"
#include "scene/load.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::diagnose {

namespace {

constexpr double rows_per_reading = 8;        // of a run, between two readings: kinks are resolved well below a reading
constexpr double steps_of_a_number = 100;     // of a run of which one number is taken, in place of readings
constexpr std::size_t most_remembered = 2000; // runs, some 40 kB each
constexpr double room_for_clocks = 0.03;      // s of a run beyond the last reading

/// Parts of an instrument by the names that a measurement uses.
double& part(Instrument& instrument, const std::string& name) {
    return name == "clock_offset" ? instrument.clock_offset
           : name == "gain"       ? instrument.gain
           : name == "bias"       ? instrument.bias
                                  : instrument.drift;
}

/// How far a part of the instrument may be taken, and a step that most records would just show; a key of the scene
/// learns both from where the scene has it. `record`: the only one it acts on.
Parameter nuisance_parameter(const Nuisance& nuisance, const Record* record, int index) {
    const std::string whose = (nuisance.sensor.empty() ? "" : " of " + nuisance.sensor) +
                              (record ? fmt::format(" of '{}'", record->name) : "");
    if (nuisance.instrument.empty())
        return {.name = nuisance.key + whose, .spread = nuisance.spread, .record = index};
    const bool clock = nuisance.instrument == "clock_offset";
    const double width = nuisance.spread > 0 ? 20 * nuisance.spread : clock ? 0.2 : 1;
    return {.name = nuisance.instrument + whose,
            .lo = -width,
            .hi = width,
            .spread = nuisance.spread,
            .step = clock ? 1e-4 : 1e-3,
            .record = index,
            .exact = true};
}

/// The first row that has one: a mean since the row before is none in the first.
std::size_t first_number_in(const std::vector<double>& values) {
    return static_cast<std::size_t>(
        std::find_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); }) - values.begin());
}

double middle_step(const Record& record) {
    return record.single() ? record.time.back() / steps_of_a_number
                           : (record.time.back() - record.time.front()) / static_cast<double>(record.time.size() - 1);
}

} // namespace

Result<Model> Model::make(SceneText scene, std::vector<Record> records, const std::vector<Nuisance>& nuisances,
                          std::vector<Cause> causes, Simulate simulate) {
    Model model;
    model.text_ = std::move(scene);
    model.records_ = std::move(records);
    model.causes_ = std::move(causes);
    model.simulate_ = std::move(simulate);
    std::vector<double> readings;
    for (std::size_t r = 0; r < model.records_.size(); ++r)
        for (std::size_t c = 0; c < model.records_[r].channels.size(); ++c)
            for (std::size_t k = 0; k < model.records_[r].time.size(); ++k) {
                model.rows_.push_back({static_cast<int>(r), static_cast<int>(c), model.records_[r].time[k]});
                readings.push_back(model.records_[r].channels[c].value[k]);
            }
    model.readings_ = Eigen::Map<VectorXd>(readings.data(), static_cast<Eigen::Index>(readings.size()));
    for (std::size_t n = 0; n < nuisances.size(); ++n) {
        const Nuisance& nuisance = nuisances[n];
        const std::size_t copies = nuisance.per_record ? model.records_.size() : 1;
        for (std::size_t r = 0; r < copies; ++r) {
            model.nuisance_of_.push_back(nuisance);
            model.parameters_.push_back(nuisance_parameter(nuisance, nuisance.per_record ? &model.records_[r] : nullptr,
                                                           nuisance.per_record ? static_cast<int>(r) : -1));
            model.parameters_.back().nuisance = static_cast<int>(n);
        }
    }
    if (const auto done = model.find_starts(); !done)
        return done.problems();
    for (const Cause& cause : model.causes_)
        model.parameters_.push_back({.name = cause.id,
                                     .lo = cause.lo,
                                     .hi = cause.hi,
                                     .step = cause.typical,
                                     .exact = !cause.physical() && cause.lo < 0});
    return model;
}

/// Nuisances of the scene begin where the scene has them: read back from the text that a set would change.
Result<Done> Model::find_starts() {
    for (std::size_t k = 0; k < nuisance_of_.size(); ++k) {
        const Nuisance& nuisance = nuisance_of_[k];
        if (nuisance.key.empty())
            continue;
        Parameter& parameter = parameters_[k];
        const Result<double> value =
            scene::number_in(text_.toml, text_.file, written_sets(parameter.record), nuisance.key);
        if (!value) {
            Problems problems = value.problems();
            for (Problem& problem : problems)
                problem = scene::problem_at(nuisance.place, problem.key,
                                            fmt::format("nuisance '{}': {}", nuisance.key, problem.what), problem.fix);
            return problems;
        }
        parameter.start = *value;
        const double width = nuisance.spread > 0 ? 20 * nuisance.spread : std::max(1.0, 10 * std::abs(*value));
        parameter.lo = *value - width;
        parameter.hi = *value + width;
        parameter.step = nuisance.spread > 0 ? 0.05 * nuisance.spread : std::max(1e-6, 1e-3 * std::abs(*value));
    }
    return Done{};
}

VectorXd Model::start() const {
    VectorXd values(static_cast<Eigen::Index>(parameters_.size()));
    for (std::size_t k = 0; k < parameters_.size(); ++k)
        values[static_cast<Eigen::Index>(k)] = parameters_[k].start;
    return values;
}

std::vector<scene::Override> Model::written_sets(int record) const {
    std::vector<scene::Override> sets = text_.sets;
    if (record >= 0)
        for (const std::string& set : records_[static_cast<std::size_t>(record)].sets)
            sets.push_back({set});
    return sets;
}

std::vector<scene::Override> Model::sets_at(const VectorXd& values, int record) const {
    std::vector<scene::Override> sets = written_sets(record);
    for (std::size_t k = 0; k < nuisance_of_.size(); ++k)
        if (!nuisance_of_[k].key.empty() && (parameters_[k].record == -1 || parameters_[k].record == record))
            sets.push_back({fmt::format("{}={}", nuisance_of_[k].key, values[static_cast<Eigen::Index>(k)])});
    return sets;
}

Result<scene::Scene> Model::scene_at(const VectorXd& values, int record) const {
    auto scene = scene::load_scene_text(text_.toml, text_.file, sets_at(values, record));
    if (!scene) {
        Problems problems = scene.problems();
        if (record >= 0 && !records_[static_cast<std::size_t>(record)].sets.empty())
            for (Problem& problem : problems)
                problem.what =
                    fmt::format("in '{}', with set {}: {}", records_[static_cast<std::size_t>(record)].name,
                                fmt::join(records_[static_cast<std::size_t>(record)].sets, " "), problem.what);
        return problems;
    }
    if (record >= 0 && records_[static_cast<std::size_t>(record)].change)
        records_[static_cast<std::size_t>(record)].change(*scene);
    for (std::size_t c = 0; c < causes_.size(); ++c)
        if (const double amplitude = values[parameter_of(static_cast<int>(c))]; amplitude != 0 && causes_[c].physical())
            causes_[c].extend(*scene, amplitude);
    return scene;
}

Instrument Model::instrument_at(const VectorXd& values, int record, const Channel& channel) const {
    Instrument instrument;
    const auto reads = [&](const std::string& sensor) { return sensor.empty() || sensor == channel.sensor; };
    for (std::size_t k = 0; k < nuisance_of_.size(); ++k)
        if (!nuisance_of_[k].instrument.empty() && reads(nuisance_of_[k].sensor) &&
            (parameters_[k].record == -1 || parameters_[k].record == record))
            part(instrument, nuisance_of_[k].instrument) += values[static_cast<Eigen::Index>(k)];
    for (std::size_t c = 0; c < causes_.size(); ++c)
        if (const double amplitude = values[parameter_of(static_cast<int>(c))];
            amplitude != 0 && !causes_[c].physical() && reads(causes_[c].sensor))
            causes_[c].distort(instrument, amplitude);
    return instrument;
}

std::string Model::key_of(const VectorXd& values, int record, double horizon) const {
    const Record& wanted = records_[static_cast<std::size_t>(record)];
    std::string key = fmt::format("{}|{}|", horizon * wanted.time.back(), wanted.change ? wanted.name : "");
    for (const scene::Override& set : sets_at(values, record))
        key += set.text + "|";
    for (std::size_t c = 0; c < causes_.size(); ++c)
        if (causes_[c].physical())
            key += fmt::format("{}|", values[parameter_of(static_cast<int>(c))]);
    return key;
}

Result<scene::Scene> Model::scene_to_run(const VectorXd& values, int record, double horizon) const {
    const Record& wanted = records_[static_cast<std::size_t>(record)];
    auto scene = scene_at(values, record);
    if (!scene)
        return scene.problems();
    scene->duration = horizon * wanted.time.back() + room_for_clocks;
    scene->observe.every = std::max(scene->time_step, middle_step(wanted) / rows_per_reading);
    scene->observe.measures.clear();
    for (const Record& other : records_) // every record of this experiment finds what it needs
        for (const Channel& channel : other.channels)
            if (other.sets == wanted.sets && !other.change == !wanted.change && !channel.shows_time()) {
                const auto traced = observe::traced_by(channel.measure);
                const std::string measure = traced ? "tracer:" + traced->body : channel.measure;
                auto& measures = scene->observe.measures;
                if (std::find(measures.begin(), measures.end(), measure) == measures.end())
                    measures.push_back(measure);
            }
    if (scene->observe.measures.empty())
        scene->observe.measures = {"kinetic_energy"};
    return scene;
}

void Model::make_room(std::size_t runs) {
    if (of_scene_.size() + runs <= most_remembered)
        return;
    of_scene_.clear();
    remembered_.clear();
}

void Model::run_ahead(const std::vector<VectorXd>& points, double horizon) {
    if (simulate_.threads() == 1)
        return;
    std::vector<scene::Scene> scenes;
    std::vector<std::string> texts;
    std::map<std::string, std::string> asked; // the text that a key comes to
    for (const VectorXd& values : points)
        for (int record = 0; record < static_cast<int>(records_.size()); ++record) {
            const std::string key = key_of(values, record, horizon);
            if (remembered_.count(key) > 0 || asked.count(key) > 0)
                continue;
            auto scene = scene_to_run(values, record, horizon);
            if (!scene) // predict() says why
                continue;
            const std::string text = asked[key] = scene::to_toml(*scene);
            if (of_scene_.count(text) > 0 || std::find(texts.begin(), texts.end(), text) != texts.end())
                continue;
            scenes.push_back(std::move(*scene));
            texts.push_back(text);
        }
    make_room(scenes.size());
    auto all = simulate_.all(scenes);
    for (std::size_t k = 0; k < scenes.size(); ++k)
        if (all[k])
            remember(texts[k], scenes[k], std::move(*all[k]));
    for (const auto& [key, text] : asked)
        if (const auto found = of_scene_.find(text); found != of_scene_.end())
            remembered_[key] = found->second;
}

const Model::Ran& Model::remember(const std::string& text, const scene::Scene& scene, observe::Series series) {
    simulated_ += scene.duration;
    ++runs_;
    return of_scene_[text] = std::make_shared<const observe::Series>(std::move(series));
}

Result<const observe::Series*> Model::run(const VectorXd& values, int record, double horizon) {
    const std::string key = key_of(values, record, horizon);
    if (const auto found = remembered_.find(key); found != remembered_.end())
        return found->second.get();
    auto scene = scene_to_run(values, record, horizon);
    if (!scene)
        return scene.problems();
    const std::string text = scene::to_toml(*scene);
    if (const auto found = of_scene_.find(text); found != of_scene_.end())
        return (remembered_[key] = found->second).get();
    auto series = simulate_(*scene);
    if (!series)
        return series.problems();
    make_room(1);
    return (remembered_[key] = remember(text, *scene, std::move(*series))).get();
}

Result<std::vector<Signal>> Model::signals(const VectorXd& values, int record, double horizon) {
    const auto series = run(values, record, horizon);
    if (!series)
        return series.problems();
    std::vector<Signal> all;
    for (const Channel& channel : records_[static_cast<std::size_t>(record)].channels) {
        const std::vector<double>* found =
            channel.shows_time() ? &(*series)->values[0] : (*series)->find(channel.measure);
        if (!found)
            return Problem{.key = channel.measure, .what = "the simulation does not give " + channel.measure};
        const std::size_t first = first_number_in(*found);
        if (first + 1 >= found->size())
            return Problem{.key = channel.measure,
                           .what = "the simulation gives no numbers for " + channel.measure,
                           .fix = "name a body that is there from the beginning"};
        const auto from = [&](const std::vector<double>& all_rows) {
            return std::vector<double>(all_rows.begin() + static_cast<std::ptrdiff_t>(first), all_rows.end());
        };
        all.push_back({from((*series)->values[0]), from(*found)});
    }
    return all;
}

Result<std::vector<std::vector<Signal>>> Model::all_signals(const VectorXd& values, double horizon) {
    run_ahead({values}, horizon);
    std::vector<std::vector<Signal>> truths;
    for (std::size_t r = 0; r < records_.size(); ++r) {
        auto truth = signals(values, static_cast<int>(r), horizon);
        if (!truth)
            return truth.problems();
        truths.push_back(std::move(*truth));
    }
    return truths;
}

Model::Ranges Model::ranges_of(const std::vector<std::vector<Signal>>& truths) const {
    Ranges ranges;
    for (std::size_t r = 0; r < records_.size(); ++r)
        for (std::size_t c = 0; c < truths[r].size(); ++c) {
            const Channel& channel = records_[r].channels[c];
            const Signal& signal = truths[r][c];
            double& most = ranges[{channel.measure, channel.sensor}];
            for (std::size_t k = 0; k < signal.time.size() && signal.time[k] <= records_[r].time.back(); ++k)
                most = std::max(most, std::abs(signal.value[k]));
        }
    for (const auto& [sensed, most] : ranges_)
        ranges[sensed] = most;
    return ranges;
}

Result<Model::Ranges> Model::ranges_at(const VectorXd& values) {
    const auto truths = all_signals(values, 1);
    if (!truths)
        return truths.problems();
    return ranges_of(*truths);
}

Result<VectorXd> Model::predict(const VectorXd& values, double horizon) {
    const auto signals_of_all = all_signals(values, horizon);
    if (!signals_of_all)
        return signals_of_all.problems();
    const std::vector<std::vector<Signal>>& truths = *signals_of_all;
    Ranges ranges = ranges_of(truths);
    VectorXd all(readings_.size());
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records_.size(); ++r) {
        for (std::size_t c = 0; c < records_[r].channels.size(); ++c) {
            const Channel& channel = records_[r].channels[c];
            const Instrument instrument = instrument_at(values, static_cast<int>(r), channel);
            const double most = ranges[{channel.measure, channel.sensor}];
            const auto seen =
                records_[r].single()
                    ? std::vector{number_taken(channel, records_[r].time[0], instrument, truths[r][c], most)}
                : channel.shows_time() ? clock_seen_through(instrument, records_[r].time)
                                       : seen_through(instrument, truths[r][c], records_[r].time, most);
            for (const double value : seen)
                all[row++] = value;
        }
    }
    if (!all.allFinite())
        return Problem{.what = "the simulation gives readings that are no numbers"};
    return all;
}

} // namespace tumble::diagnose

#include "diagnose/plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double enough = 5;           // standard errors
constexpr double worth_it = 1.05;      // times what doing the same once more gives
constexpr double clock_reading = 1e-3; // s, scatter of a clock read from a picture

struct Experiment {
    const char* id;
    const char* sentence;
    bool (*add)(std::vector<Record>&); // appends the new records or channels; false: they are there already
};

bool reads(const Record& record, const std::string& measure) {
    return std::any_of(record.channels.begin(), record.channels.end(),
                       [&](const Channel& channel) { return channel.measure == measure; });
}

/// A second set of the records, changed.
template <class Change> void add_copies(std::vector<Record>& records, const std::string& mark, Change change) {
    const std::size_t before = records.size();
    for (std::size_t k = 0; k < before; ++k) {
        Record copy = records[k];
        copy.name += mark;
        copy.condition += mark;
        change(copy);
        records.push_back(std::move(copy));
    }
}

void with_an_eighth_of_the_mass(scene::Scene& scene) {
    for (contact::Material& material : scene.materials)
        material.density /= 8;
    for (scene::BodyTemplate& body : scene.bodies) {
        if (body.mass)
            *body.mass /= 8;
        if (body.principal_inertia)
            *body.principal_inertia /= 8;
    }
}

bool add_light_body(std::vector<Record>& records) {
    add_copies(records, ", light body", [](Record& record) { record.change = with_an_eighth_of_the_mass; });
    return true;
}

bool add_clock(std::vector<Record>& records) {
    const auto has_none = [](const Record& record) { return !record.single() && !reads(record, "time"); };
    if (std::none_of(records.begin(), records.end(), has_none))
        return false;
    for (Record& record : records) {
        if (!has_none(record))
            continue;
        Channel clock{.head = "clock_s", .measure = "time", .unit = "s", .value = record.time, .sigma = clock_reading};
        clock.sensor = record.channels[0].sensor; // whose clock it holds against the truth
        record.channels.push_back(std::move(clock));
    }
    return true;
}

bool add_longer(std::vector<Record>& records) {
    if (std::any_of(records.begin(), records.end(), [](const Record& record) { return record.single(); }))
        return false; // such a number is of a stretch, whatever comes behind it
    add_copies(records, ", longer", [](Record& record) {
        const double step = record.time[1] - record.time[0];
        const std::size_t before = record.time.size();
        for (std::size_t k = 0; k < before; ++k)
            record.time.push_back(record.time.back() + step);
        for (Channel& channel : record.channels)
            channel.value.resize(record.time.size(), 0);
    });
    return true;
}

/// As well as a position that is read already.
bool add_sideways(std::vector<Record>& records) {
    bool added = false;
    for (Record& record : records) {
        const auto place = std::find_if(record.channels.begin(), record.channels.end(),
                                        [](const Channel& channel) { return channel.unit == "m"; });
        if (place == record.channels.end() || record.single())
            continue;
        const Channel known = *place;
        for (const char* measure : {"centre_of_mass_x", "centre_of_mass_z"}) {
            if (reads(record, measure))
                continue;
            Channel side = known;
            side.head = side.measure = measure;
            record.channels.push_back(std::move(side));
            added = true;
        }
    }
    return added;
}

bool add_repeats(std::vector<Record>& records) {
    add_copies(records, ", again", [](Record&) {});
    return true;
}

constexpr Experiment catalogue[] = {
    {"light", "do the same with a body of the same size and an eighth of the mass (hollow, or of foam)",
     add_light_body},
    {"clock", "put a clock into the picture (an LED that blinks at a known rate) and read it to a millisecond",
     add_clock},
    {"longer", "do the same and record for twice as long", add_longer},
    {"sideways", "read the sideways positions from the same records, too", add_sideways},
    {"again", "do the same once more", add_repeats},
};

/// Noise of the records there were, for records made from them.
Noise noise_for(const Model& model, const Noise& known) {
    Noise noise = first_noise(model);
    noise.of = known.of;
    const std::size_t before = known.sigma.size();
    for (std::size_t r = 0; r < noise.sigma.size(); ++r)
        for (std::size_t c = 0; c < noise.sigma[r].size(); ++c) {
            const auto& old = known.sigma[r % before];
            if (!model.records()[r].channels[c].shows_time())
                noise.sigma[r][c] = old[std::min(c, old.size() - 1)];
        }
    return noise;
}

/// Standard errors that the nearest two causes lie apart when all nuisances and the rival are adjusted.
Result<double> separation_in(Model& model, const Noise& noise, const VectorXd& values,
                             const std::vector<double>& amplitudes) {
    MatrixXd nuisances;
    for (int k = 0; k < model.nuisances(); ++k) {
        const auto slope = slope_of(model, noise, values, k, true);
        if (!slope)
            return slope.problems();
        nuisances.conservativeResize(slope->size(), k + 1);
        nuisances.col(k) = *slope;
    }
    std::vector<VectorXd> effects;
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
        const auto slope = slope_of(model, noise, values, model.parameter_of(static_cast<int>(k)), true);
        if (!slope)
            return slope.problems();
        effects.push_back(*slope * amplitudes[k]);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < effects.size(); ++i)
        for (std::size_t j = 0; j < effects.size(); ++j)
            if (i != j) {
                MatrixXd others(effects[j].size(), nuisances.cols() + 1);
                others << nuisances, effects[j];
                nearest = std::min(nearest, Projector(others).out(effects[i]).norm());
            }
    return nearest;
}

} // namespace

std::vector<int> rivals_in(const Decision& decision) {
    std::vector<int> rivals = decision.causes;
    if (rivals.size() != 1)
        return rivals;
    const MatrixXd& left = decision.isolability;
    const int named = rivals[0];
    int near = -1;
    for (int k = 0; k < left.cols(); ++k)
        if (k != named && !std::isnan(left(named, k)) && (near < 0 || left(named, k) < left(named, near)))
            near = k;
    if (near >= 0)
        rivals.push_back(near);
    return rivals;
}

int repeats_for(double separation) {
    const double needed = std::ceil(std::pow(enough / std::max(separation, 1e-9), 2));
    return needed > 1000 ? 0 : std::max(1, static_cast<int>(needed));
}

std::vector<Proposal> proposals_for(const SceneText& scene, const Model& model, const std::vector<Nuisance>& nuisances,
                                    const Noise& noise, const Simulate& simulate, const VectorXd& values,
                                    const std::vector<int>& causes, const std::vector<double>& amplitudes,
                                    Problems& warnings) {
    std::vector<Cause> rivals;
    for (const int k : causes)
        rivals.push_back(model.causes()[static_cast<std::size_t>(k)]);
    std::vector<Proposal> proposals;
    for (const Experiment& experiment : catalogue) {
        std::vector<Record> records = model.records();
        if (!experiment.add(records))
            continue;
        const auto cannot = [&](const Problems& why) {
            warnings.push_back({.file = scene.file.string(),
                                .key = "no such experiment",
                                .what = fmt::format("'{}' cannot be planned for this scene", experiment.sentence),
                                .fix = why.front().what});
        };
        auto planned = Model::make(scene, records, nuisances, rivals, simulate);
        if (!planned) {
            cannot(planned.problems());
            continue;
        }
        VectorXd at = planned->start();
        for (std::size_t k = 0; k < planned->parameters().size(); ++k)
            for (std::size_t i = 0; i < static_cast<std::size_t>(model.nuisances()); ++i)
                if (model.parameters()[i].name == planned->parameters()[k].name)
                    at[static_cast<Eigen::Index>(k)] = values[static_cast<Eigen::Index>(i)];
        const auto apart = separation_in(*planned, noise_for(*planned, noise), at, amplitudes);
        if (!apart) {
            cannot(apart.problems());
            continue;
        }
        proposals.push_back({experiment.id, experiment.sentence, *apart, repeats_for(*apart)});
    }
    std::sort(proposals.begin(), proposals.end(),
              [](const Proposal& a, const Proposal& b) { return a.separation > b.separation; });
    const auto again = std::find_if(proposals.begin(), proposals.end(),
                                    [](const Proposal& one) { return std::string(one.id) == "again"; });
    if (again != proposals.end()) { // what is no better than that is not worth another apparatus
        const double enough_better = worth_it * again->separation;
        std::stable_partition(proposals.begin(), proposals.end(), [&](const Proposal& one) {
            return std::string(one.id) == "again" || one.separation > enough_better;
        });
    }
    return proposals;
}

} // namespace tumble::diagnose

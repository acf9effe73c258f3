#include "diagnose/plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double adds_something = 1.02; // times what was there before
constexpr double least_worth = 0.1;     // standard errors apart
constexpr double most_repeats = 1000;   // that anybody would make
constexpr double clock_reading = 1e-3;  // s, scatter of a clock read from a picture

struct Experiment {
    const char* id;
    const char* sentence;
    bool (*add)(std::vector<Record>&); // appends the new records or channels; false: they are there already
    bool beside = true;                // records beside those there were; else more is read of those
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
     add_clock, false},
    {"longer", "do the same and record for twice as long", add_longer},
    {"sideways", "read the sideways positions from the same records, too", add_sideways, false},
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

/// Standard errors that the nearest two rivals, of the model's causes, lie apart when all nuisances and the other's
/// causes are adjusted.
Result<double> separation_in(Model& model, const Noise& noise, const VectorXd& values,
                             const std::vector<Rival>& rivals) {
    MatrixXd nuisances;
    for (int k = 0; k < model.nuisances(); ++k) {
        const auto slope = slope_of(model, noise, values, k, true);
        if (!slope)
            return slope.problems();
        nuisances.conservativeResize(slope->size(), k + 1);
        nuisances.col(k) = *slope;
    }
    std::vector<VectorXd> slopes; // of each cause
    for (std::size_t k = 0; k < model.causes().size(); ++k) {
        const auto slope = slope_of(model, noise, values, model.parameter_of(static_cast<int>(k)), true);
        if (!slope)
            return slope.problems();
        slopes.push_back(*slope);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const Rival& one : rivals) {
        VectorXd effect = VectorXd::Zero(slopes[0].size());
        for (std::size_t k = 0; k < one.causes.size(); ++k)
            effect += one.amplitudes[static_cast<Eigen::Index>(k)] * slopes[static_cast<std::size_t>(one.causes[k])];
        for (const Rival& other : rivals) {
            if (&other == &one)
                continue;
            MatrixXd adjusted = nuisances;
            adjusted.conservativeResize(effect.size(),
                                        nuisances.cols() + static_cast<Eigen::Index>(other.causes.size()));
            for (std::size_t k = 0; k < other.causes.size(); ++k)
                adjusted.col(nuisances.cols() + static_cast<Eigen::Index>(k)) =
                    slopes[static_cast<std::size_t>(other.causes[k])];
            nearest = std::min(nearest, Projector(adjusted).out(effect).norm());
        }
    }
    return nearest;
}

/// The same explanations, their causes numbered as in `list`, which gets those that it lacks.
std::vector<Rival> numbered_in(std::vector<int>& list, std::vector<Rival> rivals) {
    for (Rival& rival : rivals)
        for (int& cause : rival.causes) {
            const auto known = std::find(list.begin(), list.end(), cause);
            const auto at = static_cast<int>(known - list.begin());
            if (known == list.end())
                list.push_back(cause);
            cause = at;
        }
    return rivals;
}

} // namespace

std::vector<std::vector<int>> rivals_in(const Decision& decision) {
    if (!decision.pairs.empty())
        return decision.pairs;
    std::vector<std::vector<int>> rivals;
    for (const int k : decision.causes)
        rivals.push_back({k});
    if (rivals.size() != 1)
        return rivals;
    const MatrixXd& left = decision.isolability;
    const int named = decision.causes[0];
    int near = -1;
    for (int k = 0; k < left.cols(); ++k)
        if (k != named && !std::isnan(left(named, k)) && (near < 0 || left(named, k) < left(named, near)))
            near = k;
    if (near >= 0)
        rivals.push_back({near});
    return rivals;
}

Proposal proposal_of(std::string id, std::string sentence, double separation, double before) {
    Proposal proposal{.id = std::move(id), .sentence = std::move(sentence), .separation = separation};
    proposal.before = before;
    const double known = before * before, added = separation * separation - known;
    const double needed = std::ceil((told_apart * told_apart - known) / std::max(added, 1e-9));
    proposal.repeats = needed > most_repeats ? 0 : std::max(1, static_cast<int>(needed));
    proposal.reached = std::sqrt(known + proposal.repeats * std::max(added, 0.0));
    return proposal;
}

std::vector<Proposal> proposals_for(const SceneText& scene, Model& model, const std::vector<Nuisance>& nuisances,
                                    const Noise& noise, const Simulate& simulate, const VectorXd& values,
                                    const std::vector<Rival>& rivals, Problems& warnings) {
    std::vector<int> list;
    const std::vector<Rival> numbered = numbered_in(list, rivals);
    std::vector<Cause> causes;
    for (const int k : list)
        causes.push_back(model.causes()[static_cast<std::size_t>(k)]);
    VectorXd baseline = model.start();
    baseline.head(model.nuisances()) = values.head(model.nuisances());
    const auto ranges = model.ranges_at(baseline);
    if (!ranges)
        return {};
    const auto apart_with = [&](const std::vector<Record>& records) -> Result<double> {
        auto planned = Model::make(scene, records, nuisances, causes, simulate);
        if (!planned)
            return planned.problems();
        planned->share_sensors(*ranges);
        VectorXd at = planned->start();
        for (std::size_t k = 0; k < planned->parameters().size(); ++k)
            for (std::size_t i = 0; i < static_cast<std::size_t>(model.nuisances()); ++i)
                if (model.parameters()[i].name == planned->parameters()[k].name)
                    at[static_cast<Eigen::Index>(k)] = values[static_cast<Eigen::Index>(i)];
        return separation_in(*planned, noise_for(*planned, noise), at, numbered);
    };
    const auto before = apart_with(model.records());
    if (!before)
        return {};
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
        const auto apart = apart_with(records);
        if (!apart) {
            cannot(apart.problems());
            continue;
        }
        if (*apart < std::max(adds_something * *before, least_worth))
            continue;
        Proposal proposal = proposal_of(experiment.id, experiment.sentence, *apart, experiment.beside ? *before : 0);
        proposal.before = *before; // also of one that is made in place of what was measured
        proposals.push_back(std::move(proposal));
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

#include "diagnose/plain_reason.h"

#include "base/text.h"
#include "diagnose/decide.h"
#include "diagnose/noise.h"
#include "diagnose/taken.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace tumble::diagnose {

namespace {

constexpr double known_scatter = 1.2; // times what was known of it: more is misfit
constexpr double acts = 3;            // standard errors that a tenth of a number changes: less is none of its business
constexpr double tenth = 0.1;

/// A way to read the data otherwise.
struct Candidate {
    std::vector<Record> records;
    std::vector<Nuisance> nuisances;
    std::string key{};         // that is adjusted besides; else:
    std::string what{}, fix{}; // of PlainReason
};

/// Fits it; nothing where it leaves more than noise.
std::optional<PlainReason> asked(const PlainQuestion& question, const Candidate& candidate, Model& model) {
    std::vector<int> free(static_cast<std::size_t>(model.nuisances()));
    std::iota(free.begin(), free.end(), 0);
    const VectorXd start = model.start();
    const int last = model.nuisances() - 1;
    Noise noise = first_noise(model);
    if (!candidate.key.empty()) {
        const auto slope = slope_of(model, noise, start, last, true);
        if (!slope || slope->norm() * tenth * std::abs(start[last]) < acts)
            return std::nullopt;
    }
    const auto first = fit(model, noise, start, free, {.progressive = question.settings.progressive});
    if (!first)
        return std::nullopt;
    const auto about_it = directions_at(model, noise, *first);
    const auto misfit = misfit_of(model, first->values);
    if (!about_it || !misfit)
        return std::nullopt;
    MatrixXd explained(first->residual.size(),
                       first->slopes.cols() + about_it->blocks.cols() + about_it->prints.cols());
    explained << first->slopes, about_it->blocks, about_it->prints;
    NoiseReport report;
    noise = refined_noise(noise, model, *misfit, explained, report);
    if (report.above > known_scatter)
        return std::nullopt;
    const auto fitted = fit(model, noise, first->values, free);
    const auto directions = fitted ? directions_at(model, noise, *fitted) : Result<Directions>(Problems{});
    if (!directions || !fitted->converged ||
        adequacy_of(fitted->residual, fitted->slopes, *directions, degrees_of_numbers(candidate.records)).p() <=
            question.settings.alpha_adequacy)
        return std::nullopt;
    PlainReason reason{.what = candidate.what, .fix = candidate.fix};
    if (!candidate.key.empty()) {
        reason.what =
            fmt::format("with {} = {:.4g} in place of {:.4g}", candidate.key, fitted->values[last], start[last]);
        reason.fix =
            fmt::format("find out whether that can be, and give it as a nuisance (key = \"{}\")", candidate.key);
    }
    if (const auto residual = residual_at(model, question.noise, fitted->values))
        reason.chi_square = residual->squaredNorm();
    return reason;
}

/// Numbers of contacts that were not given as nuisances.
std::vector<Candidate> numbers_of_contacts(const PlainQuestion& question, const scene::Scene& scene) {
    std::vector<Candidate> all;
    const auto& materials = scene.materials;
    for (std::size_t i = 0; i < materials.size(); ++i)
        for (std::size_t k = i; k < materials.size(); ++k)
            for (const char* number : {"restitution", "friction"}) {
                const std::string key = fmt::format("pair.{}-{}.{}", materials[i].name, materials[k].name, number);
                const std::string turned = fmt::format("pair.{}-{}.{}", materials[k].name, materials[i].name, number);
                if (!scene::number_in(question.scene.toml, question.scene.file, question.scene.sets, key) ||
                    std::any_of(question.nuisances.begin(), question.nuisances.end(), [&](const Nuisance& nuisance) {
                        return nuisance.key == key || nuisance.key == turned;
                    }))
                    continue;
                Candidate candidate{.records = question.records, .nuisances = question.nuisances, .key = key};
                candidate.nuisances.push_back({.key = key, .instrument = ""});
                all.push_back(std::move(candidate));
            }
    return all;
}

/// Every height that a set gives the ball at first, moved; empty where a record has none.
std::vector<Record> let_go_higher(std::vector<Record> records, double way) {
    for (Record& record : records) {
        bool found = false;
        for (std::string& set : record.sets) {
            const std::size_t number = set.find('=') + 1;
            const auto height = parse_number(trimmed(std::string_view(set).substr(number)));
            if (!set.starts_with("fill.") || set.find(".position_m.1=") == std::string::npos || !height)
                continue;
            set = set.substr(0, number) + fmt::format("{}", *height + way);
            found = true;
        }
        if (!found)
            return {};
    }
    return records;
}

std::vector<Candidate> lowest_points(const PlainQuestion& question, const scene::Scene& scene) {
    if (scene.bodies[0].spheres.size() != 1)
        return {};
    const double radius = scene.bodies[0].spheres[0].radius;
    std::vector<Record> raised = question.records;
    bool any = false;
    for (Record& record : raised)
        for (Channel& channel : record.channels)
            if (channel.measure == "centre_of_mass_y") {
                any = true;
                for (double& value : channel.value)
                    value += radius;
            }
    if (!any)
        return {};
    const std::string a_radius = fmt::format("a radius, {:.4g} mm, added to", 1e3 * radius);
    std::vector<Candidate> all{{.records = raised,
                                .nuisances = question.nuisances,
                                .what = fmt::format("with {} the heights read", a_radius),
                                .fix = "see whether they are those of the ball's lowest point"}};
    if (auto higher = let_go_higher(question.records, radius); !higher.empty())
        all.push_back({.records = std::move(higher),
                       .nuisances = question.nuisances,
                       .what = fmt::format("with {} the heights at which it is let go", a_radius),
                       .fix = "see whether set has those of the ball's lowest point"});
    if (auto both = let_go_higher(raised, radius); !both.empty())
        all.push_back({.records = std::move(both),
                       .nuisances = question.nuisances,
                       .what = fmt::format("with {} the heights read and those at which it is let go", a_radius),
                       .fix = "see whether all are those of the ball's lowest point"});
    return all;
}

} // namespace

std::optional<PlainReason> plain_reason(const PlainQuestion& question, Effort& effort) {
    const auto model = Model::make(question.scene, question.records, {}, {}, question.simulate);
    const auto scene = model ? model->scene_at(model->start(), -1) : Result<scene::Scene>(Problems{});
    if (!scene)
        return std::nullopt;
    std::optional<PlainReason> best;
    for (const std::vector<Candidate>& candidates :
         {numbers_of_contacts(question, *scene), lowest_points(question, *scene)})
        for (const Candidate& candidate : candidates) {
            auto as_asked = Model::make(question.scene, candidate.records, candidate.nuisances, {}, question.simulate);
            if (!as_asked)
                continue;
            auto reason = asked(question, candidate, *as_asked);
            effort.runs += as_asked->runs();
            effort.simulated += as_asked->simulated();
            if (reason && (!best || reason->chi_square < best->chi_square))
                best = std::move(reason);
        }
    return best;
}

} // namespace tumble::diagnose

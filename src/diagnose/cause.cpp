#include "diagnose/cause.h"

#include "base/text.h"
#include "diagnose/cause_families.h"

namespace tumble::diagnose {

namespace {

std::vector<Cause> collect() {
    std::vector<Cause> all;
    for (auto part :
         {of_the_air, of_the_contact, of_cohesion, of_the_friction, of_the_excitation, of_the_load, of_the_shape,
          of_the_ground, of_the_simulation, of_the_clock, of_the_sensor, of_the_camera, of_the_accelerometer})
        for (Cause& cause : part())
            all.push_back(std::move(cause));
    return all;
}

bool of_readings_only(const Cause& cause) {
    return !cause.physical() || !cause.needs.empty() || cause.inertial;
}

bool shows_in(const Cause& cause, Data data) {
    return data == Data::beds ? !of_readings_only(cause) : !cause.beds;
}

} // namespace

const std::vector<Cause>& all_causes() {
    static const std::vector<Cause> all = collect();
    return all;
}

std::vector<std::string> cause_ids() {
    std::vector<std::string> ids;
    for (const Cause& cause : all_causes())
        ids.push_back(cause.id);
    return ids;
}

Result<std::vector<Cause>> choose_causes(const std::vector<std::string>& ids, Data data) {
    const bool every = ids.empty() || ids == std::vector<std::string>{"all"};
    std::vector<bool> wanted(all_causes().size(), false);
    for (std::size_t k = 0; every && k < wanted.size(); ++k)
        wanted[k] = shows_in(all_causes()[k], data);
    Problems problems;
    for (const std::string& id : every ? std::vector<std::string>{} : ids) {
        bool found = false;
        for (std::size_t k = 0; k < all_causes().size(); ++k) {
            const Cause& cause = all_causes()[k];
            if (cause.id == id && data == Data::beds && of_readings_only(cause))
                problems.push_back({.key = "causes",
                                    .what = id + " acts on readings over time, and means of a bed are none",
                                    .fix = "leave it out"});
            if (cause.id == id || (cause.family == id && shows_in(cause, data)))
                wanted[k] = found = true;
        }
        if (!found) {
            std::vector<std::string> known = cause_ids();
            for (const Cause& cause : all_causes())
                known.push_back(cause.family);
            std::string guess = did_you_mean(id, known);
            for (const std::string& one : known)
                if (guess.empty() && !id.empty() && one.find(id) != std::string::npos)
                    guess = fmt::format("did you mean '{}'?", one);
            problems.push_back({.key = "causes",
                                .what = "there is no cause and no family '" + excerpt(id) + "'",
                                .fix = (guess.empty() ? "" : guess + " ") + "`tumble list causes` names all of them"});
        }
    }
    if (!problems.empty())
        return problems;
    std::vector<Cause> chosen;
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k])
            chosen.push_back(all_causes()[k]);
    return chosen;
}

} // namespace tumble::diagnose

#include "told.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace blind {

namespace {

constexpr double pi = 3.14159265358979323846;

constexpr const char* restitution_of_leather = "key = \"pair.leather-wood.restitution\"\nspread = 0.05\n";
constexpr const char* restitution_of_rubber = "key = \"pair.rubber-wood.restitution\"\nspread = 0.05\n";
constexpr const char* restitution_of_plastic = "key = \"pair.plastic-steel.restitution\"\nspread = 0.05\n";
constexpr const char* friction_of_rubber = "key = \"pair.rubber-wood.friction\"\nspread = 0.03\n";
constexpr const char* friction_of_plastic = "key = \"pair.plastic-board.friction\"\nspread = 0.03\n";
constexpr const char* speeds = "key = \"fill.0.velocity_m_s.0\"\nper = \"series\"\nspread = 0.03\n";
constexpr const char* clocks = "instrument = \"clock_offset\"\nper = \"series\"\nspread = 0.005\n";
constexpr const char* quick_clocks = "instrument = \"clock_offset\"\nper = \"series\"\nspread = 0.002\n";

/// How a bench is told: the scene, its title, what one record is called, and what nobody knows of it exactly.
struct Told {
    const char *scene, *title, *record;
    std::vector<const char*> nuisances;
};

const Told& told(Bench bench) {
    static const Told all[] = {
        {"bounce.toml", "A ball dropped, filmed from the side", "drop", {restitution_of_leather, clocks}},
        {"lane.toml", "A ball thrown along a lane, filmed from above", "throw", {friction_of_rubber, speeds, clocks}},
        {"slope.toml", "A tripod that slides down a slope, filmed from above", "slide", {friction_of_plastic, clocks}},
        {"lane.toml", "A ball that rolls out, filmed from above", "roll", {speeds, clocks}},
        {"lane.toml",
         "A ball thrown at the floor, filmed from the side",
         "throw",
         {restitution_of_rubber, friction_of_rubber, speeds, clocks}},
        {"slope.toml", "A tripod that spins on the level, with marks", "spin", {friction_of_plastic, quick_clocks}},
        {"plate.toml",
         "A ball on a plate that shakes, filmed from the side",
         "shake",
         {restitution_of_plastic, clocks}}};
    return all[static_cast<int>(bench)];
}

/// What a trial of less mass sets.
std::string mass_of(const Setup& setup, const Trial& trial, const Truth& known) {
    if (trial.mass == 1)
        return "";
    if (setup.bench == Bench::slope || setup.bench == Bench::spin || setup.bench == Bench::plate)
        return fmt::format(", \"material.plastic.density_kg_m3={}\"", 1200 * trial.mass);
    const double whole = setup.bench == Bench::drop ? known.ball.mass : known.lane.mass;
    return fmt::format(", \"body.ball.mass_kg={}\"", whole * trial.mass);
}

/// Scene keys of a trial, as the reader of a measurement would type them.
std::string sets_of(const Setup& setup, const Trial& trial, const Truth& known) {
    const std::string mass = mass_of(setup, trial, known);
    const double slope = trial.slope * pi / 180;
    const std::string leaning =
        fmt::format("\"gravity_m_s2=[{:.9f}, {:.9f}, 0.0]\"", known.lane.gravity * std::sin(slope),
                    -known.lane.gravity * std::cos(slope));
    const std::string thrown = fmt::format("\"fill.0.velocity_m_s.0={}\"", trial.speed);
    switch (setup.bench) {
    case Bench::drop:
        return fmt::format("\"fill.0.position_m.1={}\"{}", known.ball.radius + trial.height, mass);
    case Bench::slope:
        return leaning + mass;
    case Bench::spin:
        return fmt::format("{}, \"fill.0.angular_velocity_rad_s.1={}\"{}", leaning, trial.spin, mass);
    case Bench::roll:
        return fmt::format("{}, \"fill.0.angular_velocity_rad_s.2={}\"{}", thrown, -trial.speed / known.lane.radius,
                           mass);
    case Bench::oblique:
        return fmt::format("\"fill.0.position_m.1={}\", {}{}", known.ball.radius + trial.height, thrown, mass);
    case Bench::plate:
        return fmt::format("\"wall.0.motion.0.amplitude_m={}\"{}", trial.shaken, mass);
    case Bench::lane:
        break;
    }
    return thrown + (trial.slope == 0 ? "" : ", " + leaning) + mass;
}

std::string name_of(const Setup& setup, const Trial& trial) {
    std::string name = trial.mass == 0.25 ? "light ball, " : trial.mass != 1 ? "an eighth of the mass, " : "";
    if (setup.bench == Bench::drop)
        name += fmt::format("{:.0f} mm", 1000 * trial.height);
    else if (setup.bench == Bench::slope)
        name += fmt::format("{:+.1f} deg", trial.slope);
    else if (setup.bench == Bench::spin)
        name += fmt::format("{:+.1f} rad/s", trial.spin);
    else if (setup.bench == Bench::plate)
        name += fmt::format("{:.3f} mm", 1000 * trial.shaken);
    else
        name += fmt::format("{:+.2f} m/s", trial.speed);
    if (setup.bench == Bench::lane && trial.slope != 0)
        name += fmt::format(" on {:+.0f} deg", trial.slope);
    return name + (trial.lasts != 1 ? ", longer" : "");
}

} // namespace

std::string scene_of_bench(Bench bench) {
    return told(bench).scene;
}

std::string record_word(Bench bench) {
    return told(bench).record;
}

std::string measurement_of(const Setup& setup, const std::vector<std::string>& files, const Truth& known) {
    const Bench bench = setup.bench;
    std::string toml = fmt::format("title = \"{}\"\n", told(bench).title);
    for (const char* nuisance : told(bench).nuisances)
        toml += fmt::format("\n[[nuisance]]\n{}", nuisance);
    for (std::size_t r = 0; r < files.size(); ++r) {
        const Trial& trial = setup.trials[r];
        const bool repeats =
            std::any_of(setup.trials.begin(), setup.trials.begin() + static_cast<long>(r),
                        [&](const Trial& other) { return name_of(setup, other) == name_of(setup, trial); });
        toml += fmt::format("\n[[series]]\nname = \"{}{}\"\nfile = \"{}\"\nset = [{}]\n", name_of(setup, trial),
                            repeats ? ", again" : "", files[r], sets_of(setup, trial, known));
        for (const Channel& channel : channels_of(bench))
            toml += fmt::format("[[series.column]]\nhead = \"{}\"\nmeasure = \"{}\"\nsigma = {:.3g}\n", channel.head,
                                channel.measure, channel.scale * setup.sigma);
        if (setup.clock)
            toml += "[[series.column]]\nhead = \"clock\"\nmeasure = \"time\"\nsigma = 1\n";
    }
    return toml;
}

} // namespace blind

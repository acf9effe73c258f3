#include "diagnose/kinematics.h"

#include "base/distributions.h"
#include "diagnose/warning_key.h"
#include "observe/cycle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <optional>

namespace tumble::diagnose {

namespace {

constexpr double surely = 5;           // standard errors, of any contradiction
constexpr double slip = 6;             // standard errors, of a lone reading
constexpr double crest = 1.5;          // of a peak speed over that of the sinusoid: no swing of one frequency has more
constexpr double fewest_cycles = 3;    // of an oscillation
constexpr std::size_t together = 5;    // readings whose mean stands for a top
constexpr double least_leaning = 1e-3; // of gravity, across: heights alone are no energy then

using Readings = std::vector<double>;

using Scatters = std::vector<double>; // SI, a channel each

bool alone(const scene::Scene& scene) {
    return scene.fills.size() == 1 && scene.fills[0].count.value_or(0) == 1;
}

/// Readings of which lone ones that no neighbour bears out are replaced by the nearer neighbour.
Readings without_slips(const Readings& value, double sigma) {
    Readings clean = value;
    for (std::size_t k = 1; k + 1 < value.size(); ++k) {
        const double middle =
            std::clamp(value[k], std::min(value[k - 1], value[k + 1]), std::max(value[k - 1], value[k + 1]));
        if (std::abs(value[k] - middle) > slip * sigma)
            clean[k] = middle;
    }
    return clean;
}

/// One measure is the way, the other a velocity whose sum it is. Of a lone body its own place is the centre of mass.
bool sums_to(const std::string& velocity, const std::string& way, bool lone_body) {
    for (const std::string axis : {"x", "y", "z"})
        for (const auto& [fast, slow] : {std::pair<std::string, std::string>{"_summed_v", "_point_"},
                                         {"_summed_v", "_"},
                                         {"_point_v", "_point_"},
                                         {"_v", "_"}})
            if (velocity.ends_with(fast + axis)) {
                const std::string body = velocity.substr(0, velocity.size() - fast.size() - 1);
                if (way == body + slow + axis || (lone_body && slow == "_" && way == "centre_of_mass_" + axis))
                    return true;
            }
    return false;
}

/// Calls with the channels of every pair of a velocity and the way that it sums to.
template <class Each> void each_pair(const Record& record, const scene::Scene& scene, Each each) {
    for (std::size_t v = 0; v < record.channels.size(); ++v)
        for (std::size_t x = 0; x < record.channels.size(); ++x)
            if (record.channels[v].unit == "m_s" && record.channels[x].unit == "m" &&
                sums_to(record.channels[v].measure, record.channels[x].measure, alone(scene)))
                each(v, x);
}

/// From 0, by the cubic through four readings where their steps are alike, else by the trapezoidal one.
Readings summed(const Readings& time, const Readings& rate) {
    Readings sum{0};
    for (std::size_t k = 1; k < time.size(); ++k) {
        const double step = time[k] - time[k - 1];
        double mean = 0.5 * (rate[k] + rate[k - 1]);
        const auto alike = [&](std::size_t j) { return std::abs(time[j] - time[j - 1] - step) < 0.1 * step; };
        if (k > 1 && k + 1 < time.size() && alike(k - 1) && alike(k + 1))
            mean = (13 * (rate[k] + rate[k - 1]) - rate[k - 2] - rate[k + 1]) / 24;
        sum.push_back(sum.back() + mean * step);
    }
    return sum;
}

/// By how much the variance of such a sum grows from reading to reading: scatter of readings, and jumps between two of
/// them, of which nobody knows when they were.
Readings growth_of_variance(const Readings& time, const Readings& rate, double sigma) {
    Readings growth{0};
    for (std::size_t k = 1; k < time.size(); ++k) {
        const double before = k > 1 ? rate[k - 1] - rate[k - 2] : 0,
                     after = k + 1 < time.size() ? rate[k + 1] - rate[k] : 0;
        const double jump = std::abs(rate[k] - rate[k - 1] - (before + after) / 2);
        const double step = time[k] - time[k - 1];
        growth.push_back(step * step * (sigma * sigma + (jump > surely * sigma ? jump * jump / 12 : 0)));
    }
    return growth;
}

/// Columns over time that wander at random, by variances that grow so, and are read with `sigma`: Kalman's filter makes
/// of them what each reading says that those before it did not. Where they begin is unknown: one row less.
Eigen::MatrixXd innovations(const Eigen::MatrixXd& columns, const Readings& growth, double sigma) {
    Eigen::MatrixXd fresh(columns.rows() - 1, columns.cols());
    Eigen::RowVectorXd state = columns.row(0);
    double variance = sigma * sigma;
    for (Eigen::Index k = 1; k < columns.rows(); ++k) {
        variance += growth[static_cast<std::size_t>(k)];
        const double all = variance + sigma * sigma;
        const Eigen::RowVectorXd missed = columns.row(k) - state;
        fresh.row(k - 1) = missed / std::sqrt(all);
        state += variance / all * missed;
        variance *= sigma * sigma / all;
    }
    return fresh;
}

/// What the sum of a velocity has too much of the way, of time and of its square, by least squares.
struct Disagreement {
    double share = 0, rate = 0, acceleration = 0; // -, m/s, m/s2
    double fall = 0;                              // of chi-square when the three are adjusted
};

Disagreement between(const Readings& time, const Readings& way, double way_sigma, const Readings& rate,
                     double rate_sigma) {
    const Readings sum = summed(time, rate);
    Eigen::MatrixXd columns(static_cast<Eigen::Index>(time.size()), 4);
    for (std::size_t k = 0; k < time.size(); ++k)
        columns.row(static_cast<Eigen::Index>(k)) << sum[k] - way[k], way[k], time[k], 0.5 * time[k] * time[k];
    const Eigen::MatrixXd fresh = innovations(columns, growth_of_variance(time, rate, rate_sigma), way_sigma);
    const Eigen::VectorXd apart = fresh.col(0);
    const Eigen::MatrixXd terms = fresh.rightCols(3);
    const Eigen::VectorXd found = terms.completeOrthogonalDecomposition().solve(apart);
    return {found[0], found[1], found[2], apart.squaredNorm() - (apart - terms * found).squaredNorm()};
}

Problem doubt(const Record& record, const char* key, std::string what, std::string fix) {
    return {.file = record.file.string(), .key = key, .what = std::move(what), .fix = std::move(fix)};
}

void doubt_sums(const Record& record, const Scatters& sigma, const scene::Scene& scene, Problems& doubts) {
    each_pair(record, scene, [&](std::size_t v, std::size_t x) {
        const Channel &fast = record.channels[v], &way = record.channels[x];
        const Disagreement found = between(record.time, way.value, sigma[x], fast.value, sigma[v]);
        if (chi_square_tail(found.fall, 3) > normal_tail(surely))
            return;
        doubts.push_back(doubt(
            record, warning_key::velocity_against_way,
            fmt::format(
                "the sum of {} is not {}: it has {:+.3g} % of the way too much, and runs away by {:+.3g} m/s and "
                "{:+.3g} m/s2",
                fast.head, way.head, 100 * found.share, found.rate, found.acceleration),
            "one of the two sensors is wrong, whatever the simulation says: a share is a scale, a rate a zero of the "
            "velocity, an acceleration gravity that leaks or a zero that drifts"));
    });
}

/// How a reading swings about its mean.
struct Swinging {
    double amplitude = 0, period = 0; // s
};

std::optional<Swinging> swinging(const Readings& time, const Readings& value, double sigma) {
    const observe::Cycle cycle = observe::find_cycle(time, value);
    const double amplitude = (cycle.highest - cycle.lowest) / 2;
    if (cycle.cycles < fewest_cycles || amplitude < 2 * surely * sigma)
        return std::nullopt;
    for (std::size_t k = 1; k < cycle.tops.size(); ++k)
        if (std::abs(cycle.tops[k] - cycle.tops[k - 1] - cycle.period) > cycle.period / 3) // not even nearly a sinusoid
            return std::nullopt;
    return Swinging{amplitude, cycle.period};
}

void doubt_peaks(const Record& record, const Scatters& sigma, const scene::Scene& scene, Problems& doubts) {
    each_pair(record, scene, [&](std::size_t v, std::size_t x) {
        const Channel &fast = record.channels[v], &way = record.channels[x];
        const auto found = swinging(record.time, way.value, sigma[x]);
        if (!found)
            return;
        const auto [lowest, highest] = std::minmax_element(fast.value.begin(), fast.value.end());
        const double peak = (*highest - *lowest) / 2;
        const double least = 4 * found->amplitude / found->period;
        const double most = crest * 2 * std::numbers::pi * found->amplitude / found->period;
        if (peak < least - surely * sigma[v] || peak > most + surely * sigma[v])
            doubts.push_back(
                doubt(record, warning_key::peak_speed,
                      fmt::format(
                          "{} swings by {:.3g} m in {:.3g} s, which takes a peak speed of {:.3g} to {:.3g} m/s, but {} "
                          "reaches {:.3g} m/s",
                          way.head, found->amplitude, found->period, least, most, fast.head, peak),
                      "compare the two sensors: one of their scales, or a filter, is wrong"));
    });
}

/// The fastest that a wall's surface goes inside the domain, m/s.
double fastest_wall(const scene::Scene& scene) {
    const double reach = (scene.domain.box.hi - scene.domain.box.lo).norm();
    double fastest = 0;
    for (const scene::Wall& wall : scene.walls) {
        double speed = 0;
        for (const auto& part : wall.motion.harmonics)
            speed += 2 * std::numbers::pi * part.frequency * std::abs(part.amplitude);
        for (const auto& part : wall.motion.rotations)
            speed += std::abs(part.angular_velocity) * reach;
        for (const auto& part : wall.motion.rockings)
            speed += 2 * std::numbers::pi * part.frequency * std::abs(part.amplitude) * reach;
        for (const auto& part : wall.motion.linears)
            speed += part.velocity.norm();
        for (const auto& table : wall.motion.tables)
            for (std::size_t k = 1; k < table.time.size(); ++k)
                speed = std::max(speed, (table.displacement[k] - table.displacement[k - 1]).norm() /
                                            (table.time[k] - table.time[k - 1]));
        fastest = std::max(fastest, speed);
    }
    return fastest;
}

/// What the centre of a lone body is never faster than, m/s: it keeps the energy that it was put in with, falls through
/// all of the domain, and bounces off walls that move. Off a wall at V that comes to meet it again and again a speed
/// grows to (1 + e) V / (1 - e). Infinite where restitution may be 1 or more.
double speed_limit(const scene::Scene& scene) {
    const Eigen::Vector3d size = scene.domain.box.hi - scene.domain.box.lo;
    double put_in = 0, bounciest = 0;
    for (const scene::Fill& fill : scene.fills) {
        const double turns = fill.angular_velocity.norm() * size.norm() / 2; // no body is larger than the domain
        put_in = std::max(put_in, fill.velocity.squaredNorm() + turns * turns);
    }
    for (const contact::PairProperties& pair : scene.pairs)
        bounciest = std::max(bounciest, pair.restitution_exponent != 0 ? 1.0 : pair.restitution);
    const double wall = fastest_wall(scene);
    if (wall > 0 && bounciest >= 1)
        return std::numeric_limits<double>::infinity();
    const double kicked = wall > 0 ? (1 + bounciest) * wall / (1 - bounciest) : 0;
    return kicked + std::sqrt(put_in + 2 * scene.gravity.cwiseAbs().dot(size));
}

bool is_of_a_centre(const std::string& measure) {
    return measure == "speed_max" || measure == "mean_speed" || measure.starts_with("rms_velocity_") ||
           (measure.starts_with("tracer:") && !measure.ends_with("_point_vx") && !measure.ends_with("_point_vy") &&
            !measure.ends_with("_point_vz") && measure.find("_summed_v") == std::string::npos);
}

void doubt_speeds(const Record& record, const Scatters& sigma, const scene::Scene& scene, Problems& doubts) {
    if (!alone(scene))
        return;
    const double limit = speed_limit(scene);
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const Channel& channel = record.channels[c];
        if (channel.unit != "m_s" || !is_of_a_centre(channel.measure))
            continue;
        double most = 0;
        for (const double value : channel.value)
            most = std::max(most, std::abs(value));
        if (most > limit + surely * sigma[c])
            doubts.push_back(
                doubt(record, warning_key::speed,
                      fmt::format("{} reaches {:.3g} m/s, and nothing in the scene makes a body faster than "
                                  "{:.3g} m/s: how it is put in, a fall through all of the domain, and its "
                                  "walls",
                                  channel.head, most, limit),
                      "check the unit and the zero of the sensor, and the speeds that the scene states"));
    }
}

/// When readings are highest before they come down by more than `least`; their beginning, too, if they come down first.
Readings tops_of(const Readings& time, const Readings& value, double least) {
    const double span = observe::quantile(value, 0.95) - observe::quantile(value, 0.05);
    const observe::Cycle cycle = observe::find_cycle(time, value, least / span);
    Readings tops = cycle.tops;
    if (!cycle.bottoms.empty() && (tops.empty() || cycle.bottoms[0] < tops[0]))
        tops.insert(tops.begin(), time[0]);
    return tops;
}

double mean_about(const Readings& time, const Readings& value, double at) {
    const auto k = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), at) - time.begin());
    const std::size_t first = k < together / 2 ? 0 : k - together / 2, last = std::min(value.size(), first + together);
    double sum = 0;
    for (std::size_t i = first; i < last; ++i)
        sum += value[i];
    return sum / static_cast<double>(last - first);
}

void doubt_energy(const Record& record, const Scatters& sigma, const scene::Scene& scene, Problems& doubts) {
    const bool moved = std::any_of(scene.walls.begin(), scene.walls.end(),
                                   [](const scene::Wall& wall) { return !wall.motion.at_rest(); });
    const double across = std::hypot(scene.gravity.x(), scene.gravity.z());
    if (moved || !alone(scene) || !(scene.gravity.y() < 0) || across > least_leaning * -scene.gravity.y())
        return;
    for (std::size_t c = 0; c < record.channels.size(); ++c) {
        const Channel& channel = record.channels[c];
        if (!channel.measure.ends_with("centre_of_mass_y") || sigma[c] == 0)
            continue;
        const Readings tops = tops_of(record.time, channel.value, 2 * surely * sigma[c]);
        for (std::size_t k = 1; k < tops.size(); ++k) {
            const double before = mean_about(record.time, channel.value, tops[k - 1]),
                         now = mean_about(record.time, channel.value, tops[k]);
            if (now - before < surely * sigma[c] * std::sqrt(2.0 / together))
                continue;
            doubts.push_back(doubt(record, "energy",
                                   fmt::format("{} comes up to {:.4g} m after it was no higher than {:.4g} m, and no "
                                               "wall moves that could lift it",
                                               channel.head, now, before),
                                   "look for a camera that moves, a zero that drifts, or a body that spins: the energy "
                                   "of its spin comes back at impacts"));
            break;
        }
    }
}

void doubt_rate(const Record& record, const scene::Scene& scene, Problems& doubts) {
    double fastest = 0;
    for (const scene::Wall& wall : scene.walls) {
        for (const auto& part : wall.motion.harmonics)
            fastest = std::max(fastest, part.frequency);
        for (const auto& part : wall.motion.rockings)
            fastest = std::max(fastest, part.frequency);
    }
    const double step = (record.time.back() - record.time.front()) / static_cast<double>(record.time.size() - 1);
    if (fastest * step > 0.5)
        doubts.push_back(doubt(record, "aliasing",
                               fmt::format("readings come every {:.3g} s, and a wall vibrates at {:.4g} Hz: {:.2f} of "
                                           "its periods pass between two of them",
                                           step, fastest, fastest * step),
                               fmt::format("read more than {:.4g} times in a second, or compare only what is taken at "
                                           "equal phase: what swings with the wall looks like a slow motion",
                                           2 * fastest)));
}

} // namespace

Problems kinematic_doubts(const Record& as_read, const Scatters& sigma, const scene::Scene& scene) {
    Problems doubts;
    if (as_read.single())
        return doubts;
    Record record = as_read;
    for (std::size_t c = 0; c < record.channels.size(); ++c)
        record.channels[c].value = without_slips(record.channels[c].value, sigma[c]);
    doubt_sums(record, sigma, scene, doubts);
    doubt_peaks(record, sigma, scene, doubts);
    doubt_speeds(record, sigma, scene, doubts);
    doubt_energy(record, sigma, scene, doubts);
    doubt_rate(record, scene, doubts);
    return doubts;
}

} // namespace tumble::diagnose

#pragma once

#include "throw.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace blind {

/// The generator's own instrument: a camera that reads heights, and a clock in its picture.
struct Sensor {
    double rate = 0;      // share by which its clock is fast
    double gain = 0;      // share
    double bias = 0;      // m
    double drift = 0;     // m/s
    double low_pass = 0;  // s
    double high_pass = 0; // 1/s
    double clip = 0;      // share of the largest way, height or spin of all records that is beyond its range
    double bend = 0;      // 1/m, reads y + bend y^2; in no library
    double shake = 0;     // m, of a camera that shakes at 7.3 Hz; in no library
};

/// Balls that are dropped, thrown along a lane, let go rolling on it or thrown at it; a tripod that slides down a slope
/// or spins on the level; a ball that lies on a shaken plate.
enum class Bench { drop, lane, slope, roll, oblique, spin, plate };
constexpr int benches = 7;
constexpr unsigned on(Bench bench) {
    return 1U << static_cast<unsigned>(bench);
}

/// What was done once.
struct Trial {
    double height = 0; // m, of the ball's lowest point
    double mass = 1;   // over the usual one
    double speed = 0;  // m/s, towards +x
    double slope = 0;  // deg, falling towards +x
    double spin = 0;   // rad/s, about the vertical
    double shaken = 0; // m, amplitude of the plate
    double lasts = 1;  // over the usual duration
};

/// What was done, and how well it was read.
struct Setup {
    Bench bench = Bench::drop;
    std::vector<Trial> trials;
    double rate_hz = 120;
    double duration = 2.5; // s
    double sigma = 2e-3;   // SI, of every channel but the clock
    bool clock = false;    // a clock in the picture, read to a millisecond
    double memory = 0;     // of every channel's errors but the clock's, from one reading to the next
};

/// What is true in one case.
struct Truth {
    Ball ball;
    Lane lane;
    Sensor sensor;
    std::vector<double> offsets; // s, of each record's clock
    std::vector<double> speeds;  // m/s, by which each throw was faster
    // In no library:
    double one_restitution = 0; // of the second trial alone, added
    double one_friction = 0;    // of the second trial alone, share
    double one_rolling = 0;     // of the second trial alone, mu_r
    bool swapped = false;       // the first record and the third carry each other's names
};

/// What is read of a bench: head of the column and its unit, SI over that unit, tumble's name.
struct Channel {
    const char *head, *unit;
    double scale;
    const char* measure;
};
std::vector<Channel> channels_of(Bench bench);

std::vector<double> times_of(const Setup& setup, const Trial& trial);

/// Every reading without noise, over its sigma: record by record, channel by channel, then clocks.
Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth);

/// Differences of such readings, their memory taken out: errors of 1 that know nothing of each other.
Eigen::VectorXd whitened(const Setup& setup, Eigen::VectorXd readings);

/// Readings that differ by more than 4 standard errors while all but one of the three to either side do not: whoever
/// looks at a record leaves them out as slips.
std::vector<bool> lone(const Setup& setup, const Eigen::VectorXd& differences);

/// Of the squares of such differences, the share of the record that has most of them.
double share_of_one_record(const Setup& setup, const Eigen::VectorXd& differences);

/// Something that is unknown but innocent: what a measurement adjusts under every explanation.
struct Innocent {
    enum Kind { law, clock, throws } kind = law;
    std::function<void(Truth&, double)> add;
    double spread = 0; // of what is known beforehand
};
std::vector<Innocent> innocents_of(const Setup& setup);

/// A hidden effect: its name and how it enters.
struct Effect {
    std::string id;
    bool listed = true;
    double typical = 0; // amplitude to begin with
    double most = 0;    // that a laboratory could overlook
    bool one_sided = false;
    unsigned shown = 0; // bits of benches
    void (*hide)(Truth&, double amplitude) = nullptr;
    bool whole = false; // it is there or not: no amplitude
};

/// Those that the library of tumble has too, by the same ids and units; and those that it must not have.
const std::vector<Effect>& effects();
bool shows(const Effect& effect, Bench bench);
/// "drop" and so on; and back, where it is none of them "drop".
std::string word_of(Bench bench);
Bench bench_of(const std::string& word);
const Effect* find_effect(const std::string& id);

} // namespace blind

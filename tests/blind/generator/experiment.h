#pragma once

#include "lane.h"

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
    double clip = 0;      // share of the range of a record
    double bend = 0;      // 1/m, reads y + bend y^2; in no library
};

enum class Bench { drop, lane, slope };

/// What was done once: a ball dropped or thrown along a lane, a tripod let go on a slope.
struct Trial {
    double height = 0;  // m, of the ball's lowest point
    bool light = false; // a quarter of the mass
    double speed = 0;   // m/s, towards +x
    double slope = 0;   // deg, falling towards +x
};

/// What was done, and how well it was read.
struct Setup {
    Bench bench = Bench::drop;
    std::vector<Trial> trials;
    double rate_hz = 120;
    double duration = 2.5; // s
    double sigma = 2e-3;   // m
    bool clock = false;    // a clock in the picture, read to a millisecond
};

/// What is true in one case.
struct Truth {
    Ball ball;
    Lane lane;
    Sensor sensor;
    std::vector<double> offsets;     // s, of each record's clock
    std::vector<double> speeds;      // m/s, by which each throw was faster
    std::vector<double> restitution; // of each drop, added to the ball's; in no library
    bool swapped = false;            // the first two records carry each other's names; in no library
};

std::vector<double> times_of(const Setup& setup);

/// Every reading without noise, over its sigma: heights or ways of all records, then clocks.
Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth);

/// Something that is unknown but innocent: what a measurement adjusts under every explanation.
struct Innocent {
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
    bool drops = true, lanes = true, slopes = true; // where it shows
    void (*hide)(Truth&, double amplitude) = nullptr;
};

/// Those that the library of tumble has too, by the same ids and units; and those that it must not have.
const std::vector<Effect>& effects();
bool shows(const Effect& effect, Bench bench);
/// "drop", "lane" or "slope"; and back, where it is none of them "drop".
std::string word_of(Bench bench);
Bench bench_of(const std::string& word);
const Effect* find_effect(const std::string& id);

} // namespace blind

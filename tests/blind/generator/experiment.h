#pragma once

#include "ball.h"

#include <Eigen/Core>
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

struct Drop {
    double height = 0; // m, of the ball's lowest point
    bool light = false;
};

/// What was done, and how well it was read.
struct Setup {
    std::vector<Drop> drops;
    double rate_hz = 120;
    double duration = 2.5; // s
    double sigma = 2e-3;   // m
    bool clock = false;    // a clock in the picture, read to a millisecond
};

/// What is true in one case.
struct Truth {
    Ball ball;
    Sensor sensor;
    std::vector<double> offsets;     // s, of each record's clock
    std::vector<double> restitution; // of each drop, added to the ball's; in no library
    bool swapped = false;            // the first two records carry each other's names; in no library
};

std::vector<double> times_of(const Setup& setup);

/// Every reading without noise, over its sigma: heights of all records, then clocks.
Eigen::VectorXd readings_of(const Setup& setup, const Truth& truth);

/// A hidden effect: its name and how it enters.
struct Effect {
    std::string id;
    bool listed = true;
    double typical = 0; // amplitude to begin with
    double most = 0;    // that a laboratory could overlook
    bool one_sided = false;
    void (*hide)(Truth&, double amplitude) = nullptr;
};

/// Those that the library of tumble has too, by the same ids and units; and those that it must not have.
const std::vector<Effect>& effects();
const Effect* find_effect(const std::string& id);

} // namespace blind

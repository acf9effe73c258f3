#pragma once

#include "base/problem.h"
#include "diagnose/instrument.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace tumble::diagnose {

/// One thing that may be wrong with a scene or with an instrument: an extension by one number whose null value, 0, is
/// the baseline bit for bit.
struct Cause {
    std::string id{};     // "drag.quadratic"
    std::string family{}; // an answer of its own where members cannot be told apart
    std::string symbol{}; // what the number is called
    std::string unit{};   // of the number, as column heads have it; empty: a plain number
    double lo = 0;        // plausible at least
    double hi = 0;        // plausible at most
    double typical = 0;   // a small effect of usual experiments: where difference quotients begin
    double in_beds = 0;   // the amplitude that beds are run at; 0: half of what is plausible
    bool turns = false;   // an angle in degrees, of which 360 are none
    bool beds = false;    // considered where beds were measured only: one body does not show it beside a nuisance
    std::vector<std::string> needs{}; // considered only where one record has all of these measures; never of beds
    enum class Range { own, readings, readings_per_second }; // what is plausible: lo and hi, or a share of what is read
    Range range = Range::own;
    bool inertial = false;  // considered only where a record has what an accelerometer in a body read
    bool over_time = false; // acts on readings over time: a single number, read once, does not show it
    std::string name{};     // for sentences: "air resistance growing with the square of speed"
    std::string look{};     // its fingerprint: what the residual (data less baseline) does
    std::string keys{};     // scene keys that it sets, or what it does to the instrument
    std::function<void(scene::Scene&, double)> extend{}; // exactly one of the two is set
    std::function<void(Instrument&, double)> distort{};
    std::string sensor{}; // the only one that it distorts; empty: all

    [[nodiscard]] bool physical() const { return extend != nullptr; }
    /// The sensor's range ends, and readings with it.
    [[nodiscard]] bool clips() const { return family == "sensor range"; }
};

/// The library, physical causes first.
const std::vector<Cause>& all_causes();

/// The ids of the library.
std::vector<std::string> cause_ids();

/// What was measured: readings over time of a few bodies, or means of a bed of many.
enum class Data { records, beds };

/// Those with these ids, or of these families; all for {"all"} or nothing, of those that act on such data. Problems: an
/// id that does not exist, with the nearest; one that cannot act on such data.
Result<std::vector<Cause>> choose_causes(const std::vector<std::string>& ids, Data data = Data::records);

} // namespace tumble::diagnose

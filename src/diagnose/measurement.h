#pragma once

#include "base/problem.h"
#include "scene/keys.h"
#include "scene/scene.h"
#include "scene/text_tree.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tumble::diagnose {

/// What of a measure over time a reading is: each instant's value, or one number of the whole stretch.
enum class Take { reading, highest, lowest, last, mean, rebound };

/// One column of readings and what of the simulation it shows.
struct Channel {
    std::string head;          // in the CSV, with its unit
    std::string measure;       // name of a measure, or "time" for a clock in the picture
    std::string unit;          // SI, as measures have it: "m", "m_s"
    std::vector<double> value; // SI
    double sigma = 0; // SI, scatter of one reading; of a single number that of the mean of its rows; 0: not stated
    double degrees = std::numeric_limits<double>::infinity(); // of freedom that sigma is known with
    int rows = 1;                                             // of a single number: that repeat each other
    Take take = Take::reading; // of a record of single numbers: one of the others, of all its channels
    double from = 0;           // s, where the stretch begins that a single number is of; it ends with the record
    std::string sensor{};      // that read it; empty: the only one there is

    [[nodiscard]] bool shows_time() const { return measure == "time"; }
};

/// One record: what was read while one experiment ran once.
struct Record {
    std::string name;
    std::string condition;                       // records of one condition repeat each other
    std::filesystem::path file;                  // CSV
    std::vector<std::string> sets;               // "key=value": how this experiment differs from the scene
    std::function<void(scene::Scene&)> change{}; // of an experiment that is only planned
    bool held_out = false;                       // kept for measuring the gain, never fitted
    std::vector<double> time;                    // s, rising, on the instrument's clock
    std::vector<Channel> channels;

    /// Of numbers that stand for all of it, such as the height of a rebound: `time` is the one at which it ends.
    [[nodiscard]] bool single() const { return !channels.empty() && channels[0].take != Take::reading; }
};

/// A number of one measure over a stretch of time, usually its mean, and the mean of that over all runs that were made.
struct BulkNumber {
    std::string measure; // as BedNumberName joins it: "circulation", "q90 of tracer:sensor_vy"
    std::string unit;    // SI, as measures have it
    double value = 0;    // SI
    double sigma = 0;    // SI, standard deviation between runs; 0: not stated
};

/// What was measured of a bed of many bodies under one condition. No path in it repeats, so only means are compared.
struct Bulk {
    std::string condition;
    std::vector<std::string> sets;     // as a record's
    bool held_out = false;             // as a record's
    std::optional<double> from, until; // s, the stretch; without them the scene's settled one
    int runs = 1;                      // that were measured
    std::vector<BulkNumber> numbers;
    std::function<void(scene::Scene&)> change{}; // of a condition that is only planned
};

/// Something unknown but innocent, which every explanation may adjust: of a record a key of the scene or a part of the
/// instrument ("clock_offset"), of a bed the zero of a measure, as a camera that leans shifts it, or a cause of the
/// library. One of the four is not empty.
struct Nuisance {
    std::string key;
    std::string instrument;
    bool per_record = false;
    double spread = 0; // of what is known beforehand, in the key's own unit, else in SI; 0: nothing is known
    std::string measure{};
    std::string cause{};
    std::string sensor{}; // whose part of the instrument it is; empty: of all
    scene::Place place{}; // where it stands
};

struct Settings {
    double alpha_gate = 0.005;     // false alarms of the gate, one run of the library
    double alpha_adequacy = 0.005; // false alarms of the tests of adequacy together
    double margin = 3;             // nats over every rival
    double rival_window = 14;      // nats: worse causes are not fitted anew
    double same_class = 0.02;      // share of an effect that its rival leaves, below which both are one answer
    bool progressive = true;       // the baseline is fitted to growing parts of the records, not to all of them at once
    double fold_veto = 4;          // standard errors that an amplitude may move when one condition is left out
};

struct Measurement {
    std::filesystem::path file;
    std::string title;
    std::vector<std::string> causes; // ids or families; empty: all
    std::vector<Nuisance> nuisances;
    std::vector<Record> records; // or
    std::vector<Bulk> bulks;
    Settings settings;
    Problems warnings; // nothing that forbids a verdict, everything that a reader should know
    std::string hash;  // of the file and of its data
};

/// Words for what a single number is, in the order of Take, which has Take::reading before them.
const std::vector<std::string>& words_of_takes();

/// The keys of a measurement, in the same form as those of a scene.
const std::vector<scene::KeyTable>& measurement_keys();

/// Reads a measurement and the CSV files it names. Problems, all of them, each with its place: wrong TOML, unknown or
/// missing keys, files that are not there, columns that do not exist or are no numbers, time that does not rise,
/// columns equal to each other, units that a measure cannot have, measures and causes that do not exist; some columns
/// with a sensor and some without; both records and beds, or neither; a bed of which a single number is known.
Result<Measurement> load_measurement(const std::filesystem::path& file);

} // namespace tumble::diagnose

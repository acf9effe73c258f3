#pragma once

#include "base/books.h"
#include "base/problem.h"
#include "observe/bulk.h"
#include "observe/frame.h"
#include "observe/surface.h"

#include <string>
#include <vector>

namespace tumble::observe {

/// One instant with what several measures need of it, worked out once.
struct Seen {
    /// `axes_turned` as scene::Observe has it.
    Seen(const Frame& frame, const Books& books, double axes_turned = 0);

    const Frame& frame;
    const Books& books;
    BulkMotion bulk;
    Surface surface;
};

/// One number per instant, a column of series.csv.
struct Measure {
    std::string name;     // "circulation"
    std::string group;    // another name that chooses this one among others ("centre_of_mass"), or empty
    std::string unit;     // as in column heads: "J", "rad_s", "m_s", "" for a plain number
    std::string sentence; // what it is, for people
    double (*value)(const Seen&) = nullptr;

    /// "circulation_rad_s": the name with its unit.
    [[nodiscard]] std::string column() const;
};

/// "kinetic energy" for "kinetic_energy": names as people read them.
std::string spelled_name(std::string name);
/// "rad/s" for "rad_s", "m/s2" for "m_s2"; other units as they are.
std::string spelled_unit(const std::string& unit);

/// Every measure there is, in the order of `tumble list measures`.
const std::vector<Measure>& all_measures();

/// Names and groups that a scene may write.
std::vector<std::string> measure_names();

/// Those measured when a scene names none.
std::vector<std::string> usual_measures();

/// The measures of the given names and groups, in the order given, each once; the usual ones for an empty list.
/// Problems: a name that does not exist (with the nearest one that does), key "observe.measures".
Result<std::vector<Measure>> choose_measures(const std::vector<std::string>& names);

} // namespace tumble::observe

#include "excitation/show.h"

#include "base/text.h"
#include "excitation/figures.h"
#include "scene/to_toml.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tumble::excitation {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double standard_gravity = 9.80665; // m/s2
constexpr double far = 0.1;                  // m: walls do not move so far
const char* const axes = "xyz";

std::string order_name(int halves) {
    return halves % 2 == 0 ? std::to_string(halves / 2) : fmt::format("{}/2", halves);
}

std::string listed(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& one : all)
        text += (text.empty() ? "" : ", ") + one;
    return text;
}

void warn(sheet::Sheet& sheet, const Problems& warnings) {
    for (const Problem& warning : warnings)
        sheet.say("Warning: " + to_string(warning));
}

void say_speed(sheet::Sheet& sheet, const Excitation& found, const Settings& settings) {
    std::string text = fmt::format("The fundamental is {:.6g} Hz with a standard error of {}, {:.6g} turns a minute.",
                                   found.fundamental, format_si(found.fundamental_se, "Hz", 2), 60 * found.fundamental);
    sheet.fact("fundamental", found.fundamental, "Hz");
    sheet.fact("fundamental_se", found.fundamental_se, "Hz");
    if (const auto slip = slip_of(found.fundamental, settings.mains)) {
        const double share = 1 - found.fundamental / slip->synchronous;
        text += fmt::format(" An induction motor of {} pole pair{} on {:.4g} Hz mains turns its field at {:.4g} Hz and "
                            "would slip by {:.3g} %.",
                            slip->pole_pairs, slip->pole_pairs == 1 ? "" : "s", settings.mains, slip->synchronous,
                            100 * share);
        sheet.fact("slip", share);
    }
    if (found.lines.empty())
        return;
    text += settings.motor > 0 ? fmt::format(" It was looked for near {:.4g} Hz.", settings.motor)
                               : " It was taken to be the strongest line; `--motor_rpm` says otherwise.";
    sheet.say(text);
}

void show_lines(sheet::Sheet& sheet, const Record& record, const Excitation& found, const Settings& settings) {
    sheet::Grid grid{{{"line", "Hz", 6},
                      {"±", "Hz", 2},
                      {"what"},
                      {"axis"},
                      {"acceleration", "m/s2", 4},
                      {"±", "m/s2", 2},
                      {"displacement", "um", 4},
                      {"phase", "deg", 4},
                      {"±", "deg", 2}}};
    for (const Line& line : found.lines)
        for (std::size_t k = 0; k < line.on.size(); ++k) {
            if (!line.on[k].seen)
                continue;
            const auto u = displacement(line, k);
            grid.rows.push_back({line.frequency, line.frequency_se, name_of(line, settings.mains),
                                 record.channels[k].name, line.on[k].acceleration, line.on[k].acceleration_se,
                                 1e6 * std::abs(u), degrees * std::arg(u), degrees * line.on[k].phase_se});
        }
    sheet.parts.emplace_back(grid);
    sheet.say("± is one standard error. Displacement is acceleration over (2 π f)²; its phase is that of a sine that "
              "begins with the record, as a scene's harmonics have it. What one axis shows of a line below the noise "
              "is left out.");
}

void say_rest(sheet::Sheet& sheet, const Record& record, const Excitation& found, const Settings& settings) {
    std::string rest;
    for (std::size_t k = 0; k < record.channels.size(); ++k)
        rest += fmt::format("{}{} {:.3g} m/s2", k ? ", " : "", record.channels[k].name, found.noise[k]);
    sheet.say(fmt::format("The lines hold {:.5g} % of the power about the mean; what is left scatters by {} (standard "
                          "deviation).",
                          100 * found.explained, rest));
    sheet.fact("explained", found.explained);
    std::vector<std::string> half, mains, other, unclear;
    for (const Line& line : found.lines) {
        if (line.kind == Kind::order && line.halves % 2 == 1)
            half.push_back(order_name(line.halves));
        else if (line.kind == Kind::mains)
            mains.push_back(fmt::format("{:.5g}", line.frequency));
        else if (line.kind == Kind::other)
            other.push_back(fmt::format("{:.5g}", line.frequency));
        else if (line.kind == Kind::unclear)
            unclear.push_back(fmt::format("{:.5g}", line.frequency));
    }
    sheet.fact("half_orders", static_cast<double>(half.size()));
    sheet.fact("mains_lines", static_cast<double>(mains.size()));
    sheet.fact("other_lines", static_cast<double>(other.size()));
    if (!half.empty())
        sheet.say(fmt::format("Half orders ({}): something happens every second turn. A bed that lands every second "
                              "cycle does this, and so does play; only the bed is gone when the machine runs empty.",
                              listed(half)));
    if (!mains.empty())
        sheet.say(fmt::format("Mains ({} Hz): multiples of {:.4g} Hz that are no orders come through the cable or from "
                              "the motor's field; they are left out of the motion.",
                              listed(mains), settings.mains));
    if (!other.empty())
        sheet.say(fmt::format("No order and no mains ({} Hz): a mode of the machine, or another machine. Knock at it "
                              "when it stands still (`--hammer`) to know.",
                              listed(other)));
    if (!unclear.empty())
        sheet.say(fmt::format("Order or mains ({} Hz): the record's {} are too short to tell the two apart.",
                              listed(unclear), format_si(record.duration(), "s", 3)));
}

void say_size(sheet::Sheet& sheet, const Record& record, const Excitation& found) {
    const Line& first = found.first_order();
    double largest = 0;
    std::string sizes;
    for (std::size_t k = 0; k < record.channels.size(); ++k) {
        const double a = first.on[k].acceleration;
        largest = std::max(largest, std::abs(displacement(first, k)));
        sizes += fmt::format("{}{} {:.4g}", k ? ", " : "", record.channels[k].name, a / standard_gravity);
        sheet.fact(fmt::format("gamma_{}", record.channels[k].name), a / standard_gravity);
    }
    sheet.say(fmt::format("Peak acceleration of order 1 over gravity: {}.", sizes));
    if (largest > far)
        sheet.say(fmt::format("Warning: order 1 would move the wall by {}: are the units in the heads right?",
                              format_si(largest, "m", 3)));
}

void show_orbits(sheet::Sheet& sheet, const Record& record, const Excitation& found) {
    const Line& first = found.first_order();
    for (const auto& [across, up] : planes_of(record.channels)) {
        if (!first.on[across].seen || !first.on[up].seen)
            continue;
        const Orbit orbit = orbit_of(first, across, up);
        const char a = axes[record.channels[across].axis], b = axes[record.channels[up].axis];
        std::string text =
            fmt::format("{}-{}: half axes {} and {}, the long one {:.3g} deg from {} towards {}; {} leads {} by {:.4g} "
                        "± {:.2g} deg; ",
                        a, b, format_si(orbit.half_long, "m", 4), format_si(orbit.half_short, "m", 3),
                        degrees * orbit.tilt, a, b, b, a, degrees * orbit.phase, degrees * orbit.phase_se);
        text += orbit.is_open()
                    ? fmt::format("it turns from {} towards {} and encloses {:.4g} mm2.", orbit.area > 0 ? a : b,
                                  orbit.area > 0 ? b : a, 1e6 * std::abs(orbit.area))
                    : "within two standard errors a straight line.";
        sheet.say(text);
        sheet.fact(fmt::format("orbit_phase_{}{}", a, b), degrees * orbit.phase, "deg");
        sheet.fact(fmt::format("orbit_area_{}{}", a, b), 1e6 * orbit.area, "mm2");
        sheet.parts.emplace_back(orbit_figure(record, found, across, up));
    }
}

} // namespace

std::string name_of(const Line& line, double mains) {
    switch (line.kind) {
    case Kind::order:
        return "order " + order_name(line.halves);
    case Kind::mains:
        return fmt::format("mains, {} x {:.4g} Hz", line.multiple, mains);
    case Kind::unclear:
        return fmt::format("order {} or mains", order_name(line.halves));
    case Kind::other:
        break;
    }
    return "fits nothing";
}

sheet::Sheet show(const Record& record, const Excitation& found, const Settings& settings) {
    sheet::Sheet sheet;
    sheet.say(fmt::format("{}: {} samples in {}, one every {}.", record.file, record.time.size(),
                          format_si(record.duration(), "s", 4), format_si(record.step(), "s", 4)));
    warn(sheet, record.warnings);
    warn(sheet, found.warnings);
    sheet.head("Speed");
    say_speed(sheet, found, settings);
    sheet.head("Lines");
    show_lines(sheet, record, found, settings);
    say_rest(sheet, record, found, settings);
    sheet.parts.emplace_back(spectrum_figure(record, found));
    sheet.parts.emplace_back(record_figure(record, found));
    sheet.head("Orbit of order 1");
    say_size(sheet, record, found);
    show_orbits(sheet, record, found);
    return sheet;
}

void show_turns(sheet::Sheet& sheet, const std::vector<Turn>& turns, const Places& places) {
    sheet.head("Rocking");
    const char axis = axes[places.about];
    sheet::Grid grid{{{"line", "Hz", 6},
                      {"angle", "mrad", 4},
                      {"±", "mrad", 2},
                      {"phase", "deg", 4},
                      {"pivot x", "mm", 4},
                      {"y", "mm", 4},
                      {"z", "mm", 4},
                      {"±", "mm", 2},
                      {"misfit", "um", 3},
                      {"±", "um", 2}}};
    for (const Turn& turn : turns) {
        if (!turn.seen())
            continue;
        grid.rows.push_back({turn.frequency, 1e3 * std::abs(turn.angle), 1e3 * turn.angle_se,
                             degrees * std::arg(turn.angle), 1e3 * turn.pivot.x(), 1e3 * turn.pivot.y(),
                             1e3 * turn.pivot.z(), 1e3 * turn.pivot_se, 1e6 * turn.misfit, 1e6 * turn.misfit_se});
        if (turn.misfit > 4 * turn.misfit_se)
            sheet.say(fmt::format("Warning: at {:.5g} Hz the two places move towards each other by {}, which no rigid "
                                  "body does: the wall bends, or a sensor is loose or turned.",
                                  turn.frequency, format_si(turn.misfit, "m", 3)));
    }
    sheet.fact("rocking_lines", static_cast<double>(grid.rows.size()));
    if (grid.rows.empty()) {
        sheet.say(fmt::format("The two sensors move alike within the noise: no rocking about {} is seen.", axis));
        return;
    }
    sheet.fact("rocking_angle", std::get<double>(grid.rows.front()[1]), "mrad");
    sheet.parts.emplace_back(grid);
    sheet.say(
        fmt::format("Angle about {}, right-handed; the pivot is the point that moves least, what it still does is "
                    "written as harmonics. The misfit is what the two places do relative to each other and no "
                    "turning explains.",
                    axis));
}

sheet::Sheet show(const Record& record, const Ringing& ringing) {
    sheet::Sheet sheet;
    sheet.say(fmt::format("{}: {} samples in {}; {} knock{}, the first at {:.4g} s.", record.file, record.time.size(),
                          format_si(record.duration(), "s", 4), ringing.knocks.size(),
                          ringing.knocks.size() == 1 ? "" : "s", ringing.knocks.front()));
    warn(sheet, record.warnings);
    warn(sheet, ringing.warnings);
    sheet::Grid grid{{{"natural frequency", "Hz", 6}, {"±", "Hz", 2}, {"damping", "%", 3}, {"±", "%", 2}}};
    for (const Channel& channel : record.channels)
        grid.columns.push_back({"largest " + channel.name, "m/s2", 3});
    for (const Mode& mode : ringing.modes) {
        grid.rows.push_back({mode.frequency, mode.frequency_se, 100 * mode.damping, 100 * mode.damping_se});
        for (const double largest : mode.largest)
            grid.rows.back().emplace_back(largest);
        const auto index = grid.rows.size();
        sheet.fact(fmt::format("frequency_{}", index), mode.frequency, "Hz");
        sheet.fact(fmt::format("damping_{}", index), mode.damping);
    }
    sheet.parts.emplace_back(grid);
    sheet.say("Undamped frequencies; damping is the share of the critical one. Amplitudes are those at the knock that "
              "moved the mode most, carried back to its peak.");
    sheet.parts.emplace_back(ringing_figure(record, ringing));
    return sheet;
}

sheet::Sheet show(const BinnedLines& found, const std::string& source, const Settings& settings) {
    sheet::Sheet sheet;
    const Interval f = found.fundamental;
    sheet.say(
        fmt::format("{} is a list of lines, not a record. All its frequencies are multiples of {:.6g} Hz: bins of a "
                    "transform over {:.4g} s. A line of {:.5g} Hz may be anywhere within half a bin of that.",
                    source, found.bin, 1 / found.bin, found.nominal));
    sheet.head("The fundamental that the bins allow");
    sheet::Grid grid{{{"axis"}, {"printed", "Hz", 6}, {"bin"}, {"what"}, {"allows from", "Hz", 6}, {"to", "Hz", 6}}};
    std::vector<std::string> none;
    for (const BinnedLine& line : found.lines) {
        grid.rows.push_back({std::string(1, axes[line.axis]), line.frequency, std::to_string(line.bin)});
        auto& row = grid.rows.back();
        if (line.halves > 0) {
            const double bin = static_cast<double>(line.bin);
            row.insert(row.end(), {"order " + order_name(line.halves), (bin - 0.5) * found.bin * 2 / line.halves,
                                   (bin + 0.5) * found.bin * 2 / line.halves});
            continue;
        }
        const std::string what =
            line.multiple > 0 ? fmt::format("mains, {} x {:.4g} Hz", line.multiple, settings.mains) : "fits nothing";
        row.insert(row.end(), {what, "", ""});
        none.push_back(fmt::format("{:.6g} Hz ({})", line.frequency, what));
    }
    sheet.parts.emplace_back(grid);
    sheet.say(
        fmt::format("{} different bins agree on one fundamental, from {:.3f} to {:.3f} Hz ({:.1f} to {:.1f} turns a "
                    "minute). The printed {:.5g} Hz itself agrees with {}. Were every bin off by up to two either "
                    "way by chance, all would agree on any fundamental in {:.1e} of the cases.",
                    found.orders, f.lo, f.hi, 60 * f.lo, 60 * f.hi, found.nominal, found.at_nominal, found.chance));
    if (const auto slip = slip_of(0.5 * (f.lo + f.hi), settings.mains)) {
        sheet.say(
            fmt::format("A motor of {} pole pair{} on {:.4g} Hz mains has its field turn at {:.4g} Hz: it slips by "
                        "{:.2f} to {:.2f} %.",
                        slip->pole_pairs, slip->pole_pairs == 1 ? "" : "s", settings.mains, slip->synchronous,
                        100 * (1 - f.hi / slip->synchronous), 100 * (1 - f.lo / slip->synchronous)));
        sheet.fact("slip_lo", 1 - f.hi / slip->synchronous);
        sheet.fact("slip_hi", 1 - f.lo / slip->synchronous);
    }
    if (!none.empty())
        sheet.say("No order: " + listed(none) + ".");
    sheet.head("What the list cannot say");
    const double off_lo = f.lo / found.bin - std::round(found.nominal / found.bin);
    const double off_hi = f.hi / found.bin - std::round(found.nominal / found.bin);
    sheet.say(
        fmt::format("The fundamental lies {:.2f} to {:.2f} bins beside the middle of its own, so the printed "
                    "amplitude is low: by {:.0f} to {:.0f} % without a window, {:.0f} to {:.0f} % with Hann's, hardly "
                    "with a flat top. Phases were not kept: no motion can be written from this list. Fit the record "
                    "itself: `tumble excitation RECORD.csv`.",
                    std::abs(off_hi), std::abs(off_lo), 100 * (1 - shown_without_window(off_hi)),
                    100 * (1 - shown_without_window(off_lo)), 100 * (1 - shown_with_hann(off_hi)),
                    100 * (1 - shown_with_hann(off_lo))));
    sheet.fact("bin", found.bin, "Hz");
    sheet.fact("fundamental_lo", f.lo, "Hz");
    sheet.fact("fundamental_hi", f.hi, "Hz");
    sheet.fact("orders", static_cast<double>(found.orders));
    sheet.fact("orders_at_nominal", static_cast<double>(found.at_nominal));
    sheet.fact("chance", found.chance);
    return sheet;
}

std::string motion_text(const scene::WallMotion& motion, const Record& record, const Excitation& found) {
    return fmt::format(
               "# From {}: {} samples in {}, fundamental {:.6g} Hz. The scene's time {} s is the record's {} s.\n",
               record.file, record.time.size(), format_si(record.duration(), "s", 4), found.fundamental,
               motion.harmonics.empty() ? 0.0 : motion.harmonics.front().active.start, found.reference) +
           scene::to_toml(motion, 3);
}

} // namespace tumble::excitation

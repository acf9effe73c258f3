#include "diagnose/considered.h"

#include "observe/tracer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tumble::diagnose {

namespace {

/// A record has what it takes to show the cause.
bool can_show(const Record& record, const Cause& cause) {
    const auto any = [&](const auto& is_it) {
        return std::any_of(record.channels.begin(), record.channels.end(), is_it);
    };
    const auto inertial = [](const Channel& channel) {
        const auto traced = observe::traced_by(channel.measure);
        return traced && traced->inertial;
    };
    const auto of_its_sensor = [&](const Channel& channel) { return channel.sensor == cause.sensor; };
    return !(cause.over_time && record.single()) && (cause.sensor.empty() || any(of_its_sensor)) &&
           (!cause.inertial || any(inertial)) &&
           std::all_of(cause.needs.begin(), cause.needs.end(), [&](const std::string& measure) {
               return any([&](const Channel& channel) { return channel.measure == measure; });
           });
}

constexpr double zero_off = 0.05;     // of the largest reading, at most
constexpr double zero_wanders = 0.02; // of the largest reading, in a second, at most

/// A zero may be off by a share of what is read, whatever that is.
void widen(Cause& cause, const std::vector<Record>& records) {
    if (cause.range == Cause::Range::own)
        return;
    double most = 0;
    for (const Record& record : records)
        for (const Channel& channel : record.channels)
            for (const double value : channel.value)
                if (!record.held_out && !channel.shows_time() &&
                    (cause.sensor.empty() || channel.sensor == cause.sensor))
                    most = std::max(most, std::abs(value));
    cause.hi = std::max(cause.hi, (cause.range == Cause::Range::readings ? zero_off : zero_wanders) * most);
    cause.lo = -cause.hi;
}

/// Where several sensors read, each cause of the instrument once for each of them that can show it.
std::vector<Cause> for_each_sensor(const std::vector<Cause>& causes, const std::vector<Record>& records) {
    const std::set<std::string> sensors = sensors_of(records);
    if (sensors.size() < 2)
        return causes;
    std::vector<Cause> all;
    for (const Cause& cause : causes) {
        if (cause.physical()) {
            all.push_back(cause);
            continue;
        }
        for (const std::string& sensor : sensors) {
            Cause one = cause;
            one.sensor = sensor;
            one.id += " of " + sensor;
            one.name += ", of " + sensor;
            if (std::any_of(records.begin(), records.end(),
                            [&](const Record& record) { return can_show(record, one); }))
                all.push_back(std::move(one));
        }
    }
    return all;
}

} // namespace

std::set<std::string> sensors_of(const std::vector<Record>& records) {
    std::set<std::string> all;
    for (const Record& record : records)
        for (const Channel& channel : record.channels)
            all.insert(channel.sensor);
    return all;
}

Result<std::vector<Cause>> considered_in(const Measurement& measurement) {
    std::vector<Cause> chosen = *choose_causes(measurement.causes, Data::records), causes;
    for (Cause& cause : chosen) {
        const auto asked = [&](const std::string& word) { return word == cause.id || word == cause.family; };
        if (std::any_of(measurement.records.begin(), measurement.records.end(),
                        [&](const Record& record) { return can_show(record, cause); }))
            causes.push_back(std::move(cause));
        else if (std::any_of(measurement.causes.begin(), measurement.causes.end(), asked))
            return Problem{.file = measurement.file.string(),
                           .key = "causes",
                           .what = cause.over_time
                                       ? cause.id + " shows only in readings over time, and these are single numbers"
                                   : cause.inertial ? cause.id + " shows only in what an accelerometer in a body reads"
                                                    : fmt::format("{} shows only where one series has all of {}",
                                                                  cause.id, fmt::join(cause.needs, ", ")),
                           .fix = cause.over_time  ? "leave it out"
                                  : cause.inertial ? "leave it out, or give columns of a tracer: tracer:BODY_felt_x or "
                                                     "tracer:BODY_summed_vx, say"
                                                   : "leave it out, or measure them together"};
    }
    causes = for_each_sensor(causes, measurement.records);
    for (Cause& cause : causes)
        widen(cause, measurement.records);
    return causes;
}

} // namespace tumble::diagnose

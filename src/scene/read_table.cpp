#include "scene/read_table.h"

#include "base/text.h"
#include "scene/csv.h"
#include "scene/read_file.h"

#include <fmt/format.h>
#include <numbers>

namespace tumble::scene {
namespace {

constexpr std::size_t largest_table_file = 256ull * 1024 * 1024;
constexpr std::size_t most_harmonics = 10000;
constexpr double longest_time = 1e6; // s
constexpr double farthest = 100;     // m

} // namespace

Result<MotionTable> parse_motion_table(std::string_view text, const std::string& source) {
    Csv csv(source, "write the head t_s,x_m,y_m,z_m and rows of time (s, from 0, rising) and displacement (m)");
    MotionTable table;
    csv.read(text, {"t_s,x_m,y_m,z_m"}, [&](const std::vector<Field>& fields, int line) {
        const auto t = csv.number(fields[0], line, longest_time);
        Eigen::Vector3d displacement;
        bool right = t.has_value();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = csv.number(fields[k + 1], line, farthest);
            right = right && value;
            displacement[static_cast<Eigen::Index>(k)] = value.value_or(0);
        }
        if (!right)
            return;
        if (table.time.empty() && *t != 0)
            return csv.refuse(line, fields[0].column, fmt::format("the first time is {}, not 0", shortest(*t)));
        if (!table.time.empty() && !(*t > table.time.back()))
            return csv.refuse(line, fields[0].column,
                              fmt::format("time {} does not rise above {}", shortest(*t), shortest(table.time.back())));
        table.time.push_back(*t);
        table.displacement.push_back(displacement);
    });
    if (csv.problems().empty() && table.time.size() < 2)
        csv.refuse(0, 0, fmt::format("{} rows, a motion needs 2", table.time.size()));
    if (!csv.problems().empty())
        return csv.problems();
    return table;
}

Result<std::vector<Harmonic>> parse_harmonics(std::string_view text, const std::string& source) {
    Csv csv(source, "write the head axis,amplitude,period (and phase_deg) and rows such as y,1.949e-3,0.04; metres and "
                    "seconds");
    std::vector<Harmonic> harmonics;
    csv.read(text, {"axis,amplitude,period", "axis,amplitude,period,phase_deg"},
             [&](const std::vector<Field>& fields, int line) {
                 Harmonic one;
                 one.axis = fields[0].text == "x" ? 0 : fields[0].text == "y" ? 1 : fields[0].text == "z" ? 2 : -1;
                 if (one.axis < 0)
                     csv.refuse(line, fields[0].column,
                                fmt::format("'{}' is not an axis x, y or z", printable(fields[0].text)));
                 const auto amplitude = csv.number(fields[1], line, farthest);
                 const auto period = csv.number(fields[2], line, longest_time);
                 const auto phase = fields.size() > 3 ? csv.number(fields[3], line, 360) : 0.0;
                 if (period && !(*period >= 1e-6))
                     return csv.refuse(line, fields[2].column,
                                       fmt::format("the period {} is below 1e-6 s", shortest(*period)));
                 if (amplitude && *amplitude < 0)
                     return csv.refuse(line, fields[1].column,
                                       fmt::format("the amplitude {} is below 0", shortest(*amplitude)));
                 if (harmonics.size() >= most_harmonics)
                     return csv.refuse(line, 1, fmt::format("more than {} harmonics", most_harmonics));
                 one.amplitude = amplitude.value_or(0);
                 one.frequency = 1 / period.value_or(1);
                 one.phase = phase.value_or(0) * std::numbers::pi / 180;
                 harmonics.push_back(one);
             });
    if (csv.problems().empty() && harmonics.empty())
        csv.refuse(0, 0, "there is no harmonic in this file");
    if (!csv.problems().empty())
        return csv.problems();
    return harmonics;
}

Result<MotionTable> read_motion_table(const std::filesystem::path& file) {
    const auto text = read_file(file, largest_table_file);
    if (!text)
        return text.problems();
    return parse_motion_table(*text, file.string());
}

Result<std::vector<Harmonic>> read_harmonics(const std::filesystem::path& file) {
    const auto text = read_file(file, largest_table_file);
    if (!text)
        return text.problems();
    return parse_harmonics(*text, file.string());
}

} // namespace tumble::scene

#include "base/column.h"
#include "diagnose/misread.h"
#include "diagnose/noise.h"
#include "diagnose/warning_key.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double number_misses = 10;   // standard errors
constexpr double share_left = 0.04;    // of the squares, once they are exchanged
constexpr double about_a_radius = 0.1; // of it
constexpr double lowest_of_many = 4;   // scatters below
constexpr double clearly_less = 0.1;   // than a radius
constexpr double all_alike = 0.3;      // of a radius, that half of the heights are from the middle

} // namespace

std::vector<Misread> exchanged_numbers(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                                       const std::vector<std::vector<double>>& sigma) {
    struct Number {
        std::size_t index;
        const Record* record;
        double read, simulated, sigma;
    };
    std::vector<Number> numbers;
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < records.size(); ++r) {
        if (records[r].single() && records[r].channels.size() == 1 && sigma[r][0] > 0)
            numbers.push_back({r, &records[r], records[r].channels[0].value[0], predicted[row], sigma[r][0]});
        row += static_cast<Eigen::Index>(records[r].time.size() * records[r].channels.size());
    }
    const auto square = [](const Number& number, double simulated) {
        const double z = (number.read - simulated) / number.sigma;
        return z * z;
    };
    const auto far = [&](const Number& number) {
        return square(number, number.simulated) > number_misses * number_misses;
    };
    std::vector<Misread> misread;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t k = i + 1; k < numbers.size(); ++k) {
            const Number &one = numbers[i], &other = numbers[k];
            if (!far(one) || !far(other) || one.record->channels[0].measure != other.record->channels[0].measure)
                continue;
            const double before = square(one, one.simulated) + square(other, other.simulated);
            const double after = square(one, other.simulated) + square(other, one.simulated);
            if (after < share_left * before)
                misread.push_back({{one.index, other.index},
                                   {.file = one.record->file.string(),
                                    .key = warning_key::condition,
                                    .what = fmt::format("{} of '{}' and of '{}' agree with the simulation {:.0f} times "
                                                        "as well if they are exchanged",
                                                        one.record->channels[0].head, one.record->name,
                                                        other.record->name, std::sqrt(before / after)),
                                    .fix = "see whether two rows were mixed up"},
                                   std::sqrt(before / after),
                                   after / 2});
        }
    return misread;
}

std::optional<Problem> lowest_point(const std::vector<Record>& records, const Eigen::VectorXd& predicted,
                                    double radius) {
    std::vector<double> below, lower; // m: all readings; the lowest of each series
    double scatter = 0;               // m, of a reading
    const Record* first = nullptr;
    Eigen::Index row = 0;
    for (const Record& record : records)
        for (const Channel& channel : record.channels) {
            const auto count = static_cast<Eigen::Index>(channel.value.size());
            const auto simulated = predicted.segment(row, count);
            row += count;
            if (channel.measure != "centre_of_mass_y")
                continue;
            first = first ? first : &record;
            for (Eigen::Index k = 0; k < count; ++k)
                below.push_back(simulated[k] - channel.value[static_cast<std::size_t>(k)]);
            if (!record.single()) {
                scatter = std::max(scatter, channel.sigma > 0 ? channel.sigma : scatter_of(channel));
                lower.push_back(simulated.minCoeff() - *std::min_element(channel.value.begin(), channel.value.end()));
            }
        }
    const auto a_radius = [&](double way) { return std::abs(way / radius - 1) < about_a_radius; };
    const auto a_radius_and_scatter = [&](double way) { // the lowest of many readings lies low by chance, too
        return way > (1 - about_a_radius) * radius && way < (1 + about_a_radius) * radius + lowest_of_many * scatter;
    };
    std::vector<double> off;
    for (const double way : below)
        off.push_back(std::abs(way - median(below)));
    const bool all = !below.empty() && a_radius(median(below)) && median(off) < all_alike * radius;
    if (!all && (lower.empty() || scatter > clearly_less * radius ||
                 !std::all_of(lower.begin(), lower.end(), a_radius_and_scatter)))
        return std::nullopt;
    return Problem{
        .file = first->file.string(),
        .key = warning_key::lowest_point,
        .what = fmt::format("heights are {:.3g} mm too low {}, and the ball's radius is {:.3g} mm: are they those of "
                            "its lowest point?",
                            1e3 * median(all ? below : lower), all ? "in the middle of all" : "where they are lowest",
                            1e3 * radius),
        .fix =
            all ? "centre_of_mass_y is the centre's: add the radius"
                : "centre_of_mass_y is the centre's: add the radius, to the height at which the scene lets it go too"};
}

} // namespace tumble::diagnose

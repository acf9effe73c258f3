#include "diagnose/noise_doubts.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::diagnose {

namespace {

constexpr double far_too_large = 0.05; // a sigma that readings scatter so much less than

bool states_scatter_of(const Model& model, const std::string& measure) {
    return std::any_of(model.rows().begin(), model.rows().end(), [&](const Row& row) {
        const Channel& channel = model.channel_of(row);
        return channel.measure == measure && channel.sigma > 0;
    });
}

} // namespace

void doubt_noise(const NoiseReport& noise, const Model& model, const std::filesystem::path& file, Problems& warnings) {
    for (const auto& [measure, one] : noise.of) {
        const std::string whose = noise.of.size() > 1 ? " of " + measure : "";
        if (one.kept > 0)
            warnings.push_back({.file = file.string(),
                                .key = "hardly any noise",
                                .what = fmt::format("readings{} scatter {:.2g} times as much as stated, as those of a "
                                                    "simulation would",
                                                    whose, one.kept),
                                .fix = "nothing: the scatter stated is used"});
        if (states_scatter_of(model, measure) && (one.ratio > 1.25 || one.ratio < 0.8))
            warnings.push_back(
                {.file = file.string(),
                 .key = "sigma contradicted",
                 .what = fmt::format("readings{} scatter {:.2f} times as much as stated", whose, one.ratio),
                 .fix = one.ratio < far_too_large
                            ? "the scatter found in the readings is used; is sigma in the unit of "
                              "the column's head?"
                            : "the scatter found in the readings is used"});
        if (one.correlation > 0.08)
            warnings.push_back(
                {.file = file.string(),
                 .key = "noise not white",
                 .what = fmt::format("errors of neighbouring readings{} correlate by {:.2f}", whose, one.correlation),
                 .fix = "nothing: readings are weighted for it"});
    }
    if (noise.widened > 1)
        warnings.push_back(
            {.file = file.string(),
             .key = "repeats differ",
             .what = fmt::format("records of one condition differ by {:.2f} times what their readings scatter, and "
                                 "as causes would do by {:.2f} times",
                                 noise.repeats, noise.along),
             .fix = "something changes from run to run: give it as a nuisance with per = \"series\"; all errors are "
                    "stated that much larger"});
    if (noise.left_out > 0)
        warnings.push_back({.file = file.string(),
                            .key = "outliers",
                            .what = fmt::format("{} lone reading(s) stand out of their neighbours", noise.left_out),
                            .fix = noise.left_out > 0.02 * static_cast<double>(model.rows().size())
                                       ? "too many to be slips: all are used"
                                       : "they are left out"});
}

std::optional<Problem> simulated_readings(const Noise& found, const Model& model) {
    for (std::size_t r = 0; r < model.records().size(); ++r)
        for (std::size_t c = 0; c < model.records()[r].channels.size(); ++c)
            if (const Channel& channel = model.records()[r].channels[c];
                channel.sigma == 0 && hardly_scatters(channel, found.sigma[r][c]))
                return Problem{.file = model.records()[r].file.string(),
                               .key = "series.column.sigma",
                               .what = fmt::format("{} has no sigma, and hardly scatters (by {:.1g} {}), as what was "
                                                   "simulated does",
                                                   channel.head, found.sigma[r][c], channel.unit),
                               .fix = "state sigma, what a reading of it may be wrong by"};
    return std::nullopt;
}

void doubt_hum(const VectorXd& residual, const std::vector<Course>& courses, const std::filesystem::path& file,
               Problems& warnings) {
    const auto hum = mains_hum(residual, courses);
    if (hum && hum->p < shown_hum)
        warnings.push_back(
            {.file = file.string(),
             .key = "mains hum",
             .what = fmt::format("readings of {} swing at {:.3g} Hz by {:.2f} of their scatter, as mains "
                                 "of 50 or 60 Hz do at this rate of readings",
                                 hum->measure, hum->frequency, hum->amplitude),
             .fix = "nothing: no cause swings like it, and it counts as scatter"});
}

} // namespace tumble::diagnose

#include "diagnose/curves.h"

#include "scene/settled.h"

#include <cmath>
#include <set>

namespace tumble::diagnose {

std::vector<Curve> curves_of(Model& model, const Noise& noise, const VectorXd& at_baseline, const VectorXd* extended) {
    const auto baseline = model.predict(at_baseline);
    const auto with = extended ? model.predict(*extended) : baseline;
    std::vector<Curve> curves;
    if (!baseline || !with)
        return curves;
    Eigen::Index row = 0;
    for (std::size_t r = 0; r < model.records().size(); ++r) {
        const Record& record = model.records()[r];
        const auto scene = model.scene_at(at_baseline, static_cast<int>(r));
        const scene::Vibration shaken = scene ? scene::slowest_vibration(*scene) : scene::Vibration{};
        for (std::size_t c = 0; c < record.channels.size(); ++c) {
            const Channel& channel = record.channels[c];
            const double late = model.instrument_at(at_baseline, static_cast<int>(r), channel).clock_offset;
            Curve curve{.record = record.name,
                        .condition = record.condition,
                        .head = channel.head,
                        .unit = channel.unit,
                        .sigma = noise.sigma[r][c],
                        .time = record.time,
                        .measured = channel.value,
                        .baseline = {},
                        .extended = {},
                        .left_out = {},
                        .measure = channel.measure,
                        .stated = std::isinf(channel.degrees) ? channel.sigma : 0,
                        .shaken = shaken.period,
                        .shaken_from = shaken.from + late};
            for (std::size_t k = 0; k < record.time.size(); ++k, ++row) {
                curve.baseline.push_back((*baseline)[row]);
                curve.left_out.push_back(noise.left_out[static_cast<std::size_t>(row)]);
                if (extended)
                    curve.extended.push_back((*with)[row]);
            }
            curves.push_back(std::move(curve));
        }
    }
    return curves;
}

std::vector<Cut> cuts_of(Model& model, const VectorXd& values) {
    std::vector<Cut> cuts;
    std::set<std::string> heads;
    for (std::size_t r = 0; r < model.records().size(); ++r)
        for (const Channel& channel : model.records()[r].channels) {
            const double share = model.instrument_at(values, static_cast<int>(r), channel).clipping;
            if (share == 0 || channel.shows_time() || !heads.insert(channel.head).second)
                continue;
            if (const auto ranges = model.ranges_at(values))
                cuts.push_back(
                    {channel.head, channel.unit, (1 - share) * ranges->at({channel.measure, channel.sensor})});
        }
    return cuts;
}

} // namespace tumble::diagnose

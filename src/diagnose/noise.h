#pragma once

#include "diagnose/model.h"

namespace tumble::diagnose {

/// How the readings of one measure scatter: a height read from a picture otherwise than the clock beside it.
struct NoiseOfMeasure {
    double ratio = 1;       // scatter of the residual over the noise before
    double correlation = 0; // from one reading to the next
    double kept = 0;        // the ratio found, where the scatter stated was kept all the same; 0: it was not
};

/// Scatter of the readings: a standard deviation for each channel of each record, how much of one reading's error is
/// still in the next (AR(1)), and readings that are left out.
struct Noise {
    std::vector<std::vector<double>> sigma;     // SI, [record][channel]
    std::map<std::string, NoiseOfMeasure> of{}; // by measure, a correlation below 0.08 as none; empty: nothing is known
    std::vector<bool> left_out;                 // per row of the model

    /// Readings of scatter 1 that do not depend on each other; rows beyond the horizon and those left out become 0.
    [[nodiscard]] MatrixXd whiten(const MatrixXd& columns, const Model& model, double horizon = 1) const;
};

/// Of readings over time, by their second differences, which scatter sqrt(6) times as much where noise is white; the
/// median leaves kinks of the motion aside.
double scatter_of(const Channel& channel);

/// A scatter, SI, that is next to nothing of what a series spans: no instrument is that good, and the least difference
/// between two ways of simulating would be an effect.
bool hardly_scatters(const Channel& channel, double sigma);

/// What is known before any fit: the sigma stated, else from the second differences of the readings.
Noise first_noise(const Model& model);

struct NoiseReport {
    double stated = 0; // SI, mean over the channels of the first measure that state it; 0: none does
    double used = 0;   // SI, of the same; of all where none does
    std::map<std::string, NoiseOfMeasure> of{};
    double above = 1;   // the largest scatter of a measure over what was known of it before, stated or seen
    int left_out = 0;   // readings
    double repeats = 0; // scatter between records of one condition over the noise used before; 0: nothing repeats
    double along = 0;   // the same of what differs between them as the effect of some cause would
    double widened = 1; // factor on every sigma for that
};

/// Scatter between records that repeat each other (one condition, the same times), over what the noise says: pure
/// error, whatever the simulation gets wrong in all of them alike. 0 where nothing repeats.
struct Repeats {
    double scatter = 0; // of all readings
    double chance = 1;  // tail probability of so much
    double along = 0;   // of what causes would do: a few numbers of each record, which more readings do not make surer
    double along_chance = 1;
};

/// `adjusted`: whitened slopes of the nuisances that every record has its own of; `effects`: those of causes.
Repeats repeats_in(const Noise& noise, const Model& model, const VectorXd& misfit, const MatrixXd& adjusted,
                   const MatrixXd& effects);

/// The noise that the residual shows once every direction that an effect could take is projected out of it: `explained`
/// are the whitened columns of those directions; every measure by itself. A correlation below 0.08 counts as none. Lone
/// readings that stand out of their neighbours by 6 standard deviations are left out, unless there are more than 2 % of
/// them.
Noise refined_noise(const Noise& before, const Model& model, const VectorXd& misfit, const MatrixXd& explained,
                    NoiseReport& report);

} // namespace tumble::diagnose

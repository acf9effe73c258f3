#include "reduce/price.h"

#include "base/distributions.h"

#include <algorithm>
#include <cmath>

namespace tumble::reduce {

namespace {

std::vector<double> of_quantity(const Sample& sample, std::size_t quantity) {
    std::vector<double> values;
    for (const std::vector<double>& seed : sample.values)
        values.push_back(seed[quantity]);
    return values;
}

/// What single runs of one scene scatter by, over all rungs: two seeds alone say too little of it.
struct Pool {
    double variance = 0;
    int degrees = 0;
};

Pool pooled(const std::vector<Sample>& samples, std::size_t quantity) {
    Pool pool;
    for (const Sample& sample : samples) {
        const Spread spread = spread_of(of_quantity(sample, quantity));
        const int degrees = static_cast<int>(sample.values.size()) - 1;
        if (degrees < 1 || !std::isfinite(spread.mean))
            continue;
        pool.variance += degrees * spread.deviation * spread.deviation;
        pool.degrees += degrees;
    }
    if (pool.degrees > 0)
        pool.variance /= pool.degrees;
    return pool;
}

struct Mean {
    double value = 0;
    double variance = 0; // of the mean
    double degrees = 0;  // of freedom, that the variance is known with
    bool pooled = false; // the variance is that of all rungs

    /// Half of its 95 % interval.
    [[nodiscard]] double reach() const;
};

/// Half of a 95 % interval, in standard errors.
double t_of(double degrees) {
    return degrees >= 1 ? student_quantile(0.025, std::floor(degrees)) : std::numeric_limits<double>::infinity();
}

double Mean::reach() const {
    return t_of(degrees) * std::sqrt(variance);
}

Mean mean_of(const Sample& sample, std::size_t quantity, const Pool& pool) {
    const Spread spread = spread_of(of_quantity(sample, quantity));
    const double seeds = static_cast<double>(sample.values.size()), own = spread.deviation * spread.deviation;
    if (seeds >= seeds_to_be_sure || (seeds > 1 && own > pool.variance))
        return {spread.mean, own / seeds, seeds - 1, false};
    return {spread.mean, pool.variance / seeds, static_cast<double>(pool.degrees), true};
}

/// Of what is made of two means: Welch and Satterthwaite, where they do not share one estimate.
double degrees_of(const Mean& a, const Mean& b) {
    const double sum = a.variance + b.variance;
    return sum > 0 && !(a.pooled && b.pooled)
               ? sum * sum / (a.variance * a.variance / a.degrees + b.variance * b.variance / b.degrees)
               : std::min(a.degrees, b.degrees);
}

/// Of a ratio of two means, E. C. Fieller, J. R. Stat. Soc. B 16 (1954), 175.
Error error_of(const Mean& mean, const Mean& reference) {
    const double t = t_of(degrees_of(mean, reference)), size = std::abs(reference.value);
    const double ratio = mean.value / reference.value;
    Error error{.relative = (mean.value - reference.value) / size};
    const double g = t * t * reference.variance / (size * size);
    if (!std::isfinite(ratio) || !(g < 1))
        return error;
    const double half = t / size * std::sqrt(mean.variance * (1 - g) + ratio * ratio * reference.variance) / (1 - g);
    error.uncertainty = half + std::abs(ratio) * g / (1 - g); // the interval's middle is ratio / (1 - g)
    return error;
}

/// What the reference may have nothing of.
Error error_beside_zero(const Mean& mean, const Mean& reference) {
    const double reach = t_of(degrees_of(mean, reference)) * std::sqrt(mean.variance + reference.variance);
    const double most = std::abs(reference.value) + reference.reach();
    const double surely = std::abs(mean.value - reference.value) - reach;
    return {.at_least = surely > 0 && most > 0 ? surely / most : 0};
}

Verdict judge(const Error& error, double tolerance, bool enough_seeds, bool lost_by_all) {
    const double size = std::abs(error.relative);
    if (!std::isfinite(size))
        return lost_by_all ? Verdict::beyond : Verdict::seems_beyond;
    if (size - error.uncertainty > tolerance)
        return Verdict::beyond;
    if (enough_seeds && size + error.uncertainty <= tolerance)
        return Verdict::within;
    return size <= tolerance ? Verdict::seems_within : Verdict::seems_beyond;
}

/// No seed has the quantity.
bool lost_by_all(const Sample& sample, std::size_t quantity) {
    return std::none_of(sample.values.begin(), sample.values.end(),
                        [&](const std::vector<double>& seed) { return std::isfinite(seed[quantity]); });
}

bool enough_seeds(const Sample& sample) {
    return sample.values.size() >= seeds_to_be_sure;
}

/// Of that verdict, faster than the reference; nothing where nothing was judged.
std::optional<std::size_t> fastest_of(const Prices& prices, std::size_t reference, Verdict verdict) {
    std::optional<std::size_t> fastest;
    if (std::find(prices.judged.begin(), prices.judged.end(), true) == prices.judged.end())
        return fastest;
    double most = 1;
    for (std::size_t i = 0; i < prices.rungs.size(); ++i)
        if (i != reference && prices.rungs[i].verdict == verdict && prices.rungs[i].speed_up > most) {
            most = prices.rungs[i].speed_up;
            fastest = i;
        }
    return fastest;
}

} // namespace

bool Error::told_apart() const {
    return std::abs(relative) > uncertainty;
}

const char* word_of(Verdict verdict) {
    constexpr const char* words[] = {"not judged", "within", "seems within", "seems beyond", "beyond"};
    return words[static_cast<int>(verdict)];
}

Prices price(const std::vector<Sample>& samples, std::size_t reference, double tolerance) {
    Prices prices;
    prices.rungs.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        prices.rungs[i].speed_up = samples[reference].core_s / samples[i].core_s;
    const std::size_t quantities = samples[reference].values.front().size();
    for (std::size_t q = 0; q < quantities; ++q) {
        const Pool pool = pooled(samples, q);
        const Mean of_reference = mean_of(samples[reference], q, pool);
        prices.reference_spread.push_back(of_reference.reach());
        prices.judged.push_back(std::abs(of_reference.value) > of_reference.reach());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            Price& rung = prices.rungs[i];
            rung.spreads.push_back(spread_of(of_quantity(samples[i], q)));
            Error& error = rung.errors.emplace_back();
            const Mean mean = mean_of(samples[i], q, pool);
            if (i == reference) {
                error = {0, 0};
            } else if (prices.judged[q]) {
                error = error_of(mean, of_reference);
                const bool enough = enough_seeds(samples[i]) && enough_seeds(samples[reference]);
                rung.worst =
                    std::max(rung.worst, std::isfinite(error.relative) ? std::abs(error.relative)
                                                                       : std::numeric_limits<double>::infinity());
                rung.verdict = std::max(rung.verdict, judge(error, tolerance, enough, lost_by_all(samples[i], q)));
            } else {
                error = error_beside_zero(mean, of_reference);
                if (error.at_least > tolerance)
                    rung.verdict = Verdict::beyond;
            }
        }
    }
    prices.cheapest = fastest_of(prices, reference, Verdict::within);
    if (!prices.cheapest)
        prices.cheapest = fastest_of(prices, reference, Verdict::seems_within);
    return prices;
}

} // namespace tumble::reduce

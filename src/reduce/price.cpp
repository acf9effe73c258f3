#include "reduce/price.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tumble::reduce {

namespace {

/// P(|t| < value), Abramowitz and Stegun 26.7.3 and 26.7.4.
double student_inside(double value, int degrees) {
    const double angle = std::atan(value / std::sqrt(degrees)), cosine = std::cos(angle), sine = std::sin(angle);
    double term = degrees % 2 == 0 ? 1 : cosine, sum = degrees == 1 ? 0 : term;
    for (int k = degrees % 2 == 0 ? 2 : 3; k <= degrees - 2; k += 2) {
        term *= cosine * cosine * (k - 1) / k;
        sum += term;
    }
    return degrees % 2 == 0 ? sine * sum : 2 / std::numbers::pi * (angle + sine * sum);
}

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

/// Variance of a mean; of a rung that scatters more than the others by its own scatter.
double variance_of_mean(const Spread& spread, std::size_t seeds, const Pool& pool) {
    return std::max(spread.deviation * spread.deviation, pool.variance) / static_cast<double>(seeds);
}

Verdict judge(const Error& error, double tolerance) {
    const double size = std::abs(error.relative);
    if (!std::isfinite(size) || size - error.uncertainty > tolerance)
        return Verdict::beyond;
    if (size + error.uncertainty <= tolerance)
        return Verdict::within;
    return size <= tolerance ? Verdict::seems_within : Verdict::seems_beyond;
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
    constexpr const char* words[] = {"within", "seems within", "seems beyond", "beyond"};
    return words[static_cast<int>(verdict)];
}

Spread spread_of(const std::vector<double>& values) {
    Spread spread;
    const auto n = static_cast<double>(values.size());
    for (const double value : values)
        spread.mean += value / n;
    for (const double value : values)
        spread.deviation += (value - spread.mean) * (value - spread.mean);
    spread.deviation = values.size() > 1 ? std::sqrt(spread.deviation / (n - 1)) : 0;
    return spread;
}

double student_t_95(int degrees) {
    double lo = 0, hi = 20; // 12.7 for one degree
    for (int k = 0; k < 60; ++k) {
        const double middle = (lo + hi) / 2;
        (student_inside(middle, degrees) < 0.95 ? lo : hi) = middle;
    }
    return lo;
}

Prices price(const std::vector<Sample>& samples, std::size_t reference, double tolerance) {
    Prices prices;
    prices.rungs.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        prices.rungs[i].speed_up = samples[reference].core_s / samples[i].core_s;
    const std::size_t quantities = samples[reference].values.front().size();
    for (std::size_t q = 0; q < quantities; ++q) {
        const Pool pool = pooled(samples, q);
        const double t = pool.degrees > 0 ? student_t_95(pool.degrees) : std::numeric_limits<double>::infinity();
        const Spread of_reference = spread_of(of_quantity(samples[reference], q));
        const double own = variance_of_mean(of_reference, samples[reference].values.size(), pool);
        prices.reference_spread.push_back(t * std::sqrt(own));
        prices.judged.push_back(std::abs(of_reference.mean) > prices.reference_spread.back());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            Price& rung = prices.rungs[i];
            rung.spreads.push_back(spread_of(of_quantity(samples[i], q)));
            rung.errors.emplace_back();
            if (i == reference)
                rung.errors.back() = {0, 0};
            if (i == reference || !prices.judged[q])
                continue;
            const double both = own + variance_of_mean(rung.spreads.back(), samples[i].values.size(), pool);
            const double size = std::abs(of_reference.mean);
            Error& error = rung.errors.back();
            error.relative = (rung.spreads.back().mean - of_reference.mean) / size;
            error.uncertainty =
                std::isfinite(error.relative) ? t * std::sqrt(both) / size : std::numeric_limits<double>::infinity();
            rung.worst = std::max(rung.worst, std::isfinite(error.relative) ? std::abs(error.relative)
                                                                            : std::numeric_limits<double>::infinity());
            rung.verdict = std::max(rung.verdict, judge(error, tolerance));
        }
    }
    prices.cheapest = fastest_of(prices, reference, Verdict::within);
    if (!prices.cheapest)
        prices.cheapest = fastest_of(prices, reference, Verdict::seems_within);
    return prices;
}

} // namespace tumble::reduce

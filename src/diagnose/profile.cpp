#include "diagnose/profile.h"

#include <algorithm>
#include <cmath>

namespace tumble::diagnose {

namespace {

constexpr int most_tries = 8;
constexpr double near_enough = 0.02; // of the way that chi-square's root has to rise
constexpr double farthest = 3;       // times as far in one try

/// Chi-square along one amplitude, all else adjusted by slopes.
class Profile {
public:
    Profile(const Refit& fitted, const std::vector<int>& free, std::size_t which, Model& model, const Noise& noise)
        : fitted_(fitted), free_(free), model_(model), noise_(noise),
          own_(fitted.slopes.cols() - static_cast<Eigen::Index>(fitted.causes.size() - which)), others_(others()),
          projector_(others_), least_(projector_.out(fitted.residual).squaredNorm()) {
        if (others_.cols() > 0)
            follows_ = -others_.colPivHouseholderQr().solve(VectorXd(fitted.slopes.col(own_)));
    }

    [[nodiscard]] const Parameter& parameter() const {
        return model_.parameters()[static_cast<std::size_t>(free_[static_cast<std::size_t>(own_)])];
    }

    /// How much it lies above the least, so far away from there; nothing where that cannot be simulated.
    std::optional<double> rise(double away) {
        VectorXd values = fitted_.values;
        Eigen::Index other = 0;
        for (Eigen::Index k = 0; k < fitted_.slopes.cols(); ++k) {
            const int index = free_[static_cast<std::size_t>(k)];
            const Parameter& one = model_.parameters()[static_cast<std::size_t>(index)];
            const double by = k == own_ ? away : away * follows_[other++];
            values[index] = std::clamp(values[index] + by, one.lo, one.hi);
        }
        const auto residual = residual_at(model_, noise_, values);
        return residual ? std::optional(projector_.out(*residual).squaredNorm() - least_) : std::nullopt;
    }

private:
    [[nodiscard]] MatrixXd others() const {
        MatrixXd others(fitted_.slopes.rows(), fitted_.slopes.cols() - 1);
        others << fitted_.slopes.leftCols(own_), fitted_.slopes.rightCols(fitted_.slopes.cols() - own_ - 1);
        return others;
    }

    const Refit& fitted_;
    const std::vector<int>& free_;
    Model& model_;
    const Noise& noise_;
    Eigen::Index own_; // column of the slopes
    MatrixXd others_;
    Projector projector_;
    double least_;
    VectorXd follows_; // of the others, per unit of the amplitude
};

/// How far away the limit of that side is, 1 or -1; nothing where it could not be found.
std::optional<double> way_to_limit(Profile& profile, double side, double linear, double room, double reach) {
    struct Point {
        double way, short_of; // of standard errors
    } below{0, reach}, above{0, -1};
    double way = std::min(linear, room);
    for (int k = 0; k < most_tries; ++k) {
        const auto rise = profile.rise(side * way);
        if (!rise)
            return std::nullopt;
        const Point now{way, reach - std::sqrt(std::max(0.0, *rise))};
        if (std::abs(now.short_of) < near_enough * reach || (now.short_of > 0 && way == room))
            return way;
        (now.short_of > 0 ? below : above) = now;
        if (above.way > 0) // between the two, straight, but not too near to either
            way = below.way +
                  (above.way - below.way) * std::clamp(below.short_of / (below.short_of - above.short_of), 0.1, 0.9);
        else
            way = std::min(room, way * std::min(farthest, reach / std::max(reach - now.short_of, 1e-9)));
    }
    return std::nullopt;
}

} // namespace

std::vector<Limits> profile_of(const Refit& fitted, const Fit& baseline, Model& model, const Noise& noise,
                               double reach) {
    if (fitted.values.size() == 0)
        return {};
    std::vector<int> free = baseline.free;
    for (const int cause : fitted.causes)
        free.push_back(model.parameter_of(cause));
    std::vector<Limits> all;
    for (std::size_t k = 0; k < fitted.causes.size(); ++k) {
        Profile profile(fitted, free, k, model, noise);
        const auto i = static_cast<Eigen::Index>(k);
        const double at = fitted.amplitude[i], linear = reach * fitted.error[i];
        const double below = at - profile.parameter().lo, above = profile.parameter().hi - at;
        const auto low = way_to_limit(profile, -1, linear, below, reach);
        const auto high = way_to_limit(profile, 1, linear, above, reach);
        all.push_back(
            {at - low.value_or(std::min(linear, below)), at + high.value_or(std::min(linear, above)), !low || !high});
    }
    return all;
}

} // namespace tumble::diagnose

#include "separation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace blind {

namespace {

constexpr int iterations = 12;
constexpr double enough = 1e-3;      // fall of chi-square that ends a fit
constexpr std::size_t close = 4;     // rivals that are fitted: the nearest ones by slopes
constexpr double same_answer = 0.02; // share of an effect that its rival leaves, below which it is none
constexpr double borne_by_one = 0.9; // of an effect's squares, in one record: no other bears its name out
constexpr double disbelieved = 1e3;  // spreads: farther than any experiment is long
constexpr double nudge = 1e-5;       // of everything innocent, for slopes

/// Readings without noise, and those of them that nobody would use.
struct Data {
    Eigen::VectorXd readings;
    std::vector<bool> left_out;
};

/// What is innocent, adjusted from where it is known to be, and the amplitude of a rival.
class Explanation {
public:
    Explanation(const Setup& setup, const Truth& base, const Effect* rival, const Data& data)
        : setup_(setup), base_(base), rival_(rival), data_(data), innocents_(innocents_of(setup)),
          count_(static_cast<Eigen::Index>(innocents_.size())) {}

    /// Whatever was said of this kind of innocents beforehand; false where there is none of the kind.
    bool disbelieve(Innocent::Kind kind) {
        bool any = false;
        for (Innocent& one : innocents_)
            if (one.kind == kind) {
                one.spread *= disbelieved;
                any = true;
            }
        return any;
    }

    [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& p) const {
        Truth truth = base_;
        const Eigen::Index rows = data_.readings.size();
        Eigen::VectorXd all(rows + count_);
        for (Eigen::Index k = 0; k < count_; ++k) {
            innocents_[static_cast<std::size_t>(k)].add(truth, p[k]);
            all[rows + k] = -p[k] / innocents_[static_cast<std::size_t>(k)].spread;
        }
        if (rival_ && p[count_] != 0)
            rival_->hide(truth, p[count_]);
        all.head(rows) = whitened(setup_, data_.readings - readings_of(setup_, truth));
        for (std::size_t k = 0; k < data_.left_out.size(); ++k)
            if (data_.left_out[k])
                all[static_cast<Eigen::Index>(k)] = 0;
        return all;
    }

    [[nodiscard]] Eigen::VectorXd start() const { return Eigen::VectorXd::Zero(count_ + (rival_ ? 1 : 0)); }

    [[nodiscard]] Eigen::MatrixXd slopes(const Eigen::VectorXd& p) const {
        Eigen::MatrixXd all(data_.readings.size() + count_, p.size());
        for (Eigen::Index k = 0; k < p.size(); ++k) {
            const double width = k == count_ ? 0.05 * rival_->typical : nudge;
            Eigen::VectorXd above = p, below = p;
            above[k] += width;
            if (!(k == count_ && rival_->one_sided && p[k] < width))
                below[k] -= width;
            all.col(k) = (residual(below) - residual(above)) / (above[k] - below[k]);
        }
        return all;
    }

    /// Least chi-square, by damped steps from `p`.
    [[nodiscard]] double least(Eigen::VectorXd p) const {
        Eigen::VectorXd now = residual(p);
        for (int k = 0; k < iterations; ++k) {
            const Eigen::VectorXd step = slopes(p).colPivHouseholderQr().solve(now);
            double fall = 0;
            for (double part = 1; part > 0.02 && fall <= 0; part /= 3) {
                Eigen::VectorXd next = p + part * step;
                if (rival_ && rival_->one_sided)
                    next[next.size() - 1] = std::max(0.0, next[next.size() - 1]);
                const Eigen::VectorXd then = residual(next);
                fall = now.squaredNorm() - then.squaredNorm();
                if (fall > 0) {
                    p = next;
                    now = then;
                }
            }
            if (fall < enough)
                break;
        }
        return now.squaredNorm();
    }

private:
    const Setup& setup_;
    const Truth& base_;
    const Effect* rival_;
    const Data& data_;
    std::vector<Innocent> innocents_;
    Eigen::Index count_;
};

} // namespace

Separation separation_of(const Setup& setup, const Truth& truth, const Truth& without, const std::string& own) {
    Data data{readings_of(setup, truth), {}};
    Eigen::VectorXd changed = data.readings - readings_of(setup, without);
    data.left_out = lone(setup, changed);
    for (std::size_t k = 0; k < data.left_out.size(); ++k)
        if (data.left_out[k])
            changed[static_cast<Eigen::Index>(k)] = 0;
    const Effect* named = find_effect(own);
    if (named && named->listed && share_of_one_record(setup, changed) > borne_by_one)
        return {.detectable = changed.norm(), .separable = 0, .nearest = "one odd record"};
    Separation result;
    const Explanation none(setup, without, nullptr, data);
    const Eigen::MatrixXd innocent_slopes = none.slopes(none.start());
    const Eigen::VectorXd misfit = none.residual(none.start());
    const auto left_by = [&](const Eigen::MatrixXd& slopes) {
        return (misfit - slopes * slopes.colPivHouseholderQr().solve(misfit)).norm();
    };
    std::vector<std::pair<double, const Effect*>> rivals;
    for (const Effect& effect : effects()) {
        if (!effect.listed || effect.id == own || !shows(effect, setup.bench))
            continue;
        const Explanation with(setup, without, &effect, data);
        rivals.emplace_back(left_by(with.slopes(with.start())), &effect);
    }
    std::sort(rivals.begin(), rivals.end());
    result.detectable = std::sqrt(none.least(none.start()));
    result.separable = result.detectable;
    for (std::size_t k = 0; k < std::min(close, rivals.size()); ++k) {
        const Explanation with(setup, without, rivals[k].second, data);
        const double left = std::sqrt(with.least(with.start()));
        if (left < result.separable && left > same_answer * result.detectable) {
            result.separable = left;
            result.nearest = rivals[k].second->id;
        }
    }
    constexpr std::pair<Innocent::Kind, const char*> kinds[] = {{Innocent::clock, "late clocks"},
                                                                {Innocent::throws, "other throws"},
                                                                {Innocent::law, "other friction or restitution"}};
    for (const auto& [kind, word] : kinds) {
        Explanation farther(setup, without, nullptr, data);
        if (!farther.disbelieve(kind))
            continue;
        const double left = std::sqrt(farther.least(farther.start()));
        if (left < result.separable) {
            result.separable = left;
            result.nearest = word;
        }
    }
    return result;
}

double amplitude_for(const Setup& setup, const Truth& without, const Effect& effect, double wanted, double sign) {
    const auto at = [&](double amplitude) {
        Truth truth = without;
        effect.hide(truth, sign * amplitude);
        return separation_of(setup, truth, without, effect.id).separable;
    };
    double amplitude = effect.typical, reached = at(amplitude);
    for (int k = 0; k < 8; ++k) {
        if (std::abs(reached / wanted - 1) < 0.02)
            return sign * amplitude;
        amplitude *= std::clamp(wanted / std::max(reached, 1e-3), 0.1, 10.0);
        if (amplitude > effect.most)
            return 0;
        reached = at(amplitude);
    }
    return std::abs(reached / wanted - 1) < 0.1 ? sign * amplitude : 0;
}

} // namespace blind

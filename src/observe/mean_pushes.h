#pragma once

#include "base/closest_point.h"
#include "observe/part_loads.h"

#include <array>
#include <map>
#include <vector>

namespace tumble::observe {

/// The mean of the pushes of many steps, at few places. Bodies roll and slide, so that no two steps push at the same
/// foot; each triangle has a lattice, and a push counts at the three points of it about its foot, with shares that keep
/// force and moment. A lattice's cell is at most half the push's patch a wide, but no finer than a 64th of the
/// triangle's side, so that patches below a 32nd of that are widened more. Variances add up: Hertz' pressure has a^2 /
/// 5 along each axis of the surface, a cell of width h and a right angle h^2 / 4 at most (h^2 / 6 in the mean), and h^2
/// / 2 along its diagonal: h = a / 2 widens by 15 %, 10 % and 27 %.
class MeanPushes {
public:
    explicit MeanPushes(const std::vector<std::array<Eigen::Vector3d, 3>>& triangles);

    /// All contacts with the wall in one step.
    void take(const std::vector<WallPush>& pushes);
    /// Means over the steps taken since the last time, by triangle: force; normal and patch as the forces weigh them.
    /// No body's (-1), without velocity.
    std::vector<WallPush> finish();
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    /// Whether what was taken lies on these triangles, after it came from a checkpoint.
    [[nodiscard]] bool fits() const;

    /// All that was taken, for checkpoints.
    template <class Archive, As<MeanPushes> M> friend void carry(Archive& archive, M& means) {
        std::vector<Key> keys;
        std::vector<Sum> sums;
        for (const auto& [key, sum] : means.sums_) {
            keys.push_back(key);
            sums.push_back(sum);
        }
        archive(means.steps_, keys, sums);
        if constexpr (!std::is_const_v<M>) {
            means.sums_.clear();
            for (std::size_t k = 0; k < keys.size() && k < sums.size(); ++k)
                means.sums_[keys[k]] = sums[k];
        }
    }

private:
    using Key = std::array<int, 4>; // triangle, how often its sides are halved, place along ab and along ac
    struct Sum {
        Eigen::Vector3d force = Eigen::Vector3d::Zero();  // N
        Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // N, as the forces' sizes weigh it
        double patch = 0;                                 // N m, the same
        double weight = 0;                                // N
    };
    template <class Archive, As<Sum> S> friend void carry(Archive& archive, S& sum) {
        auto& [force, normal, patch, weight] = sum;
        archive(force, normal, patch, weight);
    }

    void add(const Key& key, double share, const WallPush& push);

    std::vector<FlatTriangle> triangles_;
    std::map<Key, Sum> sums_;
    std::int64_t steps_ = 0;
};

} // namespace tumble::observe

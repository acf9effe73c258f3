#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace tumble {

/// Which parts of a circle are hidden: arcs are added one by one, what is left free is asked for once. Radians.
class AngleCover {
public:
    void clear() { arcs_.clear(); }

    /// Hides middle - half .. middle + half; nothing if half is not positive.
    void hide(double middle, double half) {
        if (half <= 0)
            return;
        if (half >= std::numbers::pi) {
            arcs_.emplace_back(0, turn);
            return;
        }
        double from = std::fmod(middle - half, turn);
        if (from < 0)
            from += turn;
        const double to = from + 2 * half;
        arcs_.emplace_back(from, std::min(to, turn));
        if (to > turn)
            arcs_.emplace_back(0, to - turn);
    }

    /// Calls visit(from, to) for each free arc within 0 .. 2 pi, in order.
    template <class Visit> void free_arcs(Visit visit) {
        std::sort(arcs_.begin(), arcs_.end());
        double reached = 0;
        for (const auto& [from, to] : arcs_) {
            if (from > reached)
                visit(reached, from);
            reached = std::max(reached, to);
        }
        if (reached < turn)
            visit(reached, turn);
    }

    bool all_hidden() {
        bool hidden = true;
        free_arcs([&](double, double) { hidden = false; });
        return hidden;
    }

private:
    static constexpr double turn = 2 * std::numbers::pi;
    std::vector<std::pair<double, double>> arcs_;
};

} // namespace tumble

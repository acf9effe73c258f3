#pragma once

#include "contact/disc_touch.h"
#include "contact/material.h"

#include <cmath>

namespace tumble::contact {

/// The linear incremental law of Cundall and Strack 1979 as the thesis derives it, (3.21) to (3.27); docs/theory-2d.md
/// says how the code and the print differ. Made once per pair of materials.
class CundallStrack {
public:
    /// Spring k = constant + per_mass * m*, of which one is 0; its dashpot is 2 |beta| sqrt(k m*) + damping_time * k.
    struct Spring {
        double constant = 0, per_mass = 0, dashpot_constant = 0, dashpot_per_mass = 0;

        template <class Real> TUMBLE_INLINE Real stiffness(Real mass) const {
            return Real(constant) + Real(per_mass) * mass;
        }
        /// `root_mass` is sqrt(m*).
        template <class Real> TUMBLE_INLINE Real dashpot(Real stiffness, Real mass, Real root_mass, Real time) const {
            return Real(dashpot_constant) * root_mass + Real(dashpot_per_mass) * mass + time * stiffness;
        }
    };

    /// `rubs` false: no shear force at all. `limit_force` true: the normal force never pulls.
    CundallStrack(const PairConstants& pair, bool limit_force, bool rubs)
        : normal_(spring(pair.normal_stiffness, pair.stiffness_per_mass, pair.damping)),
          shear_(spring(pair.tangential_stiffness + pair.stiffness_ratio * pair.normal_stiffness,
                        pair.stiffness_ratio * pair.stiffness_per_mass, pair.damping)),
          damping_time_(pair.damping_time), friction_(pair.friction), cohesion_(pair.cohesion),
          limit_force_(limit_force), rubs_(rubs) {}

    /// dt in s; rates are those of half a step ago, as leapfrog has them.
    template <class Real>
    TUMBLE_INLINE DiscPush<Real> push(const DiscTouch<Real>& touch, const DiscMemory<Real>& memory, Real dt) const {
        return push(touch, memory, Real(friction_), Real(1.0), dt);
    }

    /// With this friction, and dashpots times `share`.
    template <class Real>
    TUMBLE_INLINE DiscPush<Real> push(const DiscTouch<Real>& touch, const DiscMemory<Real>& memory, Real friction,
                                      Real share, Real dt) const {
        const Real root_mass = root(touch.mass);
        const Real half_kick = Real(0.5) * dt / touch.mass;
        DiscPush<Real> push;
        push_apart(touch, root_mass, share, half_kick, push);
        if (rubs_)
            rub(touch, memory, root_mass, friction, share, half_kick, dt, push);
        else
            push.shear = push.memory.kept = push.memory.energy = push.shear_viscous = push.lost_shear_damping =
                push.lost_sliding = Real(0.0);
        push.lost_normal_damping = push.lost_normal_damping * dt;
        push.lost_history = Real(0.0);
        return push;
    }

    /// N/m, of the normal spring: its force over the overlap.
    template <class Real> TUMBLE_INLINE Real secant(const DiscTouch<Real>& touch) const {
        return normal_.stiffness(touch.mass);
    }

private:
    static Spring spring(double constant, double per_mass, double damping) {
        return {constant, per_mass, 2 * damping * std::sqrt(constant), 2 * damping * std::sqrt(per_mass)};
    }

    /// (3.23), (3.25) and (3.27): the increments k_n n' dt add up to k_n times the overlap itself. D_n = c_n n'.
    template <class Real>
    TUMBLE_INLINE void push_apart(const DiscTouch<Real>& touch, Real root_mass, Real share, Real half_kick,
                                  DiscPush<Real>& push) const {
        const Real k = normal_.stiffness(touch.mass);
        const Real elastic = k * touch.overlap;
        const Real c = normal_.dashpot(k, touch.mass, root_mass, Real(damping_time_)) * share;
        const Real sum = elastic + c * touch.normal_rate;
        push.normal = limit_force_ ? larger(sum, Real(0.0)) : sum;
        push.stored_normal = Real(0.5) * elastic * touch.overlap;
        push.normal_viscous = push.normal - elastic;
        // The dashpot's work is its force times the rate at the step, half a kick later.
        push.lost_normal_damping = push.normal_viscous * (touch.normal_rate - half_kick * push.normal);
    }

    /// (3.24), (3.26), (3.27), then Coulomb's limit F_n tan(phi) + c; the dashpot D_s = c_s s' is silent while the
    /// contact slides. For its losses a disc shows a third of m* to shear (inertia m R^2 / 2).
    template <class Real>
    TUMBLE_INLINE void rub(const DiscTouch<Real>& touch, const DiscMemory<Real>& memory, Real root_mass, Real friction,
                           Real share, Real half_kick, Real dt, DiscPush<Real>& push) const {
        const Real k = shear_.stiffness(touch.mass);
        const Real trial = memory.force() + k * touch.shear_rate * dt;
        const Real size = larger(trial, -trial);
        const Real limit = larger(friction * push.normal + Real(cohesion_), Real(0.0));
        const auto slides = size > limit;
        const Real held = select(slides, select(trial < Real(0.0), -limit, limit), trial);
        const Real dashpot = shear_.dashpot(k, touch.mass, root_mass, Real(damping_time_)) * share;
        const Real c = select(slides, Real(0.0), dashpot);
        const Real viscous = c * touch.shear_rate;
        push.shear = held + viscous;
        push.shear_viscous = viscous;
        const Real compliance = Real(1.0) / k;
        push.memory = DiscMemory<Real>::of_force(held, Real(0.5) * held * held * compliance);
        // What is cut off slid under the mean of the forces before and after: second order also where the limit moves.
        push.lost_sliding = Real(0.5) * (memory.force() + held) * (trial - held) * compliance;
        push.lost_shear_damping = viscous * (touch.shear_rate - Real(3.0) * half_kick * push.shear) * dt;
    }

    Spring normal_, shear_;
    double damping_time_, friction_, cohesion_;
    bool limit_force_, rubs_;
};

} // namespace tumble::contact

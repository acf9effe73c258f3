#pragma once

#include "contact/disc_touch.h"
#include "contact/hertz.h"
#include "contact/linear.h"
#include "contact/mindlin.h"

namespace tumble::contact {

/// The laws of spheres, Hertz with Mindlin or without friction, between discs: overlaps answer as those of spheres of
/// the discs' radii, mass and inertia stay the discs'. The same functions as in three dimensions, asked along e and t.
template <class Tangential> class HertzDiscs {
public:
    HertzDiscs(const PairConstants& pair, bool limit_force) : pair_(pair), limit_force_(limit_force) {}

    /// As CundallStrack::push.
    template <class Real>
    TUMBLE_INLINE DiscPush<Real> push(const DiscTouch<Real>& touch, const DiscMemory<Real>& memory, Real dt) const {
        return push(touch, memory, Real(pair_.friction), Real(1.0), dt);
    }

    /// With this friction, and dashpots times `share`.
    template <class Real>
    TUMBLE_INLINE DiscPush<Real> push(const DiscTouch<Real>& touch, const DiscMemory<Real>& memory, Real friction,
                                      Real share, Real dt) const {
        const Real none(0.0);
        const Vec3<Real> across{none, Real(1.0), none};
        const Touch<Real> seen{touch.overlap, across, {none, none, none}, touch.radius, touch.mass, share, Real(3.0)};
        const NormalPush<Real> normal = Hertz::push(seen, -touch.normal_rate, pair_);
        const Real sum = normal.elastic + normal.viscous;
        DiscPush<Real> push;
        push.normal = limit_force_ ? larger(sum, none) : sum;
        const Real limit = friction * larger(push.normal, -push.normal);
        const TangentialPush<Real> shear =
            Tangential::push(seen, Vec3<Real>{touch.shear_rate, none, none}, limit, normal.stiffness, pair_,
                             Memory<Real>{{memory.stretch(), none, none}, memory.energy}, dt);
        push.shear = -shear.force.x;
        push.memory = DiscMemory<Real>::of_stretch(shear.memory.spring.x, shear.memory.energy);
        push.normal_viscous = push.normal - normal.elastic;
        push.shear_viscous = -shear.viscous.x;
        push.stored_normal = normal.stored;
        const Real rate_now = touch.normal_rate - Real(0.5) * push.normal * (dt / touch.mass);
        push.lost_normal_damping = (push.normal - normal.elastic) * rate_now * dt;
        push.lost_shear_damping = shear.lost_damping;
        push.lost_sliding = shear.lost_sliding;
        push.lost_history = shear.lost_history;
        return push;
    }

    /// N/m, of the normal spring: its force over the overlap.
    template <class Real> TUMBLE_INLINE Real secant(const DiscTouch<Real>& touch) const {
        return Hertz::secant(root(touch.radius * touch.overlap), pair_);
    }

private:
    PairConstants pair_;
    bool limit_force_;
};

} // namespace tumble::contact

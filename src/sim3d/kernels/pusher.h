#pragma once

#include "base/vec3.h"
#include "contact/full_law.h"
#include "scene/laws.h"
#include "sim3d/kernels/isa.h"

/// How eight contacts at a time are pushed, by whatever law: push.cpp and push_fully.cpp.
namespace tumble::sim3d::TUMBLE_ISA {

constexpr int lanes = Pack::lanes;

TUMBLE_INLINE Vec3<Pack> xyz(const Columns& c) {
    return {c.x, c.y, c.z};
}

/// Where the bodies of a pack of contacts stand in memory.
using EightBodies = const BodyMotion* [lanes];

/// What of their motion a contact feels.
struct Bodies {
    Vec3<Pack> velocity, spin;
    Pack mass;

    TUMBLE_INLINE explicit Bodies(const EightBodies& bodies) {
        const Columns v = gather([&](int k) TUMBLE_INLINE_LAMBDA { return bodies[k]->velocity; });
        velocity = xyz(v);
        mass = v.w;
        spin = xyz(gather([&](int k) TUMBLE_INLINE_LAMBDA { return bodies[k]->spin; }));
    }
};

/// Geometry of eight contacts that the law needs.
struct Contacts {
    contact::Touch<Pack> touch;
    contact::Turn<Pack> turn;
    Pack depth; // m, the overlap, or less than 0 over a gap
    Pack smaller_radius;
};

/// All but the surfaces' relative velocity; `d` from b's sphere centre to a's.
TUMBLE_INLINE Contacts between(const Vec3<Pack>& d, Pack ra, Pack rb, const Bodies& a, const Bodies& b) {
    Contacts c;
    const Pack distance = root(dot(d, d));
    c.smaller_radius = select(rb < ra, rb, ra);
    c.touch.normal = d * (Pack(1.0) / distance);
    c.depth = ra + rb - distance;
    c.touch.overlap = larger(c.depth, Pack(0.0));
    c.touch.damping_share = Pack(1.0);
    // R* = Ra Rb / (Ra + Rb) and m* = ma mb / (ma + mb) share one division.
    const Pack radii = ra + rb;
    const Pack masses = a.mass + b.mass;
    const Pack shared = Pack(1.0) / (radii * masses);
    c.touch.radius = ra * rb * masses * shared;
    c.touch.mass = a.mass * b.mass * radii * shared;
    c.turn.spin = a.spin - b.spin;
    const Pack of_a = a.mass * ra * ra;
    const Pack of_b = b.mass * rb * rb;
    c.turn.inertia = Pack(contact::sphere_rolls) * of_a * of_b / (of_a + of_b);
    return c;
}

/// Where the forces of contacts take hold of their bodies, m from the centres of mass.
struct Arms {
    Vec3<Pack> a, b;

    TUMBLE_INLINE Vec3<Pack> velocity(const Bodies& of_a, const Bodies& of_b) const {
        return of_a.velocity - of_b.velocity + cross(of_a.spin, a) - cross(of_b.spin, b);
    }
};

/// The same of spheres about their centres of mass, whose arms lie along the normal.
struct Reaches {
    Pack a, b; // m, from the centres to the middle of the overlap

    TUMBLE_INLINE Vec3<Pack> velocity(const Bodies& of_a, const Bodies& of_b, const Vec3<Pack>& normal) const {
        return of_a.velocity - of_b.velocity + cross(normal, of_a.spin * a + of_b.spin * b);
    }
};

/// Sums over the lanes that are contacts and do not only fill up a pack.
struct PackSums {
    Pack stored_normal{0.0}, stored_tangential{0.0}, stored_rolling{0.0};
    Pack lost_normal_damping{0.0}, lost_tangential_damping{0.0}, lost_sliding{0.0}, lost_history{0.0};
    Pack lost_rolling_damping{0.0}, lost_rolling_sliding{0.0}, lost_adhesion{0.0};
    Pack apart{0.0}; // contacts that are none: gaps that no neck holds over
    Pack overlap_max{0.0};
    Pack deepest{0.0}, deepest_of{1.0}; // m, overlap and smaller radius where their ratio is largest

    TUMBLE_INLINE void add(const Contacts& c, const contact::Push<Pack>& push, Pack live) {
        stored_normal += live * push.stored_normal;
        stored_tangential += live * push.memory.energy;
        lost_normal_damping += live * push.lost_normal_damping;
        lost_tangential_damping += live * push.lost_tangential_damping;
        lost_sliding += live * push.lost_sliding;
        lost_history += live * push.lost_history;
        overlap_max = larger(overlap_max, live * c.touch.overlap);
        const auto deeper = deepest * c.smaller_radius < live * c.touch.overlap * deepest_of;
        deepest = select(deeper, c.touch.overlap, deepest);
        deepest_of = select(deeper, c.smaller_radius, deepest_of);
    }
    TUMBLE_INLINE void add(const Contacts& c, const contact::FullPush<Pack>& push, Pack live) {
        add(c, static_cast<const contact::Push<Pack>&>(push), live);
        stored_rolling += live * push.further.rolling.energy;
        lost_rolling_damping += live * push.lost_rolling_damping;
        lost_rolling_sliding += live * push.lost_rolling_sliding;
        lost_adhesion += live * push.lost_adhesion;
        apart += live * (Pack(1.0) - push.holds);
    }

    TUMBLE_INLINE void add_to(ContactSums& to, int contacts) const {
        to.stored_normal += sum(stored_normal);
        to.stored_tangential += sum(stored_tangential);
        to.lost_normal_damping += sum(lost_normal_damping);
        to.lost_tangential_damping += sum(lost_tangential_damping);
        to.lost_sliding += sum(lost_sliding);
        to.lost_history += sum(lost_history);
        to.stored_rolling += sum(stored_rolling);
        to.lost_rolling_damping += sum(lost_rolling_damping);
        to.lost_rolling_sliding += sum(lost_rolling_sliding);
        to.lost_adhesion += sum(lost_adhesion);
        to.contacts -= static_cast<std::int64_t>(sum(apart));
        to.overlap_max = larger(to.overlap_max, largest(overlap_max));
        to.overlap_ratio_max = larger(to.overlap_ratio_max, largest(deepest / deepest_of));
        to.contacts += contacts;
    }
};

/// 1 for the first n lanes, 0 for those that only fill up the pack.
TUMBLE_INLINE Pack live_lanes(int n) {
    constexpr Pack::Lanes number{0, 1, 2, 3, 4, 5, 6, 7};
    return select(Pack(number) < Pack(static_cast<double>(n)), Pack(1.0), Pack(0.0));
}

TUMBLE_INLINE void rows(Quad* to, const Vec3<Pack>& v, Pack w) {
    for_rows({v.x, v.y, v.z, w}, [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { to[k] = row; });
}

/// What a pack of contacts does, a contact per row.
struct Pushed {
    Quad force[lanes], memory[lanes];

    TUMBLE_INLINE explicit Pushed(const contact::Push<Pack>& push) {
        rows(force, push.force, Pack(0.0));
        rows(memory, push.memory.spring, push.memory.energy);
    }
    /// N m, beside what the force does at its arm.
    TUMBLE_INLINE static Quad torque(int) { return Quad{}; }
};

struct FullPushed : Pushed {
    Quad resisting[lanes], rolling[lanes], further[lanes];

    TUMBLE_INLINE explicit FullPushed(const contact::FullPush<Pack>& push) : Pushed(push) {
        rows(resisting, push.torque, Pack(0.0));
        rows(rolling, push.further.rolling.spring, push.further.rolling.energy);
        rows(further, {push.further.impact_speed, push.further.bonded, push.further.bond_energy}, Pack(0.0));
    }
    TUMBLE_INLINE Quad torque(int lane) const { return resisting[lane]; }
};

/// N m, what the forces do at their arms, a contact per row.
struct ArmTorques {
    Quad a[lanes], b[lanes];

    TUMBLE_INLINE ArmTorques(const Arms& arms, const Vec3<Pack>& force) {
        rows(a, cross(arms.a, force), Pack(0.0));
        rows(b, cross(force, arms.b), Pack(0.0));
    }
    TUMBLE_INLINE Quad on_a(int lane) const { return a[lane]; }
    TUMBLE_INLINE Quad on_b(int lane) const { return b[lane]; }
};

struct ReachTorques {
    Quad per_reach[lanes]; // N
    Pack reach_a, reach_b;

    TUMBLE_INLINE ReachTorques(const Reaches& reaches, const Vec3<Pack>& force, const Vec3<Pack>& normal)
        : reach_a(reaches.a), reach_b(reaches.b) {
        rows(per_reach, cross(force, normal), Pack(0.0));
    }
    TUMBLE_INLINE Quad on_a(int lane) const { return per_reach[lane] * reach_a.v[lane]; }
    TUMBLE_INLINE Quad on_b(int lane) const { return per_reach[lane] * reach_b.v[lane]; }
};

TUMBLE_INLINE void load_body(BodyLoad& load, Quad force, Quad torque) {
    quad_at(load.force) += force;
    quad_at(load.torque) += torque;
}

/// `By` is Pushed or FullPushed.
template <class By, class Torques>
TUMBLE_INLINE void hand_out(PushContext& context, const By& pushed, const Torques& torques, int lane, int a, int b) {
    load_body(context.load[a], pushed.force[lane], torques.on_a(lane) + pushed.torque(lane));
    const Quad force_b = -pushed.force[lane];
    const Quad torque_b = torques.on_b(lane) - pushed.torque(lane);
    if (b < context.end) // a pair belongs to the chunk of its lower slot, a
        load_body(context.load[b], force_b, torque_b);
    else
        context.foreign[context.foreign_count++] = {
            b, {force_b[0], force_b[1], force_b[2]}, {torque_b[0], torque_b[1], torque_b[2]}};
}

/// Calls pack(first, n) for every eight of `count` contacts.
template <class PackOf> TUMBLE_INLINE void by_packs(int count, PackOf&& pack) {
    for (int first = 0; first < count; first += lanes)
        pack(first, count - first < lanes ? count - first : lanes);
}

/// Calls each(lane, contact) for a whole pack; lanes beyond n repeat the first contact, which keeps every number
/// finite.
template <class EachOf> TUMBLE_INLINE void fill_lanes(int first, int n, EachOf&& each) {
    for (int lane = 0; lane < lanes; ++lane)
        each(lane, lane < n ? first + lane : first);
}

/// The law as it is; what it remembers is its spring.
template <class Normal, class Tangential> struct Plain {
    contact::Law<Normal, Tangential> law;
    static constexpr bool turns = false;
    using Pushed = TUMBLE_ISA::Pushed;

    /// Where the memories of a pack stand.
    struct Kept {
        MemoryLanes* at[lanes];

        TUMBLE_INLINE void set(const PushContext&, int lane, MemoryLanes* memory, std::ptrdiff_t) { at[lane] = memory; }
        TUMBLE_INLINE void store(int lane, const Pushed& pushed) const {
            quad_at(at[lane]->spring) = pushed.memory[lane];
        }
    };
    TUMBLE_INLINE auto push(const PushContext& context, const Contacts& c, const Kept& kept) const {
        const Columns memory = gather([&](int k) TUMBLE_INLINE_LAMBDA { return kept.at[k]->spring; });
        return law.push(c.touch, context.pair, contact::Memory<Pack>{xyz(memory), memory.w}, Pack(context.dt));
    }
};

/// The law with additions; what it remembers beside its spring stands in PushContext::further.
template <class Normal, class Tangential> struct Full {
    contact::FullLaw<Normal, Tangential> law;
    static constexpr bool turns = true; // contacts resist turning as well
    using Pushed = FullPushed;

    struct Kept {
        MemoryLanes* at[lanes];
        FurtherLanes* further[lanes];

        TUMBLE_INLINE void set(const PushContext& context, int lane, MemoryLanes* memory, std::ptrdiff_t index) {
            at[lane] = memory;
            further[lane] = context.further + index;
        }
        TUMBLE_INLINE void store(int lane, const Pushed& pushed) const {
            quad_at(at[lane]->spring) = pushed.memory[lane];
            quad_at(further[lane]->rolling) = pushed.rolling[lane];
            quad_at(&further[lane]->impact_speed) = pushed.further[lane];
        }
    };
    TUMBLE_INLINE auto push(const PushContext& context, const Contacts& c, const Kept& kept) const {
        const Columns memory = gather([&](int k) TUMBLE_INLINE_LAMBDA { return kept.at[k]->spring; });
        const Columns rolling = gather([&](int k) TUMBLE_INLINE_LAMBDA { return kept.further[k]->rolling; });
        const Columns more = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &kept.further[k]->impact_speed; });
        contact::Touch<Pack> touch = c.touch;
        if (context.pair.adhesion == contact::AdhesionLaw::jkr)
            touch.overlap = c.depth;
        return law.push(touch, c.turn, context.pair, contact::Memory<Pack>{xyz(memory), memory.w},
                        contact::Further<Pack>{{xyz(rolling), rolling.w}, more.x, more.y, more.z}, Pack(context.dt));
    }
};

TUMBLE_INLINE contact::Turn<Pack> over_wall(const Bodies& body, const Contacts& c,
                                            const WallContact* const (&contact)[lanes]) {
    Vec3<Pack> wall;
    for (int k = 0; k < lanes; ++k) {
        wall.x.v[k] = contact[k]->wall_spin[0];
        wall.y.v[k] = contact[k]->wall_spin[1];
        wall.z.v[k] = contact[k]->wall_spin[2];
    }
    return {body.spin - wall, Pack(contact::sphere_rolls) * body.mass * c.touch.radius * c.touch.radius};
}

/// m/s, by how much gravity and the wall's own motion change the velocities of the surfaces until the step.
TUMBLE_INLINE Vec3<Pack> ahead_at_wall(const PushContext& context, const Vec3<Pack>& wall_before,
                                       const WallContact* const (&contact)[lanes]) {
    const Vec3<Pack> now = xyz(gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->wall_now; }));
    const double half = 0.5 * context.dt;
    const Vec3<Pack> fall{Pack(half * context.gravity[0]), Pack(half * context.gravity[1]),
                          Pack(half * context.gravity[2])};
    return fall + wall_before - now;
}

/// By Plain or Full.
template <class By> struct Pusher {
    By by;
    using Kept = typename By::Kept;
    using Pushed = typename By::Pushed;

    void spheres(PushContext& context, const NearPair* pairs, const int* which, int count, MemoryLanes* memory) const {
        PackSums sums;
        by_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
            EightBodies a;
            EightBodies b;
            const Shift* image[lanes];
            bool shifted = false;
            Kept kept;
            fill_lanes(first, n, [&](int lane, int at) TUMBLE_INLINE_LAMBDA {
                const NearPair& pair = pairs[which[at]];
                a[lane] = &context.motion[pair.a];
                b[lane] = &context.motion[pair.b];
                image[lane] = &context.images[pair.image];
                shifted |= pair.image != no_image;
                kept.set(context, lane, &memory[which[at]], which[at]);
            });
            const Columns at_a = gather([&](int k) TUMBLE_INLINE_LAMBDA { return a[k]->position; });
            const Columns at_b = gather([&](int k) TUMBLE_INLINE_LAMBDA { return b[k]->position; });
            Vec3<Pack> d = xyz(at_a) - xyz(at_b);
            if (shifted)
                d = d - xyz(gather([&](int k) TUMBLE_INLINE_LAMBDA { return image[k]->along; }));
            const Bodies of_a(a);
            const Bodies of_b(b);
            Contacts c = between(d, at_a.w, at_b.w, of_a, of_b);
            const Pack half = Pack(0.5) * c.touch.overlap;
            const Reaches reaches{at_a.w - half, at_b.w - half};
            c.touch.velocity = reaches.velocity(of_a, of_b, c.touch.normal);
            const auto result = by.push(context, c, kept);
            sums.add(c, result, live_lanes(n));
            const Pushed pushed(result);
            const ReachTorques torques(reaches, result.force, c.touch.normal);
            for (int lane = 0; lane < n; ++lane) {
                kept.store(lane, pushed);
                hand_out(context, pushed, torques, lane, pairs[which[first + lane]].a, pairs[which[first + lane]].b);
            }
        });
        sums.add_to(*context.sums, count);
    }

    void bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory) const {
        PackSums sums;
        by_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
            EightBodies a;
            EightBodies b;
            const BodyContact* contact[lanes];
            Kept kept;
            fill_lanes(first, n, [&](int lane, int at) TUMBLE_INLINE_LAMBDA {
                contact[lane] = &contacts[at];
                a[lane] = &context.motion[contacts[at].a];
                b[lane] = &context.motion[contacts[at].b];
                kept.set(context, lane, &memory[contacts[at].memory], contacts[at].memory);
            });
            const Columns d = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->d; });
            const Columns to_a = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->arm_a; });
            const Columns to_b = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->arm_b; });
            const Bodies of_a(a);
            const Bodies of_b(b);
            Contacts c = between(xyz(d), to_a.w, to_b.w, of_a, of_b);
            const Pack half = Pack(0.5) * c.touch.overlap;
            const Arms arms{xyz(to_a) + c.touch.normal * (half - to_a.w), xyz(to_b) + c.touch.normal * (to_b.w - half)};
            c.touch.velocity = arms.velocity(of_a, of_b);
            c.touch.damping_share = d.w;
            const auto result = by.push(context, c, kept);
            sums.add(c, result, live_lanes(n));
            const Pushed pushed(result);
            const ArmTorques torques(arms, result.force);
            for (int lane = 0; lane < n; ++lane) {
                kept.store(lane, pushed);
                hand_out(context, pushed, torques, lane, contact[lane]->a, contact[lane]->b);
            }
        });
        sums.add_to(*context.sums, count);
    }

    void walls(PushContext& context, WallContact* contacts, int count) const {
        PackSums sums;
        by_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
            EightBodies bodies;
            WallContact* contact[lanes];
            Kept kept;
            fill_lanes(first, n, [&](int lane, int at) TUMBLE_INLINE_LAMBDA {
                contact[lane] = &contacts[at];
                bodies[lane] = &context.motion[contacts[at].body];
                kept.set(context, lane, &contacts[at].memory,
                         contacts[at].candidate * max_wall_touches + contacts[at].touch);
            });
            const Columns normal = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->normal; });
            const Columns arm = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->arm; });
            const Columns wall = gather([&](int k) TUMBLE_INLINE_LAMBDA { return contact[k]->wall_velocity; });
            const Bodies body(bodies);
            Contacts c;
            c.touch.normal = xyz(normal);
            c.depth = normal.w;
            c.touch.overlap = normal.w;
            c.touch.radius = c.smaller_radius = arm.w;
            c.touch.mass = body.mass;
            c.touch.damping_share = wall.w;
            const Vec3<Pack> from_centre = xyz(arm) + c.touch.normal * (Pack(0.5) * c.touch.overlap - arm.w);
            c.touch.velocity = body.velocity - xyz(wall) + cross(body.spin, from_centre);
            if constexpr (By::turns)
                c.turn = over_wall(body, c, contact);
            auto result = by.push(context, c, kept);
            contact::book_ahead(result, c.touch.normal, ahead_at_wall(context, xyz(wall), contact), Pack(context.dt));
            sums.add(c, result, live_lanes(n));
            const Pushed pushed(result);
            Quad torque[lanes];
            rows(torque, cross(from_centre, result.force), Pack(0.0));
            for (int lane = 0; lane < n; ++lane) {
                const WallContact& to = *contact[lane];
                kept.store(lane, pushed);
                quad_at(contacts[first + lane].force) = pushed.force[lane];
                load_body(context.load[to.body], pushed.force[lane], torque[lane] + pushed.torque(lane));
                double power = 0;
                for (int axis = 0; axis < 3; ++axis)
                    power += pushed.force[lane][axis] * to.wall_now[axis];
                if constexpr (By::turns)
                    for (int axis = 0; axis < 3; ++axis)
                        power += pushed.torque(lane)[axis] * to.wall_spin[axis];
                context.sums->wall_work += power * context.dt;
            }
        });
        sums.add_to(*context.sums, count);
    }
};

/// Calls visit(pusher) with the pusher of the scene's laws; By is Plain or Full.
template <template <class, class> class By, class Normal, class Visitor>
TUMBLE_INLINE void with_normal(const PushContext& context, Visitor&& visit) {
    switch (static_cast<scene::TangentialLaw>(context.tangential_law)) {
    case scene::TangentialLaw::none:
        return visit(Pusher<By<Normal, contact::NoTangential>>{{{context.limit_force}}});
    case scene::TangentialLaw::mindlin:
        return visit(Pusher<By<Normal, contact::Mindlin>>{{{context.limit_force}}});
    case scene::TangentialLaw::linear:
        return visit(Pusher<By<Normal, contact::LinearTangential>>{{{context.limit_force}}});
    }
}

template <template <class, class> class By, class Visitor>
TUMBLE_INLINE void with_law(const PushContext& context, Visitor&& visit) {
    switch (static_cast<scene::NormalLaw>(context.normal_law)) {
    case scene::NormalLaw::hertz:
        return with_normal<By, contact::Hertz>(context, visit);
    case scene::NormalLaw::linear:
        return with_normal<By, contact::LinearNormal>(context, visit);
    }
}

} // namespace tumble::sim3d::TUMBLE_ISA

#pragma once

#include "contact/cundall_strack.h"
#include "contact/full_discs.h"
#include "contact/hertz_discs.h"
#include "scene/laws.h"
#include "sim2d/kernels/isa.h"

/// How eight contacts at a time are pushed, by whatever law: push.cpp and push_fully.cpp.
namespace tumble::sim2d::TUMBLE_ISA {

constexpr int lanes = Pack::lanes;

// Which row comes next is known long before it is needed, but not to the processor.
constexpr int ahead = 24;

/// Where the rows of a pack of contacts stand in memory.
using EightRows = const Row* [lanes];

/// A pack of rows: place x y radius mass, motion vx vy spin kick.
struct Rows {
    Columns place, motion;

    TUMBLE_INLINE explicit Rows(const EightRows& rows) {
        place = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &rows[k]->x; });
        motion = gather([&](int k) TUMBLE_INLINE_LAMBDA { return &rows[k]->vx; });
    }
    [[nodiscard]] TUMBLE_INLINE Pack radius() const { return place.z; }
    [[nodiscard]] TUMBLE_INLINE Pack mass() const { return place.w; }
    [[nodiscard]] TUMBLE_INLINE Pack spin() const { return motion.z; }
};

/// Eight contacts. X stands at a, Y at b.
struct Contacts {
    contact::DiscTouch<Pack> touch;
    contact::Turn<Pack> turn;
    Pack ex, ey;             // e of (3.19)
    Pack arm_of_x, arm_of_y; // m, from the centres to the middle of the overlap
    Pack smaller_radius;

    /// (3.20) to (3.22) with the relative velocity of the centres, e, and t, which is e turned clockwise.
    TUMBLE_INLINE void rates(Pack vx, Pack vy, Pack turning) {
        touch.normal_rate = vx * ex + vy * ey;
        touch.shear_rate = vx * ey - vy * ex - turning;
    }
};

/// `dx`, `dy` from a's centre to b's, as (3.19) has it.
TUMBLE_INLINE Contacts between(Pack dx, Pack dy, const Rows& a, const Rows& b) {
    Contacts c;
    const Pack ra = a.radius(), rb = b.radius();
    const Pack distance = root(dx * dx + dy * dy);
    const Pack per_distance = Pack(1.0) / distance;
    c.ex = dx * per_distance;
    c.ey = dy * per_distance;
    c.touch.overlap = larger(ra + rb - distance, Pack(0.0));
    // R* and m* share one division.
    const Pack radii = ra + rb;
    const Pack masses = a.mass() + b.mass();
    const Pack shared = Pack(1.0) / (radii * masses);
    c.touch.radius = ra * rb * masses * shared;
    c.touch.mass = a.mass() * b.mass() * radii * shared;
    c.arm_of_x = ra - Pack(0.5) * c.touch.overlap;
    c.arm_of_y = rb - Pack(0.5) * c.touch.overlap;
    c.smaller_radius = select(rb < ra, rb, ra);
    c.rates(a.motion.x - b.motion.x, a.motion.y - b.motion.y, a.spin() * c.arm_of_x + b.spin() * c.arm_of_y);
    const Pack of_a = a.mass() * ra * ra;
    const Pack of_b = b.mass() * rb * rb;
    c.turn = {{Pack(0.0), Pack(0.0), a.spin() - b.spin()}, Pack(contact::disc_rolls) * of_a * of_b / (of_a + of_b)};
    return c;
}

/// Sums over the lanes that are contacts and do not only fill up a pack.
struct PackSums {
    Pack stored_normal{0.0}, stored_tangential{0.0}, stored_rolling{0.0};
    Pack lost_normal_damping{0.0}, lost_tangential_damping{0.0}, lost_sliding{0.0}, lost_history{0.0};
    Pack lost_rolling_damping{0.0}, lost_rolling_sliding{0.0};
    Pack overlap_max{0.0};
    Pack deepest{0.0}, deepest_of{1.0}; // m, overlap and smaller radius where their ratio is largest

    TUMBLE_INLINE void add(const Contacts& c, const contact::DiscPush<Pack>& push, Pack live) {
        stored_normal += live * push.stored_normal;
        stored_tangential += live * push.memory.energy;
        lost_normal_damping += live * push.lost_normal_damping;
        lost_tangential_damping += live * push.lost_shear_damping;
        lost_sliding += live * push.lost_sliding;
        lost_history += live * push.lost_history;
        overlap_max = larger(overlap_max, live * c.touch.overlap);
        const auto deeper = deepest * c.smaller_radius < live * c.touch.overlap * deepest_of;
        deepest = select(deeper, c.touch.overlap, deepest);
        deepest_of = select(deeper, c.smaller_radius, deepest_of);
    }
    TUMBLE_INLINE void add(const Contacts& c, const contact::FullDiscPush<Pack>& push, Pack live) {
        add(c, static_cast<const contact::DiscPush<Pack>&>(push), live);
        stored_rolling += live * push.further.rolling.energy;
        lost_rolling_damping += live * push.lost_rolling_damping;
        lost_rolling_sliding += live * push.lost_rolling_sliding;
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

/// Force on b along x and y.
struct Force {
    Pack x, y;
    TUMBLE_INLINE Force(const Contacts& c, const contact::DiscPush<Pack>& push)
        : x(push.normal * c.ex + push.shear * c.ey), y(push.normal * c.ey - push.shear * c.ex) {}
};

/// Loads of eight contacts, a contact per row; the moment is shear times arm on both sides.
TUMBLE_INLINE void load_rows(Quad* to, Pack fx, Pack fy, Pack torque) {
    for_rows({fx, fy, torque, Pack(0.0)}, [&](int k, Quad row) TUMBLE_INLINE_LAMBDA { to[k] = row; });
}

TUMBLE_INLINE void hand_out(PushContext& context, int row, Quad load) {
    if (owns(context.owned, row)) {
        quad_at(&context.loads[row].fx) += load;
        return;
    }
    context.foreign[context.foreign_count++] = {row, load[0], load[1], load[2]};
}

TUMBLE_INLINE contact::DiscMemory<Pack> recall(const Memory* const (&kept)[lanes]) {
    contact::DiscMemory<Pack> memory;
    for (int k = 0; k < lanes; ++k) {
        memory.kept.v[k] = kept[k]->kept;
        memory.energy.v[k] = kept[k]->energy;
    }
    return memory;
}

/// The law as it is; what it remembers is its spring.
template <class Law> struct Plain {
    Law law;
    static constexpr bool turns = false;
    using Push = contact::DiscPush<Pack>;

    /// Where the memories of a pack stand.
    struct Kept {
        Memory* at[lanes];

        TUMBLE_INLINE void set(const PushContext&, int lane, Memory* memory, std::ptrdiff_t) { at[lane] = memory; }
        TUMBLE_INLINE void store(int lane, const Push& push) const {
            *at[lane] = {push.memory.kept.v[lane], push.memory.energy.v[lane]};
        }
    };
    TUMBLE_INLINE Push push(const PushContext& context, const Contacts& c, const Kept& kept) const {
        return law.push(c.touch, recall(kept.at), Pack(context.dt));
    }
};

/// The law with additions; what it remembers beside its spring stands in PushContext::further.
template <class Law> struct Full {
    contact::FullDiscs<Law> law;
    static constexpr bool turns = true; // contacts resist turning as well
    using Push = contact::FullDiscPush<Pack>;

    struct Kept {
        Memory* at[lanes];
        FurtherMemory* further[lanes];

        TUMBLE_INLINE void set(const PushContext& context, int lane, Memory* memory, std::ptrdiff_t index) {
            at[lane] = memory;
            further[lane] = context.further + index;
        }
        TUMBLE_INLINE void store(int lane, const Push& push) const {
            *at[lane] = {push.memory.kept.v[lane], push.memory.energy.v[lane]};
            *further[lane] = {push.further.rolling.spring.z.v[lane], push.further.rolling.energy.v[lane],
                              push.further.impact_speed.v[lane]};
        }
    };
    TUMBLE_INLINE Push push(const PushContext& context, const Contacts& c, const Kept& kept) const {
        contact::Further<Pack> further{};
        for (int k = 0; k < lanes; ++k) {
            further.rolling.spring.z.v[k] = kept.further[k]->rolling;
            further.rolling.energy.v[k] = kept.further[k]->rolling_energy;
            further.impact_speed.v[k] = kept.further[k]->impact_speed;
        }
        return law.push(c.touch, c.turn, recall(kept.at), further, Pack(context.dt));
    }
};

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

/// By Plain or Full.
template <class By>
void push_pairs(const By& by, PushContext& context, const NearPair* pairs, const int* which, int count,
                Memory* memory) {
    PackSums sums;
    by_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
        EightRows at_a;
        EightRows at_b;
        const Shift* image[lanes];
        typename By::Kept kept;
        fill_lanes(first, n, [&](int lane, int at) TUMBLE_INLINE_LAMBDA {
            const NearPair& pair = pairs[which[at]];
            at_a[lane] = &context.rows[pair.a];
            at_b[lane] = &context.rows[pair.b];
            image[lane] = &context.images[pair.image];
            kept.set(context, lane, &memory[which[at]], which[at]);
            const int next = which[at + ahead < count ? at + ahead : at];
            __builtin_prefetch(&context.rows[pairs[next].b]);
            __builtin_prefetch(&context.loads[pairs[next].b], 1);
            __builtin_prefetch(&memory[next], 1);
        });
        const Rows a(at_a);
        const Rows b(at_b);
        Pack dx = b.place.x - a.place.x;
        Pack dy = b.place.y - a.place.y;
        if (context.periodic) {
            const Columns shift = gather([&](int k) TUMBLE_INLINE_LAMBDA { return image[k]->along; });
            dx = dx + shift.x;
            dy = dy + shift.y;
        }
        const Contacts c = between(dx, dy, a, b);
        const auto push = by.push(context, c, kept);
        sums.add(c, push, live_lanes(n));
        const Force force(c, push);
        Quad on_a[lanes];
        Quad on_b[lanes];
        Pack torque_a = push.shear * c.arm_of_x;
        Pack torque_b = push.shear * c.arm_of_y;
        if constexpr (By::turns) {
            torque_a = torque_a + push.torque;
            torque_b = torque_b - push.torque;
        }
        load_rows(on_a, -force.x, -force.y, torque_a);
        load_rows(on_b, force.x, force.y, torque_b);
        for (int lane = 0; lane < n; ++lane) {
            kept.store(lane, push);
            quad_at(&context.loads[pairs[which[first + lane]].a].fx) += on_a[lane];
            hand_out(context, pairs[which[first + lane]].b, on_b[lane]);
        }
    });
    sums.add_to(*context.sums, count);
}

/// The wall stands for Y: without spin, without mass of its own, its surface at the contact.
template <class By> void push_wall_contacts(const By& by, PushContext& context, WallContact* contacts, int count) {
    PackSums sums;
    by_packs(count, [&](int first, int n) TUMBLE_INLINE_LAMBDA {
        EightRows rows;
        WallContact* at[lanes];
        typename By::Kept kept;
        fill_lanes(first, n, [&](int lane, int k) TUMBLE_INLINE_LAMBDA {
            at[lane] = &contacts[k];
            rows[lane] = &context.rows[contacts[k].row];
            kept.set(context, lane, &contacts[k].memory, contacts[k].near * max_wall_touches + contacts[k].touch);
        });
        const Columns normal = gather([&](int k) TUMBLE_INLINE_LAMBDA { return at[k]->normal; });
        const Columns wall = gather([&](int k) TUMBLE_INLINE_LAMBDA { return at[k]->velocity; }); // and now
        const Rows disc(rows);
        Contacts c;
        c.ex = -normal.x;
        c.ey = -normal.y;
        c.touch.overlap = normal.z;
        c.touch.radius = c.smaller_radius = disc.radius();
        c.touch.mass = disc.mass();
        c.arm_of_x = c.arm_of_y = disc.radius() - Pack(0.5) * normal.z;
        c.rates(disc.motion.x - wall.x, disc.motion.y - wall.y, disc.spin() * c.arm_of_x);
        c.turn = {{Pack(0.0), Pack(0.0), disc.spin() - normal.w},
                  Pack(contact::disc_rolls) * disc.mass() * disc.radius() * disc.radius()};
        auto push = by.push(context, c, kept);
        // What gravity and the wall's own motion change until the step.
        const Pack ahead_x = Pack(0.5 * context.dt * context.gravity[0]) + wall.x - wall.z;
        const Pack ahead_y = Pack(0.5 * context.dt * context.gravity[1]) + wall.y - wall.w;
        contact::book_ahead(push, ahead_x * c.ex + ahead_y * c.ey, ahead_x * c.ey - ahead_y * c.ex, Pack(context.dt));
        sums.add(c, push, live_lanes(n));
        const Force force(c, push);
        Quad on_disc[lanes];
        Pack torque = push.shear * c.arm_of_x;
        if constexpr (By::turns)
            torque = torque + push.torque;
        load_rows(on_disc, -force.x, -force.y, torque);
        for (int lane = 0; lane < n; ++lane) {
            kept.store(lane, push);
            quad_at(&context.loads[at[lane]->row].fx) += on_disc[lane];
            context.sums->wall_work +=
                (on_disc[lane][0] * at[lane]->now[0] + on_disc[lane][1] * at[lane]->now[1]) * context.dt;
            if constexpr (By::turns)
                context.sums->wall_work += push.torque.v[lane] * at[lane]->spin * context.dt;
        }
    });
    sums.add_to(*context.sums, count);
}

/// Calls visit(law) with the scene's law for the pair.
template <class Visitor> TUMBLE_INLINE void with_law(const PushContext& context, Visitor&& visit) {
    const auto tangential = static_cast<scene::TangentialLaw>(context.tangential_law);
    if (static_cast<scene::NormalLaw>(context.normal_law) == scene::NormalLaw::linear)
        visit(contact::CundallStrack(context.pair, context.limit_force, tangential != scene::TangentialLaw::none));
    else if (tangential == scene::TangentialLaw::none)
        visit(contact::HertzDiscs<contact::NoTangential>(context.pair, context.limit_force));
    else
        visit(contact::HertzDiscs<contact::Mindlin>(context.pair, context.limit_force));
}

} // namespace tumble::sim2d::TUMBLE_ISA

#include "base/vec3.h"
#include "contact/law.h"
#include "scene/laws.h"
#include "sim3d/kernels/isa.h"

namespace tumble::sim3d::TUMBLE_ISA {

namespace {

// Contacts are gathered, computed and handed out in groups: a vector load right after the scalar stores that fed it
// would stall, a group later it does not.
constexpr int group = 4 * Pack::lanes;

/// One group of contacts, a field per row. For walls, velocity_b is the wall's at the contact and d holds the normal.
struct alignas(64) Gathered {
    double d[3][group];
    double overlap[group]; // walls only
    double radius_a[group], radius_b[group];
    double mass_a[group], mass_b[group];
    double velocity_a[3][group], velocity_b[3][group];
    double spin_a[3][group], spin_b[3][group];
    double arm_a[3][group], arm_b[3][group];
    double spring[3][group], energy[group];
    double share[group];
    double live[group]; // 1, or 0 for lanes that only fill up the last pack
};

struct alignas(64) Pushed {
    double force[3][group];
    double torque_a[3][group], torque_b[3][group];
    double spring[3][group], energy[group];
};

TUMBLE_INLINE Vec3<Pack> load3(const double (*rows)[group], int at) {
    return {Pack::load(rows[0] + at), Pack::load(rows[1] + at), Pack::load(rows[2] + at)};
}

TUMBLE_INLINE void store3(double (*rows)[group], int at, const Vec3<Pack>& v) {
    v.x.store(rows[0] + at);
    v.y.store(rows[1] + at);
    v.z.store(rows[2] + at);
}

TUMBLE_INLINE void put3(double (*rows)[group], int lane, const double* from) {
    rows[0][lane] = from[0];
    rows[1][lane] = from[1];
    rows[2][lane] = from[2];
}

// Which body comes next is known long before it is needed, but not to the processor.
constexpr int ahead = 24;

TUMBLE_INLINE void fetch(const void* line) {
    __builtin_prefetch(line, 1);
}

TUMBLE_INLINE void fetch_body(const PushContext& context, int body) {
    fetch(&context.motion[body]);
    fetch(context.motion[body].spin);
    fetch(&context.load[body]);
}

enum class Kind { spheres, bodies, walls };

struct PackSums {
    Pack stored_normal{0.0}, stored_tangential{0.0};
    Pack lost_normal_damping{0.0}, lost_tangential_damping{0.0}, lost_sliding{0.0}, lost_history{0.0};
    Pack overlap_max{0.0}, ratio_max{0.0};
};

TUMBLE_INLINE void add_to(ContactSums& to, const PackSums& sums, int contacts) {
    to.stored_normal += sum(sums.stored_normal);
    to.stored_tangential += sum(sums.stored_tangential);
    to.lost_normal_damping += sum(sums.lost_normal_damping);
    to.lost_tangential_damping += sum(sums.lost_tangential_damping);
    to.lost_sliding += sum(sums.lost_sliding);
    to.lost_history += sum(sums.lost_history);
    to.overlap_max = larger(to.overlap_max, largest(sums.overlap_max));
    to.overlap_ratio_max = larger(to.overlap_ratio_max, largest(sums.ratio_max));
    to.contacts += contacts;
}

/// Geometry of one pack of contacts, then the law, then forces and torques.
template <Kind kind, class ThisLaw>
TUMBLE_INLINE void push_pack(const ThisLaw& law, const PushContext& context, const Gathered& in, Pushed& out, int at,
                             PackSums& sums) {
    const Pack ra = Pack::load(in.radius_a + at);
    const Pack ma = Pack::load(in.mass_a + at);
    contact::Touch<Pack> touch;
    Vec3<Pack> arm_a;
    Vec3<Pack> arm_b;
    Pack smaller = ra;
    if constexpr (kind == Kind::walls) {
        touch.normal = load3(in.d, at);
        touch.overlap = Pack::load(in.overlap + at);
        touch.radius = ra;
        touch.mass = ma;
        arm_a = load3(in.arm_a, at) + touch.normal * (Pack(0.5) * touch.overlap - ra);
        touch.velocity = load3(in.velocity_a, at) - load3(in.velocity_b, at) + cross(load3(in.spin_a, at), arm_a);
    } else {
        const Pack rb = Pack::load(in.radius_b + at);
        const Pack mb = Pack::load(in.mass_b + at);
        const Vec3<Pack> d = load3(in.d, at);
        const Pack distance = root(dot(d, d));
        smaller = select(rb < ra, rb, ra);
        touch.normal = d * (Pack(1.0) / distance);
        touch.overlap = larger(ra + rb - distance, Pack(0.0));
        touch.radius = ra * rb / (ra + rb);
        touch.mass = ma * mb / (ma + mb);
        arm_a = touch.normal * (Pack(0.5) * touch.overlap - ra);
        arm_b = touch.normal * (rb - Pack(0.5) * touch.overlap);
        if constexpr (kind == Kind::bodies) {
            arm_a = arm_a + load3(in.arm_a, at);
            arm_b = arm_b + load3(in.arm_b, at);
        }
        touch.velocity = load3(in.velocity_a, at) - load3(in.velocity_b, at) + cross(load3(in.spin_a, at), arm_a) -
                         cross(load3(in.spin_b, at), arm_b);
    }
    touch.damping_share = kind == Kind::spheres ? Pack(1.0) : Pack::load(in.share + at);

    const contact::Memory<Pack> memory{load3(in.spring, at), Pack::load(in.energy + at)};
    const contact::Push<Pack> push = law.push(touch, context.pair, memory, Pack(context.dt));

    store3(out.force, at, push.force);
    store3(out.torque_a, at, cross(arm_a, push.force));
    if constexpr (kind != Kind::walls)
        store3(out.torque_b, at, cross(push.force, arm_b));
    store3(out.spring, at, push.memory.spring);
    push.memory.energy.store(out.energy + at);

    const Pack live = Pack::load(in.live + at);
    sums.stored_normal += live * push.stored_normal;
    sums.stored_tangential += live * push.memory.energy;
    sums.lost_normal_damping += live * push.lost_normal_damping;
    sums.lost_tangential_damping += live * push.lost_tangential_damping;
    sums.lost_sliding += live * push.lost_sliding;
    sums.lost_history += live * push.lost_history;
    sums.overlap_max = larger(sums.overlap_max, live * touch.overlap);
    sums.ratio_max = larger(sums.ratio_max, live * touch.overlap / smaller);
}

TUMBLE_INLINE void gather_body(const BodyMotion& body, double (*velocity)[group], double (*spin)[group], double* mass,
                               int lane) {
    put3(velocity, lane, body.velocity);
    put3(spin, lane, body.spin);
    mass[lane] = body.mass;
}

TUMBLE_INLINE void gather_memory(const MemoryLanes& memory, Gathered& in, int lane) {
    put3(in.spring, lane, memory.spring);
    in.energy[lane] = memory.energy;
}

TUMBLE_INLINE void keep_memory(const Pushed& out, int lane, MemoryLanes& memory) {
    for (int axis = 0; axis < 3; ++axis)
        memory.spring[axis] = out.spring[axis][lane];
    memory.energy = out.energy[lane];
}

TUMBLE_INLINE void add_load(BodyLoad& load, const double (*force)[group], const double (*torque)[group], int lane,
                            double sign) {
    for (int axis = 0; axis < 3; ++axis) {
        load.force[axis] += sign * force[axis][lane];
        load.torque[axis] += torque[axis][lane];
    }
}

TUMBLE_INLINE void hand_out(PushContext& context, const Pushed& out, int a, int b, int lane) {
    add_load(context.load[a], out.force, out.torque_a, lane, 1.0);
    if (b >= context.begin && b < context.end) {
        add_load(context.load[b], out.force, out.torque_b, lane, -1.0);
        return;
    }
    ForeignPush& foreign = context.foreign[context.foreign_count++];
    foreign.body = b;
    for (int axis = 0; axis < 3; ++axis) {
        foreign.force[axis] = -out.force[axis][lane];
        foreign.torque[axis] = out.torque_b[axis][lane];
    }
}

// The last pack is filled up with copies of lane 0, which keeps every number finite; `live` keeps them out of sums.
TUMBLE_INLINE int fill_up(Gathered& in, int n) {
    const int padded = (n + Pack::lanes - 1) / Pack::lanes * Pack::lanes;
    double* rows = &in.d[0][0];
    for (int lane = n; lane < padded; ++lane)
        for (std::size_t row = 0; row < sizeof(Gathered) / sizeof(double) / group; ++row)
            rows[row * group + static_cast<std::size_t>(lane)] = rows[row * group];
    for (int lane = 0; lane < padded; ++lane)
        in.live[lane] = lane < n ? 1.0 : 0.0;
    return padded;
}

template <class ThisLaw> struct Pusher {
    ThisLaw law;

    void spheres(PushContext& context, const SpherePair* pairs, const int* which, int count,
                 MemoryLanes* memory) const {
        Gathered in;
        Pushed out;
        PackSums sums;
        for (int first = 0; first < count; first += group) {
            const int n = count - first < group ? count - first : group;
            for (int lane = 0; lane < n; ++lane) {
                const int p = which[first + lane];
                if (first + lane + ahead < count) {
                    const int next = which[first + lane + ahead];
                    fetch_body(context, pairs[next].b);
                    fetch(&memory[next]);
                }
                const BodyMotion& a = context.motion[pairs[p].a];
                const BodyMotion& b = context.motion[pairs[p].b];
                const double* image = context.images[pairs[p].image];
                for (int axis = 0; axis < 3; ++axis)
                    in.d[axis][lane] = a.position[axis] - b.position[axis] - image[axis];
                in.radius_a[lane] = a.radius;
                in.radius_b[lane] = b.radius;
                gather_body(a, in.velocity_a, in.spin_a, in.mass_a, lane);
                gather_body(b, in.velocity_b, in.spin_b, in.mass_b, lane);
                gather_memory(memory[p], in, lane);
            }
            const int padded = fill_up(in, n);
            for (int at = 0; at < padded; at += Pack::lanes)
                push_pack<Kind::spheres>(law, context, in, out, at, sums);
            for (int lane = 0; lane < n; ++lane) {
                const int p = which[first + lane];
                keep_memory(out, lane, memory[p]);
                hand_out(context, out, pairs[p].a, pairs[p].b, lane);
            }
        }
        add_to(*context.sums, sums, count);
    }

    void bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory) const {
        Gathered in;
        Pushed out;
        PackSums sums;
        for (int first = 0; first < count; first += group) {
            const int n = count - first < group ? count - first : group;
            for (int lane = 0; lane < n; ++lane) {
                const BodyContact& c = contacts[first + lane];
                put3(in.d, lane, c.d);
                put3(in.arm_a, lane, c.arm_a);
                put3(in.arm_b, lane, c.arm_b);
                in.radius_a[lane] = c.radius_a;
                in.radius_b[lane] = c.radius_b;
                in.share[lane] = static_cast<double>(c.damping_share);
                gather_body(context.motion[c.a], in.velocity_a, in.spin_a, in.mass_a, lane);
                gather_body(context.motion[c.b], in.velocity_b, in.spin_b, in.mass_b, lane);
                gather_memory(memory[c.memory], in, lane);
            }
            const int padded = fill_up(in, n);
            for (int at = 0; at < padded; at += Pack::lanes)
                push_pack<Kind::bodies>(law, context, in, out, at, sums);
            for (int lane = 0; lane < n; ++lane) {
                const BodyContact& c = contacts[first + lane];
                keep_memory(out, lane, memory[c.memory]);
                hand_out(context, out, c.a, c.b, lane);
            }
        }
        add_to(*context.sums, sums, count);
    }

    void walls(PushContext& context, WallContact* contacts, int count) const {
        Gathered in;
        Pushed out;
        PackSums sums;
        for (int first = 0; first < count; first += group) {
            const int n = count - first < group ? count - first : group;
            for (int lane = 0; lane < n; ++lane) {
                const WallContact& c = contacts[first + lane];
                put3(in.d, lane, c.normal);
                put3(in.arm_a, lane, c.arm);
                put3(in.velocity_b, lane, c.wall_velocity);
                in.overlap[lane] = c.overlap;
                in.radius_a[lane] = c.radius;
                in.share[lane] = static_cast<double>(c.damping_share);
                gather_body(context.motion[c.body], in.velocity_a, in.spin_a, in.mass_a, lane);
                gather_memory(c.memory, in, lane);
            }
            const int padded = fill_up(in, n);
            for (int at = 0; at < padded; at += Pack::lanes)
                push_pack<Kind::walls>(law, context, in, out, at, sums);
            for (int lane = 0; lane < n; ++lane) {
                WallContact& c = contacts[first + lane];
                keep_memory(out, lane, c.memory);
                add_load(context.load[c.body], out.force, out.torque_a, lane, 1.0);
                double power = 0;
                for (int axis = 0; axis < 3; ++axis)
                    power += out.force[axis][lane] * c.wall_now[axis];
                context.sums->wall_work += power * context.dt;
            }
        }
        add_to(*context.sums, sums, count);
    }
};

template <class Normal, class Visitor> TUMBLE_INLINE void with_normal(const PushContext& context, Visitor&& visit) {
    switch (static_cast<scene::TangentialLaw>(context.tangential_law)) {
    case scene::TangentialLaw::none:
        return visit(Pusher<contact::Law<Normal, contact::NoTangential>>{{context.limit_force}});
    case scene::TangentialLaw::mindlin:
        return visit(Pusher<contact::Law<Normal, contact::Mindlin>>{{context.limit_force}});
    case scene::TangentialLaw::linear:
        return visit(Pusher<contact::Law<Normal, contact::LinearTangential>>{{context.limit_force}});
    }
}

template <class Visitor> TUMBLE_INLINE void with_law(const PushContext& context, Visitor&& visit) {
    switch (static_cast<scene::NormalLaw>(context.normal_law)) {
    case scene::NormalLaw::hertz:
        return with_normal<contact::Hertz>(context, visit);
    case scene::NormalLaw::linear:
        return with_normal<contact::LinearNormal>(context, visit);
    }
}

} // namespace

void push_spheres(PushContext& context, const SpherePair* pairs, const int* which, int count, MemoryLanes* memory) {
    with_law(context, [&](const auto& pusher) { pusher.spheres(context, pairs, which, count, memory); });
}

void push_bodies(PushContext& context, const BodyContact* contacts, int count, MemoryLanes* memory) {
    with_law(context, [&](const auto& pusher) { pusher.bodies(context, contacts, count, memory); });
}

void push_walls(PushContext& context, WallContact* contacts, int count) {
    with_law(context, [&](const auto& pusher) { pusher.walls(context, contacts, count); });
}

} // namespace tumble::sim3d::TUMBLE_ISA

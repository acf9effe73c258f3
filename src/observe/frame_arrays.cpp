#include "observe/frame_arrays.h"

#include "observe/array_rows.h"

#include <algorithm>
#include <fmt/format.h>

namespace tumble::observe {

namespace {

std::vector<Array> wall_arrays(const Frame& frame) {
    std::vector<Array> arrays{reals("wall_rotation", 9), reals("wall_translation_m", 3), reals("wall_velocity_m_s", 3),
                              reals("wall_angular_velocity_rad_s", 3)};
    for (const WallPlace& place : frame.walls) {
        for (int row = 0; row < 3; ++row)
            push(arrays[0], place.rotation.row(row));
        push(arrays[1], place.translation);
        push(arrays[2], place.velocity);
        push(arrays[3], place.angular_velocity);
    }
    return arrays;
}

void read_wall_places(Taker& taker, Frame& frame) {
    const Array& rotation = taker.take("wall_rotation", 9, false);
    const Array& translation = taker.take("wall_translation_m", 3, false);
    const Array& velocity = taker.take("wall_velocity_m_s", 3, false);
    const Array& spin = taker.take("wall_angular_velocity_rad_s", 3, false);
    for (const Array* other : {&translation, &velocity, &spin})
        taker.same_rows(rotation, *other);
    if (!taker.problems.empty())
        return;
    if (rotation.rows() != frame.layout->walls.size()) {
        taker.say(fmt::format("has {} walls, its layout has {}", rotation.rows(), frame.layout->walls.size()));
        return;
    }
    for (std::size_t i = 0; i < rotation.rows(); ++i) {
        WallPlace place;
        for (int k = 0; k < 9; ++k)
            place.rotation(k / 3, k % 3) = rotation.reals[9 * i + static_cast<std::size_t>(k)];
        place.translation = vector_at(translation, i);
        place.velocity = vector_at(velocity, i);
        place.angular_velocity = vector_at(spin, i);
        frame.walls.push_back(place);
    }
}

std::vector<Array> contact_arrays(const std::vector<FrameContact>& contacts) {
    std::vector<Array> arrays{whole(contacts_array, 2), whole("contact_wall", 1), reals("contact_point_m", 3),
                              reals("contact_normal", 3), reals("contact_force_N", 3)};
    for (const FrameContact& contact : contacts) {
        arrays[0].integers.insert(arrays[0].integers.end(), {contact.a, contact.b});
        arrays[1].integers.push_back(contact.wall);
        push(arrays[2], contact.point);
        push(arrays[3], contact.normal);
        push(arrays[4], contact.force);
    }
    return arrays;
}

/// Frames have them only where a run was asked to keep them.
void read_contacts(Taker& taker, const ArrayFile& content, Frame& frame) {
    const auto kept = [](const Array& array) { return array.name == contacts_array; };
    if (std::none_of(content.arrays.begin(), content.arrays.end(), kept))
        return;
    const Array& bodies = taker.take(contacts_array, 2, true);
    const Array& wall = taker.take("contact_wall", 1, true);
    const Array& point = taker.take("contact_point_m", 3, false);
    const Array& normal = taker.take("contact_normal", 3, false);
    const Array& force = taker.take("contact_force_N", 3, false);
    for (const Array* other : {&wall, &point, &normal, &force})
        taker.same_rows(bodies, *other);
    for (const Array* array : {&point, &normal, &force})
        taker.finite(*array);
    if (!taker.problems.empty())
        return;
    const auto known = [&](std::int64_t id) { return std::binary_search(frame.id.begin(), frame.id.end(), id); };
    frame.contacts.emplace();
    for (std::size_t i = 0; i < bodies.rows(); ++i) {
        const std::int64_t a = bodies.integers[2 * i], b = bodies.integers[2 * i + 1], w = wall.integers[i];
        const bool on_wall = b == -1 && w >= 0 && w < static_cast<std::int64_t>(frame.walls.size());
        if (!known(a) || !(on_wall || (w == -1 && known(b)))) {
            taker.say(fmt::format("contact {} names a body or a wall that is not there", i));
            return;
        }
        frame.contacts->push_back(
            {a, b, static_cast<int>(w), vector_at(point, i), vector_at(normal, i), vector_at(force, i)});
    }
}

} // namespace

bool take_instant(const nlohmann::json& head, double& time, std::int64_t& step) {
    if (!head.contains("time_s") || !head["time_s"].is_number() || !head.contains("step") ||
        !head["step"].is_number_integer())
        return false;
    time = head["time_s"];
    step = head["step"];
    return true;
}

ArrayFile to_arrays(const Frame& frame) {
    Array id = whole("id", 1), shape = whole("shape", 1), orientation = reals("orientation_wxyz", 4);
    id.integers = frame.id;
    shape.integers.assign(frame.shape.begin(), frame.shape.end());
    for (const Eigen::Quaterniond& q : frame.orientation)
        orientation.reals.insert(orientation.reals.end(), {q.w(), q.x(), q.y(), q.z()});
    ArrayFile content{.kind = "frame", .head = {{"time_s", frame.time}, {"step", frame.step}}, .arrays = {}};
    content.arrays = {id,
                      shape,
                      vectors("position_m", frame.position),
                      orientation,
                      vectors("velocity_m_s", frame.velocity),
                      vectors("angular_velocity_rad_s", frame.angular_velocity)};
    for (Array& array : wall_arrays(frame))
        content.arrays.push_back(std::move(array));
    if (frame.contacts)
        for (Array& array : contact_arrays(*frame.contacts))
            content.arrays.push_back(std::move(array));
    return content;
}

Result<Frame> frame_from(const ArrayFile& content, const std::shared_ptr<const FrameLayout>& layout) {
    Taker taker(content);
    const Array& id = taker.take("id", 1, true);
    const Array& shape = taker.take("shape", 1, true);
    const Array& position = taker.take("position_m", 3, false);
    const Array& orientation = taker.take("orientation_wxyz", 4, false);
    const Array& velocity = taker.take("velocity_m_s", 3, false);
    const Array& spin = taker.take("angular_velocity_rad_s", 3, false);
    for (const Array* other : {&shape, &position, &orientation, &velocity, &spin})
        taker.same_rows(id, *other);
    taker.within(shape, static_cast<std::int64_t>(layout->shapes.size()));
    for (const Array* array : {&position, &orientation, &velocity, &spin})
        taker.finite(*array);
    Frame frame;
    frame.layout = layout;
    if (!take_instant(content.head, frame.time, frame.step))
        taker.say("has no time_s and step in its head");
    if (!taker.problems.empty())
        return taker.problems;
    frame.id = id.integers;
    frame.shape.assign(shape.integers.begin(), shape.integers.end());
    frame.position = vectors_of(position);
    frame.velocity = vectors_of(velocity);
    frame.angular_velocity = vectors_of(spin);
    for (std::size_t i = 0; i < orientation.rows(); ++i) {
        const double* q = &orientation.reals[4 * i];
        frame.orientation.emplace_back(q[0], q[1], q[2], q[3]);
    }
    read_wall_places(taker, frame);
    read_contacts(taker, content, frame);
    if (!taker.problems.empty())
        return taker.problems;
    return frame;
}

} // namespace tumble::observe

#include "render/kernels/lanes.h"

namespace tumble::render::TUMBLE_ISA {

void measure_distances(const CreviceJob& job);
void gather_sky(const CreviceJob& job);
void blur_sky(const CreviceJob& job);

namespace {

constexpr float nothing = __builtin_inff();
constexpr int looks = 16;
constexpr int pattern = 4; // pixels a side, over which the looks are turned; the blur takes it out again

/// A ball's points that are looked at: on a spiral, r from the axis of sight where the radius is 1.
struct Looks {
    alignas(32) float across[pattern][looks][samples_at_once]; // by row of the pattern; eight pixels of a row
    alignas(32) float up[pattern][looks][samples_at_once];
    float half_length[looks]; // of the ball along the line of sight

    Looks() {
        for (int y = 0; y < pattern; ++y)
            for (int i = 0; i < looks; ++i) {
                const float r = __builtin_sqrtf((static_cast<float>(i) + 0.5F) / looks);
                half_length[i] = __builtin_sqrtf(1 - r * r);
                for (int x = 0; x < samples_at_once; ++x) {
                    const auto step = static_cast<float>(x % pattern * pattern + y);
                    const float angle = 2.39996F * static_cast<float>(i) + step * (0.3927F * 2.5F);
                    across[y][i][x] = r * __builtin_cosf(angle);
                    up[y][i][x] = r * __builtin_sinf(angle);
                }
            }
    }
};

TUMBLE_INLINE Words rounded(Lanes x) {
    return as_words(x + select(x < all(0.0F), all(-0.5F), all(0.5F)));
}

} // namespace

void measure_distances(const CreviceJob& job) {
    const float depth = job.farthest - job.nearest;
    for (int y = job.first; y < job.last; ++y) {
        const float* from = job.depth + static_cast<std::ptrdiff_t>(y) * job.width;
        float* to = job.distance + y * job.row;
        for (int x = 0; x < job.width; ++x) {
            const float d = from[x];
            const float away =
                job.perspective ? job.nearest * job.farthest / (job.farthest - d * depth) : job.nearest + d * depth;
            to[x] = d < 1 ? away : nothing;
        }
        for (int x = -samples_at_once; x < 0; ++x)
            to[x] = nothing;
        for (int x = job.width; x < job.width + 2 * samples_at_once; ++x)
            to[x] = nothing;
    }
}

void gather_sky(const CreviceJob& job) {
    static const Looks at;
    const Words columns{0, 1, 2, 3, 4, 5, 6, 7};
    const Words right = all(job.width - 1), above = all(job.height - 1), none = all(0),
                row = all(static_cast<int>(job.row));
    const Lanes to_radius = all(1 / job.radius), zero = all(0.0F), one = all(1.0F);
    float whole = 0;
    for (int i = 0; i < looks; ++i)
        whole += at.half_length[i];
    for (int y = job.first; y < job.last; ++y) {
        const float* distances = job.distance + y * job.row;
        float* to = job.sky + y * job.row;
        store(one, to - samples_at_once);
        for (int x = 0; x < job.width + samples_at_once; x += samples_at_once) {
            const Lanes own = load(distances + x);
            if (!any(own < all(nothing))) {
                store(one, to + x);
                continue;
            }
            const Lanes pixels = all(job.radius * job.scale);
            const Lanes reach = within(job.perspective ? pixels / own : pixels, all(3.0F), all(64.0F));
            const Words column = columns + all(x);
            Lanes open = zero; // over the radius
            for (int i = 0; i < looks; ++i) {
                const Words there_x = column + rounded(reach * load(at.across[y % pattern][i]));
                const Words there_y = all(y) + rounded(reach * load(at.up[y % pattern][i]));
                const Words index = smaller(larger(there_y, none), above) * row + smaller(larger(there_x, none), right);
                const Lanes behind = (look_up(job.distance, index) - own) * to_radius;
                const Lanes half = all(at.half_length[i]);
                const Lanes free = within(behind + half, zero, half + half);
                // What lies far in front only shades a little: it is another body, not this crevice's wall.
                const Lanes far_front = within(zero - behind - all(2.0F), zero, all(3.0F)) * all(1.0F / 3);
                open = open + free + far_front * (all(0.75F) * half - free);
            }
            store(select(own < all(nothing), within(open / all(whole), zero, one), one), to + x);
        }
    }
}

void blur_sky(const CreviceJob& job) {
    const Lanes near = all(0.3F * job.radius), strength = all(job.strength), one = all(1.0F);
    for (int y = job.first; y < job.last; ++y) {
        const std::ptrdiff_t here = y * job.row;
        for (int x = 0; x < job.width; x += samples_at_once) {
            std::uint8_t* to = job.shade + here + x;
            const Lanes own = load(job.distance + here + x);
            if (!any(own < all(nothing))) {
                __builtin_memset(to, 255, samples_at_once);
                continue;
            }
            Lanes sum = all(0.0F), count = all(0.0F);
            for (int dy = -2; dy < 2; ++dy) {
                const int row = y + dy < 0 ? 0 : y + dy < job.height ? y + dy : job.height - 1;
                const std::ptrdiff_t there = row * job.row + x;
                for (int dx = -2; dx < 2; ++dx) {
                    const Lanes apart = load(job.distance + there + dx) - own;
                    // Another body's shade would shine over the edge between them; a little of it keeps the edge
                    // smooth.
                    const Lanes same = select((apart < near) & (apart > all(0.0F) - near), one, all(0.2F));
                    sum = sum + same * load(job.sky + there + dx);
                    count = count + same;
                }
            }
            const Lanes light = one + strength * (sum / count - one);
            const Words bytes = as_words(select(own < all(nothing), light, one) * all(255.0F) + all(0.5F));
            for (int lane = 0; lane < samples_at_once; ++lane)
                to[lane] = static_cast<std::uint8_t>(bytes[lane]);
        }
    }
}

} // namespace tumble::render::TUMBLE_ISA

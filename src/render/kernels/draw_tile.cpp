#include "render/kernels/lanes.h"

namespace tumble::render::TUMBLE_ISA {

void draw_tile(const TileJob& job);

namespace {

constexpr int block_side = 8; // pixels; what is hidden is asked block by block
constexpr int most_blocks = 32;
constexpr int most_rows = 32, most_packs = 32; // of a tile
constexpr int between_looks = 16;              // balls until the tile's farthest sample is looked for again
constexpr int ahead = 12; // balls are sent for before they are needed: they lie all over the memory
constexpr float nowhere = -__builtin_inff();
constexpr float share_of_cut_faces = 0.8F; // of the body's colour: a little darker than what the lamp falls on

/// What the samples of a tile see so far.
struct Board {
    alignas(64) float z[samples_in_tile]; // m, view space
    alignas(64) std::int32_t ball[samples_in_tile];
    alignas(64) float slant[samples_in_tile]; // perspective: cosine between a sample's line of sight and the axis
    alignas(32) float across[most_packs][samples_at_once]; // pixels from the axis to the samples of a pack,
    alignas(32) float up[most_rows][samples_at_once];      // and of a row
    alignas(64) float cut_from[samples_in_tile]; // m, view space: between these two a sample's line of sight lies
    alignas(64) float cut_to[samples_in_tile];   // inside the planes; only where something is cut
    float farthest[most_blocks];                 // m, of a block's samples, or farther
    bool stale[most_blocks];                     // something has been drawn since
};

/// Packs of eight samples and rows of a tile, ends included.
struct Patch {
    int first, last, low, high;
};

class Painting {
public:
    Painting(const TileJob& job, Board& board)
        : job_(job), board_(board), packs_(job.sampling.tile_width() / job.sampling.pixels_at_once()),
          rows_(job.sampling.tile_height()), block_columns_(job.sampling.tile_width() / block_side),
          block_rows_(rows_ / block_side),
          pack_shift_(__builtin_ctz(static_cast<unsigned>(job.sampling.pixels_at_once()))),
          block_shift_(__builtin_ctz(static_cast<unsigned>(packs_ / block_columns_))) {}

    template <bool perspective, bool cut> TUMBLE_INLINE void paint() {
        clear();
        if (perspective)
            measure_slants();
        if (cut)
            measure_cut<perspective>();
        for (int i = 0; i < job_.count; ++i) {
            const ListedBall& listed = job_.listed[i];
            if (i + ahead < job_.count)
                __builtin_prefetch(job_.balls + job_.listed[i + ahead].ball);
            if (i % between_looks == between_looks - 1)
                look_for_farthest();
            if (job_.skip_hidden && listed.nearest + job_.disorder <= farthest_)
                break; // and so are all that follow
            const Patch patch = patch_of(listed);
            if (!job_.skip_hidden || !is_hidden(patch, listed.nearest))
                put<perspective, cut>(job_.balls[listed.ball], static_cast<std::int32_t>(listed.ball), patch);
        }
        shade<perspective, cut>();
    }

private:
    TUMBLE_INLINE void clear() {
        for (int s = 0; s < samples_in_tile; s += samples_at_once) {
            store(all(nowhere), board_.z + s);
            store(all(-1), board_.ball + s);
        }
        for (int b = 0; b < block_columns_ * block_rows_; ++b) {
            board_.farthest[b] = nowhere;
            board_.stale[b] = false;
        }
        for (int pack = 0; pack < packs_; ++pack) {
            const int pixel = job_.left + (pack << pack_shift_);
            store(load(job_.sampling.across) + all(static_cast<float>(pixel) - job_.sight.centre_x),
                  board_.across[pack]);
        }
        for (int row = 0; row < rows_; ++row)
            store(load(job_.sampling.up) + all(static_cast<float>(job_.bottom + row) - job_.sight.centre_y),
                  board_.up[row]);
    }

    TUMBLE_INLINE Lanes across(int pack) const { return load(board_.across[pack]); }
    TUMBLE_INLINE Lanes up(int row) const { return load(board_.up[row]); }

    TUMBLE_INLINE void measure_slants() {
        const Lanes per_pixel = all(1 / job_.sight.scale);
        for (int row = 0; row < rows_; ++row)
            for (int pack = 0; pack < packs_; ++pack) {
                const Lanes x = across(pack) * per_pixel, y = up(row) * per_pixel;
                store(all(1.0F) / root(all(1.0F) + x * x + y * y), board_.slant + at(row, pack));
            }
    }

    /// Where each line of sight enters and leaves the box. A place on it is (x, y, z), in perspective -z (x, y, -1), so
    /// that the planes' condition is one on z alone.
    template <bool perspective> TUMBLE_INLINE void measure_cut() {
        const Lanes per_pixel = all(1 / job_.sight.scale), zero = all(0.0F);
        for (int row = 0; row < rows_; ++row)
            for (int pack = 0; pack < packs_; ++pack) {
                const Lanes x = across(pack) * per_pixel, y = up(row) * per_pixel;
                Lanes from = all(-nowhere), to = all(nowhere);
                for (int k = 0; k < planes_of_cut; ++k) {
                    const CutPlane& plane = job_.cut[k];
                    const Lanes beside = all(plane.x) * x + all(plane.y) * y;
                    const Lanes slope = perspective ? all(plane.z) - beside : all(plane.z);
                    const Lanes rest = perspective ? all(plane.offset) : all(plane.offset) - beside;
                    const Lanes meets = rest / slope;
                    from = select(slope > zero, smaller(from, meets), from);
                    to = select(slope < zero, larger(to, meets), to);
                    from = select((slope == zero) & (rest < zero), all(nowhere), from);
                }
                store(from, board_.cut_from + at(row, pack));
                store(to, board_.cut_to + at(row, pack));
            }
    }

    TUMBLE_INLINE int at(int row, int pack) const { return (row * packs_ + pack) * samples_at_once; }

    TUMBLE_INLINE Patch patch_of(const ListedBall& listed) const {
        return {listed.left >> pack_shift_, listed.right >> pack_shift_, listed.bottom, listed.top};
    }

    /// m, of a block's samples.
    TUMBLE_INLINE float farthest_in(int row, int column) {
        const int block = row * block_columns_ + column;
        if (!board_.stale[block])
            return board_.farthest[block];
        const int pack = column << block_shift_, end = pack + (1 << block_shift_);
        Lanes z = load(board_.z + at(row * block_side, pack));
        for (int r = row * block_side; r < (row + 1) * block_side; ++r)
            for (int p = pack; p < end; ++p)
                z = smaller(z, load(board_.z + at(r, p)));
        board_.stale[block] = false;
        return board_.farthest[block] = least(z);
    }

    TUMBLE_INLINE void look_for_farthest() {
        farthest_ = __builtin_inff();
        for (int row = 0; row < block_rows_; ++row)
            for (int column = 0; column < block_columns_; ++column) {
                const float farthest = farthest_in(row, column);
                farthest_ = farthest < farthest_ ? farthest : farthest_;
            }
    }

    /// Whether everything that the patch's blocks show is at least as near as `nearest` (m).
    TUMBLE_INLINE bool is_hidden(const Patch& patch, float nearest) {
        for (int row = patch.low / block_side; row <= patch.high / block_side; ++row)
            for (int column = patch.first >> block_shift_; column <= patch.last >> block_shift_; ++column)
                if (farthest_in(row, column) < nearest)
                    return false;
        return true;
    }

    TUMBLE_INLINE void soil(const Patch& patch) {
        for (int row = patch.low / block_side; row <= patch.high / block_side; ++row)
            for (int column = patch.first >> block_shift_; column <= patch.last >> block_shift_; ++column)
                board_.stale[row * block_columns_ + column] = true;
    }

    TUMBLE_INLINE float metres_per_pixel(const Ball& ball, bool perspective) const {
        return perspective ? -ball.z / job_.sight.scale : 1 / job_.sight.scale;
    }

    /// In pixels at the ball's depth. The point of a line of sight that is nearest to the centre lies `along` it from
    /// where it meets the plane of the centre; half the chord about it lies inside. Beside the ball that is the root of
    /// a negative number, which is nearer than nothing.
    template <bool perspective, bool cut> TUMBLE_INLINE void put(const Ball& ball, std::int32_t k, const Patch& patch) {
        const float metres = metres_per_pixel(ball, perspective);
        const float radius = ball.radius / metres;
        const Lanes radius2 = all(radius * radius), depth = all(ball.z), to_metres = all(metres);
        const Lanes x_to_ball = all(job_.sight.centre_x - ball.x), y_to_ball = all(job_.sight.centre_y - ball.y);
        const Lanes per_pixel = all(1 / job_.sight.scale);
        for (int row = patch.low; row <= patch.high; ++row) {
            const Lanes y = up(row), off_y = y + y_to_ball;
            const Lanes left2 = radius2 - off_y * off_y;
            for (int pack = patch.first; pack <= patch.last; ++pack) {
                const int s = at(row, pack);
                const Lanes x = across(pack), off_x = x + x_to_ball;
                Lanes z, back{};
                if (perspective) {
                    const Lanes slant = load(board_.slant + s);
                    const Lanes along = (off_x * x + off_y * y) * per_pixel * slant;
                    const Lanes half_chord = root(left2 - off_x * off_x + along * along);
                    z = depth + to_metres * slant * (along + half_chord);
                    if (cut)
                        back = depth + to_metres * slant * (along - half_chord);
                } else {
                    z = depth + to_metres * root(left2 - off_x * off_x);
                    if (cut)
                        back = depth + depth - z;
                }
                const Lanes before = load(board_.z + s);
                Words nearer = z > before;
                if (cut) {
                    const Lanes from = load(board_.cut_from + s), to = load(board_.cut_to + s);
                    const Words inside = (z > to) & (back < from); // beside the ball neither holds
                    z = smaller(z, from);
                    nearer = inside & (z > before);
                }
                store(nearer ? z : before, board_.z + s);
                Words seen;
                __builtin_memcpy(&seen, board_.ball + s, sizeof seen);
                store(nearer ? all(k) : seen, board_.ball + s);
            }
        }
        soil(patch);
    }

    /// What the samples of a pack see: columns of the balls' numbers.
    struct Seen {
        Lanes x, y, z, radius, red, green, blue;
    };

    TUMBLE_INLINE Seen gather(const std::int32_t* balls) const {
        Seen seen{};
        for (int lane = 0; lane < samples_at_once; ++lane) {
            const Ball& ball = job_.balls[balls[lane] < 0 ? 0 : balls[lane]];
            seen.x[lane] = ball.x;
            seen.y[lane] = ball.y;
            seen.z[lane] = ball.z;
            seen.radius[lane] = ball.radius;
            seen.red[lane] = static_cast<float>(ball.color & 0xffU);
            seen.green[lane] = static_cast<float>(ball.color >> 8 & 0xffU);
            seen.blue[lane] = static_cast<float>(ball.color >> 16 & 0xffU);
        }
        return seen;
    }
    TUMBLE_INLINE Seen spread(const Ball& ball) const {
        return {all(ball.x),
                all(ball.y),
                all(ball.z),
                all(ball.radius),
                all(static_cast<float>(ball.color & 0xffU)),
                all(static_cast<float>(ball.color >> 8 & 0xffU)),
                all(static_cast<float>(ball.color >> 16 & 0xffU))};
    }

    template <bool perspective, bool cut> TUMBLE_INLINE void shade() const {
        for (int row = 0; row < rows_; ++row) {
            for (int pack = 0; pack < packs_; ++pack) {
                const int s = at(row, pack);
                const std::ptrdiff_t to = row * job_.row + static_cast<std::ptrdiff_t>(pack) * samples_at_once;
                Words k;
                __builtin_memcpy(&k, board_.ball + s, sizeof k);
                const Words there = k >= all(0);
                if (!any(there)) {
                    store(all(0), job_.colors + to);
                    store(all(1.0F), job_.depths + to);
                    continue;
                }
                const Lanes z = load(board_.z + s);
                const Lanes where = perspective ? all(job_.sight.depth_slope) / z : all(job_.sight.depth_slope) * z;
                store(select(there, all(job_.sight.depth_at_0) + where, all(1.0F)), job_.depths + to);
                const bool alone = !any(k != all(k[0]));
                const Seen seen = alone ? spread(job_.balls[k[0]]) : gather(board_.ball + s);
                const Lanes slant = perspective ? load(board_.slant + s) : all(1.0F);
                const Words on_face = cut ? z == load(board_.cut_from + s) : all(0);
                store(light<perspective, cut>(seen, across(pack), up(row), z, slant, on_face), job_.colors + to);
            }
        }
    }

    template <bool perspective, bool cut>
    TUMBLE_INLINE Words light(const Seen& ball, Lanes x, Lanes y, Lanes z, Lanes slant, Words on_face) const {
        if (!job_.light.lit)
            return pack(ball.red, ball.green, ball.blue);
        const Lanes per_pixel = all(1 / job_.sight.scale);
        const Lanes off_x = x + all(job_.sight.centre_x) - ball.x, off_y = y + all(job_.sight.centre_y) - ball.y;
        const Lanes one = all(1.0F), zero = all(0.0F);
        // From the centre to the point that is seen, over the radius.
        const Lanes to_radius = one / ball.radius;
        Lanes normal_x, normal_y, facing; // facing: cosine between normal and the way to the eye
        const Lanes normal_z = (z - ball.z) * to_radius;
        Lanes half_x, half_y, half_z;                                    // between lamp and eye
        constexpr float lamp_x = -0.40F, lamp_y = 0.66F, lamp_z = 0.63F; // over the left shoulder
        if (perspective) {
            const Lanes sight_x = x * per_pixel, sight_y = y * per_pixel;
            normal_x = (sight_x * (ball.z - z) - off_x * per_pixel * ball.z) * to_radius;
            normal_y = (sight_y * (ball.z - z) - off_y * per_pixel * ball.z) * to_radius;
            facing = slant * (normal_z - sight_x * normal_x - sight_y * normal_y);
            half_x = all(lamp_x) - sight_x * slant;
            half_y = all(lamp_y) - sight_y * slant;
            half_z = all(lamp_z) + slant;
        } else {
            normal_x = off_x * per_pixel * to_radius;
            normal_y = off_y * per_pixel * to_radius;
            facing = normal_z;
            half_x = all(lamp_x);
            half_y = all(lamp_y);
            half_z = all(lamp_z + 1);
        }
        const Lanes half = root(half_x * half_x + half_y * half_y + half_z * half_z);
        Lanes gloss = larger((normal_x * half_x + normal_y * half_y + normal_z * half_z) / half, zero);
        for (int k = 0; k < 5; ++k)
            gloss = gloss * gloss; // to the 32nd
        const Lanes lamp = larger(normal_x * all(lamp_x) + normal_y * all(lamp_y) + normal_z * all(lamp_z), zero);
        Lanes share = all(0.49F) + all(0.10F) * normal_y + all(0.54F) * lamp;
        const Lanes turned = one - facing;
        Lanes added = all(255.0F) * (all(0.10F) * gloss + all(job_.light.rim) * turned * turned);
        if (cut) {
            share = select(on_face, all(share_of_cut_faces), share);
            added = select(on_face, zero, added);
        }
        return pack(ball.red * share + added, ball.green * share + added, ball.blue * share + added);
    }

    /// Of 0 to 255, rounded; opaque.
    TUMBLE_INLINE static Words pack(Lanes red, Lanes green, Lanes blue) {
        const auto byte = [](Lanes v) TUMBLE_INLINE_LAMBDA {
            return as_words(smaller(larger(v, all(0.0F)), all(255.0F)) + all(0.5F));
        };
        return byte(red) | byte(green) << 8 | byte(blue) << 16 | all(static_cast<std::int32_t>(0xff000000U));
    }

    const TileJob& job_;
    Board& board_;
    const int packs_, rows_; // of the tile
    const int block_columns_, block_rows_;
    const int pack_shift_, block_shift_; // powers of 2: pixels of a pack, packs of a block's row
    float farthest_ = nowhere;           // m, of all samples, or farther
};

} // namespace

void draw_tile(const TileJob& job) {
    Board board;
    Painting painting(job, board);
    if (job.cut != nullptr)
        job.sight.perspective ? painting.paint<true, true>() : painting.paint<false, true>();
    else
        job.sight.perspective ? painting.paint<true, false>() : painting.paint<false, false>();
}

} // namespace tumble::render::TUMBLE_ISA

#include "case.h"

#include "separation.h"

#include <fmt/format.h>

namespace blind {

namespace {

const double sizes[] = {2, 3.5, 5, 8};

std::vector<std::string> ids(bool listed) {
    std::vector<std::string> all;
    for (const Effect& effect : effects())
        if (effect.listed == listed)
            all.push_back(effect.id);
    return all;
}

/// Scene keys of a drop, as the reader of a measurement would type them.
std::string sets_of(const Drop& drop, const Ball& ball) {
    std::string sets = fmt::format("\"fill.0.position_m.1={}\"", ball.radius + drop.height);
    if (drop.light)
        sets += fmt::format(", \"body.ball.mass_kg={}\"", ball.mass / 4);
    return sets;
}

std::string measurement_of(const Case& made, const Ball& ball) {
    std::string toml = "title = \"A ball dropped, filmed from the side\"\n\n"
                       "[[nuisance]]\nkey = \"pair.leather-wood.restitution\"\nspread = 0.05\n\n"
                       "[[nuisance]]\ninstrument = \"clock_offset\"\nper = \"series\"\nspread = 0.005\n";
    for (std::size_t r = 0; r < made.files.size(); ++r) {
        toml += fmt::format("\n[[series]]\nname = \"{}{:.0f} mm\"\nfile = \"{}\"\nset = [{}]\n",
                            made.setup.drops[r].light ? "light ball, " : "", 1000 * made.setup.drops[r].height,
                            made.files[r], sets_of(made.setup.drops[r], ball));
        toml += fmt::format("[[series.column]]\nhead = \"height\"\nmeasure = \"centre_of_mass_y\"\nsigma = {:.3g}\n",
                            1000 * made.setup.sigma);
        if (made.setup.clock)
            toml += "[[series.column]]\nhead = \"clock\"\nmeasure = \"time\"\nsigma = 1\n";
    }
    return toml;
}

/// Noise of the kind that laboratories have: mostly white, sometimes with memory, a slip here and there, rounded.
struct Dirt {
    double memory = 0;
    double outliers = 0;
    double step = 0;  // of the reading, in sigma
    double mains = 0; // in sigma, 50 Hz
    bool drops_a_frame = false;
};

Dirt draw_dirt(Random& random) {
    Dirt dirt;
    if (random.chance(0.3))
        dirt.memory = random.uniform(0, 0.4);
    dirt.outliers = 0.005;
    dirt.step = random.chance(0.3) ? 0.3 : 0.01;
    dirt.mains = random.chance(0.2) ? 0.3 : 0;
    dirt.drops_a_frame = random.chance(0.3);
    return dirt;
}

void write_records(Case& made, const Eigen::VectorXd& clean, const Dirt& dirt, Random& random) {
    const std::vector<double> times = times_of(made.setup);
    const auto count = static_cast<Eigen::Index>(times.size());
    for (std::size_t r = 0; r < made.setup.drops.size(); ++r) {
        std::string csv = made.setup.clock ? "time_s,height_mm,clock_ms\n" : "time_s,height_mm\n";
        const int lost = dirt.drops_a_frame ? random.below(static_cast<int>(times.size())) : -1;
        double error = random.normal();
        const double phase = random.uniform(0, 6.283185307179586);
        for (Eigen::Index k = 0; k < count; ++k) {
            error = dirt.memory * error + std::sqrt(1 - dirt.memory * dirt.memory) * random.normal();
            double noise =
                error + dirt.mains * std::sin(314.1592653589793 * times[static_cast<std::size_t>(k)] + phase);
            if (random.chance(dirt.outliers))
                noise += (random.chance(0.5) ? 1 : -1) * random.uniform(8, 20);
            const double steps = clean[static_cast<Eigen::Index>(r) * count + k] + noise;
            const double reading = std::round(steps / dirt.step) * dirt.step * made.setup.sigma;
            if (k == lost)
                continue;
            csv += fmt::format("{:.6f},{:.4f}", times[static_cast<std::size_t>(k)], 1000 * reading);
            if (made.setup.clock) {
                const auto row = static_cast<Eigen::Index>(made.setup.drops.size() + r) * count + k;
                csv += fmt::format(",{:.4f}", clean[row] + random.normal());
            }
            csv += '\n';
        }
        made.files.push_back(fmt::format("drop-{}.csv", r + 1));
        made.csv.push_back(std::move(csv));
    }
}

Setup draw_setup(bool light, Random& random) {
    Setup setup;
    for (const double height : {0.5, 0.8, 1.1, 1.5})
        setup.drops.push_back({std::round(1000 * height * random.uniform(0.9, 1.1)) / 1000, false});
    if (light) {
        setup.drops.push_back({std::round(1000 * random.uniform(0.7, 0.9)) / 1000, true});
        setup.drops.push_back({std::round(1000 * random.uniform(1.3, 1.5)) / 1000, true});
    }
    setup.rate_hz = std::round(random.uniform(96, 144));
    setup.sigma = std::round(1e6 * random.uniform(0.7, 1.3) * 2e-3) / 1e6;
    setup.clock = light;
    return setup;
}

} // namespace

Ball baseline_ball() {
    return {.radius = 0.12,
            .mass = 0.6,
            .modulus = 1 / ((1 - 0.3 * 0.3) / 1.27e6 + (1 - 0.3 * 0.3) / 1e10),
            .restitution = 0.8};
}

std::vector<Order> mixed_orders(int count, Random& random) {
    const std::vector<std::string> listed = ids(true), unlisted = ids(false);
    std::vector<Order> orders;
    for (int k = 0; k < count; ++k) {
        Order order{.kind = "null", .effects = {}, .wanted = sizes[random.below(4)], .light = random.chance(0.5)};
        const double draw = random.uniform();
        if (draw >= 0.25 && draw < 0.7) {
            order.kind = "listed";
            order.effects = {listed[static_cast<std::size_t>(random.below(static_cast<int>(listed.size())))]};
        } else if (draw >= 0.7 && draw < 0.8) {
            order.kind = "two";
            const int first = random.below(static_cast<int>(listed.size()));
            const int shift = 1 + random.below(static_cast<int>(listed.size()) - 1);
            order.effects = {listed[static_cast<std::size_t>(first)],
                             listed[static_cast<std::size_t>((first + shift) % static_cast<int>(listed.size()))]};
            order.wanted = 15;
        } else if (draw >= 0.8) {
            order.kind = "unlisted";
            order.effects = {unlisted[static_cast<std::size_t>(random.below(static_cast<int>(unlisted.size())))]};
        }
        orders.push_back(std::move(order));
    }
    return orders;
}

Case make_case(const Order& order, Random& random) {
    Case made;
    made.setup = draw_setup(order.light, random);
    Truth without;
    without.ball = baseline_ball();
    without.ball.restitution += random.uniform(-0.03, 0.03);
    without.offsets.assign(made.setup.drops.size(), 0);
    without.restitution.assign(made.setup.drops.size(), 0);
    Truth truth = without;
    nlohmann::ordered_json hidden = nlohmann::ordered_json::array();
    for (const std::string& id : order.effects) {
        const Effect& effect = *find_effect(id);
        const double sign = effect.one_sided || random.chance(0.5) ? 1 : -1;
        const double amplitude = amplitude_for(made.setup, without, effect, order.wanted, sign);
        made.possible = made.possible && amplitude != 0;
        effect.hide(truth, amplitude);
        hidden.push_back({{"id", id}, {"listed", effect.listed}, {"amplitude", amplitude}});
    }
    const std::string own = order.effects.size() == 1 ? order.effects[0] : "";
    const Separation size =
        order.effects.size() == 1 && made.possible ? separation_of(made.setup, truth, without, own) : Separation{};
    for (double& offset : truth.offsets)
        offset = std::clamp(0.004 * random.normal(), -0.012, 0.012);
    write_records(made, readings_of(made.setup, truth), draw_dirt(random), random);
    made.measurement = measurement_of(made, without.ball);
    made.answer = {{"kind", order.kind},      {"design", order.light ? "E3" : "E2"},
                   {"hidden", hidden},        {"wanted", order.wanted},
                   {"d", size.detectable},    {"d_sep", size.separable},
                   {"nearest", size.nearest}, {"restitution", without.ball.restitution}};
    return made;
}

} // namespace blind

#include "case.h"

#include "separation.h"

#include <algorithm>
#include <fmt/format.h>

namespace blind {

namespace {

const double sizes[] = {2, 3.5, 5, 8};
constexpr double pi = 3.14159265358979323846;

/// What a measurement of a bench begins with: its title, and what nobody knows of it exactly.
const char* head_of(Bench bench) {
    if (bench == Bench::drop)
        return "title = \"A ball dropped, filmed from the side\"\n\n"
               "[[nuisance]]\nkey = \"pair.leather-wood.restitution\"\nspread = 0.05\n";
    if (bench == Bench::lane)
        return "title = \"A ball thrown along a lane, filmed from above\"\n\n"
               "[[nuisance]]\nkey = \"pair.rubber-wood.friction\"\nspread = 0.03\n\n"
               "[[nuisance]]\nkey = \"fill.0.velocity_m_s.0\"\nper = \"series\"\nspread = 0.03\n";
    return "title = \"A tripod that slides down a slope, filmed from above\"\n\n"
           "[[nuisance]]\nkey = \"pair.plastic-board.friction\"\nspread = 0.03\n";
}

std::vector<std::string> ids(bool listed, Bench bench) {
    std::vector<std::string> all;
    for (const Effect& effect : effects())
        if (effect.listed == listed && shows(effect, bench))
            all.push_back(effect.id);
    return all;
}

/// Scene keys of a trial, as the reader of a measurement would type them.
std::string sets_of(const Setup& setup, const Trial& trial, const Truth& known) {
    if (setup.bench == Bench::drop)
        return fmt::format("\"fill.0.position_m.1={}\"{}", known.ball.radius + trial.height,
                           trial.light ? fmt::format(", \"body.ball.mass_kg={}\"", known.ball.mass / 4) : "");
    const double slope = trial.slope * pi / 180;
    const std::string leaning =
        fmt::format("\"gravity_m_s2=[{:.9f}, {:.9f}, 0.0]\"", known.lane.gravity * std::sin(slope),
                    -known.lane.gravity * std::cos(slope));
    if (setup.bench == Bench::slope)
        return leaning;
    return fmt::format("\"fill.0.velocity_m_s.0={}\"{}", trial.speed, trial.slope == 0 ? "" : ", " + leaning);
}

std::string name_of(const Setup& setup, const Trial& trial) {
    if (setup.bench == Bench::drop)
        return fmt::format("{}{:.0f} mm", trial.light ? "light ball, " : "", 1000 * trial.height);
    if (setup.bench == Bench::slope)
        return fmt::format("{:+.1f} deg", trial.slope);
    return trial.slope == 0 ? fmt::format("{:+.2f} m/s", trial.speed)
                            : fmt::format("{:+.2f} m/s on {:+.0f} deg", trial.speed, trial.slope);
}

std::string measurement_of(const Case& made, const Truth& known) {
    const bool drops = made.setup.bench == Bench::drop;
    std::string toml = head_of(made.setup.bench);
    toml += "\n[[nuisance]]\ninstrument = \"clock_offset\"\nper = \"series\"\nspread = 0.005\n";
    for (std::size_t r = 0; r < made.files.size(); ++r) {
        const Trial& trial = made.setup.trials[r];
        toml += fmt::format("\n[[series]]\nname = \"{}\"\nfile = \"{}\"\nset = [{}]\n", name_of(made.setup, trial),
                            made.files[r], sets_of(made.setup, trial, known));
        toml += fmt::format("[[series.column]]\nhead = \"{}\"\nmeasure = \"centre_of_mass_{}\"\nsigma = {:.3g}\n",
                            drops ? "height" : "way", drops ? "y" : "x", 1000 * made.setup.sigma);
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
    for (std::size_t r = 0; r < made.setup.trials.size(); ++r) {
        std::string csv = fmt::format("time_s,{}_mm{}\n", made.setup.bench == Bench::drop ? "height" : "way",
                                      made.setup.clock ? ",clock_ms" : "");
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
                const auto row = static_cast<Eigen::Index>(made.setup.trials.size() + r) * count + k;
                csv += fmt::format(",{:.4f}", clean[row] + random.normal());
            }
            csv += '\n';
        }
        const char* done[] = {"drop", "throw", "slide"};
        made.files.push_back(fmt::format("{}-{}.csv", done[static_cast<int>(made.setup.bench)], r + 1));
        made.csv.push_back(std::move(csv));
    }
}

/// Four drops from different heights; with `more` two of a light ball, and a clock in the picture.
void draw_drops(Setup& setup, bool more, Random& random) {
    for (const double height : {0.5, 0.8, 1.1, 1.5})
        setup.trials.push_back({.height = std::round(1000 * height * random.uniform(0.9, 1.1)) / 1000});
    if (more) {
        setup.trials.push_back({.height = std::round(1000 * random.uniform(0.7, 0.9)) / 1000, .light = true});
        setup.trials.push_back({.height = std::round(1000 * random.uniform(1.3, 1.5)) / 1000, .light = true});
    }
    setup.rate_hz = std::round(random.uniform(96, 144));
}

/// Two throws each way on the level; with `more` one each way up a slope, and a clock in the picture.
void draw_throws(Setup& setup, bool more, Random& random) {
    for (const double speed : {2.5, -2.5, 1.4, -1.4})
        setup.trials.push_back({.speed = std::round(100 * speed * random.uniform(0.9, 1.1)) / 100});
    if (more)
        for (const double way : {1.0, -1.0})
            setup.trials.push_back(
                {.speed = way * std::round(100 * random.uniform(1.8, 2.2)) / 100, .slope = -3 * way});
    setup.rate_hz = std::round(random.uniform(48, 72));
    setup.duration = 2;
}

/// Three slopes, each to either side; with `more` a steeper one, and a clock in the picture.
void draw_slides(Setup& setup, bool more, Random& random) {
    for (const double slope : {18.0, -18.0, 24.0, -24.0, 30.0, -30.0})
        setup.trials.push_back({.slope = std::round(10 * slope * random.uniform(0.97, 1.03)) / 10});
    if (more)
        for (const double slope : {36.0, -36.0})
            setup.trials.push_back({.slope = std::round(10 * slope * random.uniform(0.97, 1.03)) / 10});
    setup.rate_hz = std::round(random.uniform(80, 120));
    setup.duration = 0.8;
}

Setup draw_setup(Bench bench, bool more, Random& random) {
    Setup setup;
    setup.bench = bench;
    (bench == Bench::drop ? draw_drops : bench == Bench::lane ? draw_throws : draw_slides)(setup, more, random);
    setup.sigma = std::round(1e6 * random.uniform(0.7, 1.3) * 2e-3) / 1e6;
    setup.clock = more;
    return setup;
}

} // namespace

Truth baseline(Bench bench) {
    const auto modulus = [](double soft) { return 1 / ((1 - 0.3 * 0.3) / soft + (1 - 0.3 * 0.3) / 1e10); };
    Truth truth;
    truth.ball = {.radius = 0.12, .mass = 0.6, .modulus = modulus(1.27e6), .restitution = 0.8};
    truth.lane = {.radius = 0.05, .mass = 0.5, .modulus = modulus(2e7), .friction = 0.2, .fast_friction = 0.2};
    if (bench == Bench::slope) // air takes its three feet of 5 mm for one sphere of their volume
        truth.lane = {.radius = 5e-3 * std::cbrt(3.0),
                      .mass = 1200 * 3 * 4.0 / 3 * pi * 5e-3 * 5e-3 * 5e-3,
                      .friction = 0.27,
                      .fast_friction = 0.27};
    return truth;
}

std::vector<Order> mixed_orders(int count, Random& random) {
    std::vector<Order> orders;
    for (int k = 0; k < count; ++k) {
        Order order{.kind = "null", .effects = {}, .wanted = sizes[random.below(4)]};
        order.bench = static_cast<Bench>(random.below(3));
        order.more = random.chance(0.5);
        const std::vector<std::string> listed = ids(true, order.bench), unlisted = ids(false, order.bench);
        const auto one_of = [&](const std::vector<std::string>& all) {
            return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
        };
        const double draw = random.uniform();
        if (draw >= 0.25 && draw < 0.7) {
            order.kind = "listed";
            order.effects = {one_of(listed)};
        } else if (draw >= 0.7 && draw < 0.8) {
            order.kind = "two";
            order.effects = {one_of(listed), one_of(listed)};
            while (order.effects[1] == order.effects[0])
                order.effects[1] = one_of(listed);
            order.wanted = 15;
        } else if (draw >= 0.8) {
            order.kind = "unlisted";
            order.effects = {one_of(unlisted)};
        }
        orders.push_back(std::move(order));
    }
    return orders;
}

namespace {

void measure(Case& made, Random& random) {
    const Order& order = made.order;
    Truth truth = made.without;
    nlohmann::ordered_json hidden = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < order.effects.size(); ++k) {
        const Effect& effect = *find_effect(order.effects[k]);
        effect.hide(truth, made.amplitudes[k]);
        hidden.push_back({{"id", effect.id}, {"listed", effect.listed}, {"amplitude", made.amplitudes[k]}});
    }
    const std::string own = order.effects.size() == 1 ? order.effects[0] : "";
    const Separation size =
        order.effects.size() == 1 && made.possible ? separation_of(made.setup, truth, made.without, own) : Separation{};
    for (double& offset : truth.offsets)
        offset = std::clamp(0.004 * random.normal(), -0.012, 0.012);
    for (double& speed : truth.speeds)
        speed = std::clamp(0.02 * random.normal(), -0.06, 0.06);
    write_records(made, readings_of(made.setup, truth), draw_dirt(random), random);
    made.measurement = measurement_of(made, baseline(order.bench));
    made.answer = {{"kind", order.kind},      {"bench", word_of(order.bench)}, {"more", order.more},
                   {"hidden", hidden},        {"wanted", order.wanted},        {"d", size.detectable},
                   {"d_sep", size.separable}, {"nearest", size.nearest}};
}

void forget_trials(Truth& truth, std::size_t trials) {
    truth.offsets.assign(trials, 0);
    truth.speeds.assign(trials, 0);
    truth.restitution.assign(trials, 0);
}

} // namespace

Case make_case(const Order& order, Random& random) {
    Case made;
    made.order = order;
    made.setup = draw_setup(order.bench, order.more, random);
    made.without = baseline(order.bench);
    const double off = random.uniform(-1, 1); // of restitution or friction, from what the scene has
    made.without.ball.restitution += 0.03 * off;
    made.without.lane.friction += 0.02 * off;
    made.without.lane.fast_friction = made.without.lane.friction;
    forget_trials(made.without, made.setup.trials.size());
    for (const std::string& id : order.effects) {
        const Effect& effect = *find_effect(id);
        const double sign = effect.one_sided || random.chance(0.5) ? 1 : -1;
        made.amplitudes.push_back(amplitude_for(made.setup, made.without, effect, order.wanted, sign));
        made.possible = made.possible && made.amplitudes.back() != 0;
    }
    measure(made, random);
    return made;
}

Case with_more(const Case& plain, Random& random) {
    Case made;
    made.order = plain.order;
    made.order.kind = "loop";
    made.order.more = true;
    made.setup = plain.setup;
    made.setup.trials = draw_setup(plain.order.bench, true, random).trials;
    std::copy(plain.setup.trials.begin(), plain.setup.trials.end(), made.setup.trials.begin());
    made.setup.clock = true;
    made.without = plain.without;
    made.amplitudes = plain.amplitudes;
    forget_trials(made.without, made.setup.trials.size());
    measure(made, random);
    return made;
}

} // namespace blind

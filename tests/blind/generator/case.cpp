#include "case.h"

#include "separation.h"
#include "setups.h"
#include "told.h"

#include <algorithm>
#include <fmt/format.h>

namespace blind {

namespace {

const double sizes[] = {2, 3.5, 5, 8};
// Throws at the floor half as often as what else there is, for a diagnosis of them takes ten times as long; the plate
// only by order: no diagnosis of it has been proved yet.
constexpr Bench drawn[] = {Bench::drop, Bench::drop, Bench::lane, Bench::lane, Bench::slope,  Bench::slope,
                           Bench::roll, Bench::roll, Bench::spin, Bench::spin, Bench::oblique};

std::vector<std::string> ids(bool listed, Bench bench) {
    std::vector<std::string> all;
    for (const Effect& effect : effects())
        if (effect.listed == listed && shows(effect, bench))
            all.push_back(effect.id);
    return all;
}

} // namespace

std::vector<Order> mixed_orders(int count, double least, Random& random) {
    std::vector<Order> orders;
    const auto smallest = std::min(std::lower_bound(std::begin(sizes), std::end(sizes), least), std::end(sizes) - 1);
    const auto choices = static_cast<int>(std::end(sizes) - smallest);
    for (int k = 0; k < count; ++k) {
        Order order{.kind = "null", .effects = {}, .wanted = smallest[random.below(choices)]};
        order.bench = drawn[random.below(std::size(drawn))];
        order.more = random.chance(0.5);
        const std::vector<std::string> listed = ids(true, order.bench), unlisted = ids(false, order.bench);
        const auto one_of = [&](const std::vector<std::string>& all) {
            return all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
        };
        const double draw = random.uniform();
        if (draw < 0.1) {
            order.kind = "distractor";
        } else if (draw >= 0.25 && draw < 0.7) {
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

/// What is measured in the records from the `first` on, and the answer.
void measure(Case& made, std::size_t first, Random& random) {
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
    const bool distracts = order.kind == "distractor";
    const double late = distracts ? 3 : 1; // times as late as usual, yet no more than clamped
    const double spread = made.setup.bench == Bench::spin ? 0.4 : 1;
    for (double& offset : truth.offsets)
        offset = spread * std::clamp(0.004 * late * random.normal(), -0.012, 0.012);
    for (double& speed : truth.speeds)
        speed = std::clamp(0.02 * random.normal(), -0.06, 0.06);
    for (std::string& csv : records_of(made.setup, first, readings_of(made.setup, truth), made.dirt, random)) {
        made.files.push_back(fmt::format("{}-{}.csv", record_word(order.bench), made.files.size() + 1));
        made.csv.push_back(std::move(csv));
    }
    made.measurement = measurement_of(made.setup, made.files, baseline(order.bench));
    made.answer = {{"kind", order.kind},      {"bench", word_of(order.bench)}, {"more", order.more},
                   {"hidden", hidden},        {"wanted", order.wanted},        {"d", size.detectable},
                   {"d_sep", size.separable}, {"nearest", size.nearest}};
}

void forget_trials(Truth& truth, std::size_t trials) {
    truth.offsets.assign(trials, 0);
    truth.speeds.assign(trials, 0);
}

} // namespace

Case make_case(const Order& order, Random& random) {
    Case made;
    made.order = order;
    made.setup = draw_setup(order.bench, order.more, random);
    made.dirt = draw_dirt(random);
    if (order.kind == "distractor")
        made.dirt = distracting;
    made.setup.memory = made.dirt.memory;
    made.without = baseline(order.bench);
    const double off = random.uniform(-1, 1); // of restitution or friction, from what the scene has
    made.without.ball.restitution += 0.03 * off;
    made.without.lane.friction += 0.02 * off;
    made.without.lane.fast_friction = made.without.lane.friction;
    forget_trials(made.without, made.setup.trials.size());
    for (const std::string& id : order.effects) {
        const Effect& effect = *find_effect(id);
        const double sign = effect.one_sided || random.chance(0.5) ? 1 : -1;
        if (id == "restitution-scatters")
            made.without.ball.throws = random.bits() % 1000000;
        made.amplitudes.push_back(effect.whole ? 1
                                               : amplitude_for(made.setup, made.without, effect, order.wanted, sign));
        made.possible = made.possible && made.amplitudes.back() != 0;
    }
    measure(made, 0, random);
    return made;
}

Case followed(const Case& plain, const std::string& experiment, Random& random) {
    Case made = plain;
    made.order.kind = "loop";
    std::size_t first = plain.setup.trials.size();
    if (experiment == "clock") {
        made.setup.clock = true;
        made.files.clear();
        made.csv.clear();
        first = 0;
    } else {
        for (Trial trial : plain.setup.trials) {
            trial.mass *= experiment == "light" ? 1.0 / 8 : 1;
            trial.lasts *= experiment == "longer" ? 2 : 1;
            made.setup.trials.push_back(trial);
        }
    }
    forget_trials(made.without, made.setup.trials.size());
    measure(made, first, random);
    return made;
}

} // namespace blind

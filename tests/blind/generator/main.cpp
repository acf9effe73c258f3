// blindgen OUT COUNT SEED [LEAST | BENCH KIND EFFECT SIZE]: writes cases OUT/case-0000 ... with measured data, of the
// mix (with sizes from LEAST on) or all alike, and a commitment to each answer; of a plain one with a listed effect
// four more, CASE-EXPERIMENT, each with one experiment that a diagnosis may ask for; prints the answers with their
// salts, one JSON object a line, for whoever judges. Nothing else is written. Orders that no amplitude can fill are
// told on the standard error.
#include "case.h"
#include "seal.h"
#include "told.h"

#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using namespace blind;

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string leave(const Case& made, const fs::path& folder, Random& salts) {
    fs::create_directories(folder);
    write(folder / "measurement.toml", made.measurement);
    for (std::size_t k = 0; k < made.files.size(); ++k)
        write(folder / made.files[k], made.csv[k]);
    const std::string salt = fmt::format("{:016x}{:016x}", salts.bits(), salts.bits());
    const std::string answer = made.answer.dump();
    write(folder / "commitment.txt", sha256(salt + answer) + "\n");
    return nlohmann::ordered_json{{"case", folder.filename().string()},
                                  {"scene", scene_of_bench(made.setup.bench)},
                                  {"salt", salt},
                                  {"answer", answer}}
        .dump();
}

} // namespace

int main(int count, char** words) {
    if (count != 4 && count != 5 && count != 8) {
        std::cerr << "blindgen OUT COUNT SEED [LEAST | drop|lane|slope|roll|oblique|spin|plate "
                     "null|distractor|listed|two|unlisted "
                     "EFFECT[+EFFECT] SIZE]\n";
        return 2;
    }
    const fs::path out = words[1];
    const int cases = std::stoi(words[2]);
    const unsigned long long seed = std::stoull(words[3]);
    Random random(seed), loops(seed + 1),
        salts((static_cast<unsigned long long>(std::random_device{}()) << 32) ^ std::random_device{}());
    std::vector<Order> orders = mixed_orders(cases, count == 5 ? std::stod(words[4]) : 0, random);
    if (count == 8)
        for (Order& order : orders) {
            order.bench = bench_of(words[4]);
            order.kind = words[5];
            order.effects.clear();
            std::istringstream effects(words[6]);
            for (std::string id; order.kind != "null" && order.kind != "distractor" && std::getline(effects, id, '+');)
                order.effects.push_back(id);
            order.wanted = std::stod(words[7]);
        }
    std::vector<std::string> answers;
    int number = 0;
    for (const Order& order : orders) {
        const Case made = make_case(order, random);
        if (!made.possible) {
            std::cerr << fmt::format("no amplitude gives {} on {} a size of {}\n", fmt::join(order.effects, "+"),
                                     word_of(order.bench), order.wanted);
            continue;
        }
        const std::string name = fmt::format("case-{:04}", number++);
        answers.push_back(leave(made, out / name, salts));
        for (const char* experiment : experiments)
            if (order.kind == "listed" && !order.more)
                answers.push_back(leave(followed(made, experiment, loops), out / (name + "-" + experiment), salts));
    }
    for (const std::string& answer : answers)
        std::cout << answer << '\n';
    return 0;
}

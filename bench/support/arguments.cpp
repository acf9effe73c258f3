#include "support/arguments.h"

#include "base/text.h"

#include <cstdlib>
#include <fmt/format.h>

namespace tumble::bench {

Arguments::Arguments(int count, char** words) {
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto equals = word.find('=');
        if (equals == std::string::npos)
            refuse(fmt::format("'{}' is not name=value", word));
        given_[word.substr(0, equals)] = word.substr(equals + 1);
    }
}

std::string Arguments::text(const std::string& name, const std::string& fallback) {
    read_.insert(name);
    const auto found = given_.find(name);
    return found == given_.end() ? fallback : found->second;
}

double Arguments::number(const std::string& name, double fallback) {
    const std::string written = text(name, "");
    if (written.empty())
        return fallback;
    const auto value = parse_number(written);
    if (!value)
        refuse(fmt::format("{}={} is not a number", name, written));
    return *value;
}

std::int64_t Arguments::whole(const std::string& name, std::int64_t fallback) {
    return static_cast<std::int64_t>(number(name, static_cast<double>(fallback)));
}

std::vector<std::string> Arguments::words(const std::string& name) {
    const std::string written = text(name, "");
    std::vector<std::string> pieces;
    if (!written.empty())
        for (const std::string_view piece : split(written, ','))
            pieces.emplace_back(piece);
    return pieces;
}

std::vector<double> Arguments::numbers(const std::string& name) {
    std::vector<double> values;
    for (const std::string& word : words(name)) {
        const auto value = parse_number(word);
        if (!value)
            refuse(fmt::format("{}: '{}' is not a number", name, word));
        values.push_back(*value);
    }
    return values;
}

void Arguments::finish() const {
    for (const auto& [name, value] : given_)
        if (!read_.contains(name))
            refuse(fmt::format("{}={}: there is no such argument", name, value));
}

void refuse(const std::string& what) {
    fmt::print(stderr, "{}\n", what);
    std::exit(2);
}

} // namespace tumble::bench

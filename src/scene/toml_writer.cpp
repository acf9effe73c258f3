#include "scene/toml_writer.h"

#include "base/text.h"
#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace tumble::scene {
namespace {

/// The decimal that times `si` gives exactly this value: division alone may miss by a rounding. A value that no decimal
/// gives (it never came from a file) is written as near as it can be.
double typed(double value, double si) {
    if (value == 0)
        return 0; // TOML reads "-0" as the integer 0, which has no sign
    if (si == 1)
        return value;
    const double near = value / si;
    double below = near;
    double above = near;
    for (int i = 0; i < 8; ++i) {
        if (below * si == value)
            return below;
        if (above * si == value)
            return above;
        below = std::nextafter(below, -std::numeric_limits<double>::infinity());
        above = std::nextafter(above, std::numeric_limits<double>::infinity());
    }
    return near;
}

std::string list(const double* values, std::size_t count) {
    std::string text = "[";
    for (std::size_t i = 0; i < count; ++i)
        text += (i ? ", " : "") + shortest(typed(values[i], 1));
    return text + "]";
}

} // namespace

std::string TomlWriter::quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            result += fmt::format("\\{}", c);
        else if (c == '\n')
            result += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            result += c;
    }
    return result + "\"";
}

std::string TomlWriter::name(std::string_view text) {
    const bool bare = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    return bare ? std::string(text) : quoted(text);
}

void TomlWriter::table(std::string_view path, const std::string& head) {
    table_ = find_table(path);
    if (!head.empty())
        toml_ += "\n" + head + "\n";
}

const Key& TomlWriter::key(const std::string& name) const {
    const Key* found = find_key(*table_, name, dimension_);
    if (!found)
        throw std::logic_error("no key '" + name + "' in the list for '" + table_->path + "'");
    return *found;
}

void TomlWriter::line(const std::string& name, const std::string& value) {
    (void)key(name);
    toml_ += name + " = " + value + "\n";
}

void TomlWriter::number(const std::string& name, double si) {
    line(name, shortest(typed(si, key(name).si)));
}

void TomlWriter::vector(const std::string& name, const Eigen::Vector3d& value) {
    const double si = key(name).si;
    const double all[3] = {typed(value.x(), si), typed(value.y(), si), typed(value.z(), si)};
    line(name, list(all, static_cast<std::size_t>(dimension_)));
}

void TomlWriter::span(const std::string& name, double lo, double hi) {
    const double ends[2] = {lo, hi};
    line(name, list(ends, 2));
}

void TomlWriter::integer(const std::string& name, long long value) {
    line(name, fmt::format("{}", value));
}

void TomlWriter::flag(const std::string& name, bool value) {
    line(name, value ? "true" : "false");
}

void TomlWriter::text(const std::string& name, std::string_view value) {
    line(name, quoted(value));
}

void TomlWriter::words(const std::string& name, const std::vector<std::string>& value) {
    std::string text = "[";
    for (const std::string& word : value)
        text += (text.size() > 1 ? ", " : "") + quoted(word);
    line(name, text + "]");
}

void TomlWriter::rows(const std::string& name, const std::vector<std::array<double, 4>>& value, std::size_t columns) {
    std::string text = "[\n";
    for (const auto& row : value)
        text += "    " + list(row.data(), columns) + ",\n";
    line(name, text + "]");
}

} // namespace tumble::scene

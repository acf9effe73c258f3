#pragma once

#include "base/problem.h"
#include "scene/keys.h"
#include "sheet/sheet.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Numbers that lessons and experiments take as flags.
namespace tumble::sheet {

/// A number that may be changed; becomes the flag --name.
struct Parameter {
    std::string name; // its unit stands in it
    std::string unit; // for sentences; empty: none
    double standard = 0;
    scene::Limits limits;
    std::string sentence;
    bool whole = false; // counts something
};

/// A value for every parameter, by name and in the parameter's unit.
class Values {
public:
    explicit Values(std::map<std::string, double, std::less<>> values) : values_(std::move(values)) {}
    double operator[](std::string_view name) const { return values_.find(name)->second; }
    [[nodiscard]] const std::map<std::string, double, std::less<>>& all() const { return values_; }

private:
    std::map<std::string, double, std::less<>> values_;
};

/// Pairs of (name, number) as typed.
using Typed = std::vector<std::pair<std::string, std::string>>;

/// The defaults with what was typed put in. Problems, one per pair that is wrong: `owner` ("lesson friction") has no
/// such parameter, not a number, out of its range.
Result<Values> read_values(const std::string& owner, const std::vector<Parameter>& parameters, const Typed& typed);

/// "N/m, above 0, at most 1e+06": what a parameter may be.
std::string describe(const Parameter& parameter);

/// The values in the order of the parameters: with, value, unit.
Grid grid_of(const std::vector<Parameter>& parameters, const Values& values);

} // namespace tumble::sheet

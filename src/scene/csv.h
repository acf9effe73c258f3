#pragma once

#include "base/problem.h"
#include "scene/lines.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// Walks a CSV with a head and numbers, '#' comments, collecting at most 20 problems.
class Csv {
public:
    /// `form` is what to do about any problem: a sentence that says how the file must look.
    Csv(const std::string& source, std::string form) : source_(source), form_(std::move(form)) {}

    /// Calls `row` for each line below the head. Heads are compared without blanks; one of `heads` must match.
    void read(std::string_view text, const std::vector<std::string>& heads,
              const std::function<void(const std::vector<Field>&, int line)>& row);

    /// The field as a number with |value| <= limit, or a problem at it.
    std::optional<double> number(const Field& field, int line, double limit);

    void refuse(int line, int column, std::string what) {
        problems_.push_back({source_, line, column, "", std::move(what), form_});
    }
    [[nodiscard]] const Problems& problems() const { return problems_; }

private:
    const std::string& source_;
    std::string form_;
    Problems problems_;
};

} // namespace tumble::scene

#include "observe/array_rows.h"

#include <cmath>
#include <fmt/format.h>

namespace tumble::observe {

using Eigen::Vector3d;

Array reals(const char* name, std::size_t width) {
    return {.name = name, .width = width};
}

Array whole(const char* name, std::size_t width) {
    return {.name = name, .width = width, .type = ArrayType::whole};
}

void push(Array& array, const Vector3d& vector) {
    array.reals.insert(array.reals.end(), {vector.x(), vector.y(), vector.z()});
}

Array vectors(const char* name, const std::vector<Vector3d>& values) {
    Array array = reals(name, 3);
    for (const Vector3d& value : values)
        push(array, value);
    return array;
}

Vector3d vector_at(const Array& array, std::size_t row) {
    return Vector3d(&array.reals[3 * row]);
}

std::vector<Vector3d> vectors_of(const Array& array) {
    std::vector<Vector3d> values;
    for (std::size_t row = 0; row < array.rows(); ++row)
        values.push_back(vector_at(array, row));
    return values;
}

const Array& Taker::take(const char* name, std::size_t width, bool is_whole) {
    static const Array none;
    const Result<const Array*> found = content_.find(name, width, is_whole ? ArrayType::whole : ArrayType::real);
    if (found)
        return **found;
    const Problems more = found.problems();
    problems.insert(problems.end(), more.begin(), more.end());
    return none;
}

void Taker::same_rows(const Array& a, const Array& b) {
    if (problems.empty() && a.rows() != b.rows())
        say(fmt::format("array '{}' has {} rows and '{}' has {}", a.name, a.rows(), b.name, b.rows()));
}

void Taker::sums_to(const Array& counts, const Array& parts) {
    const auto rows = static_cast<std::int64_t>(parts.rows());
    std::int64_t left = rows;
    for (const std::int64_t count : counts.integers) {
        if (count < 0 || count > left) {
            left = -1;
            break;
        }
        left -= count;
    }
    if (problems.empty() && left != 0)
        say(fmt::format("array '{}' does not add up to the {} rows of '{}'", counts.name, rows, parts.name));
}

void Taker::within(const Array& indices, std::int64_t end) {
    for (const std::int64_t index : indices.integers)
        if (index < 0 || index >= end) {
            say(fmt::format("array '{}' names {} where there are {}", indices.name, index, end));
            return;
        }
}

void Taker::finite(const Array& array) {
    for (std::size_t i = 0; i < array.reals.size(); ++i)
        if (!std::isfinite(array.reals[i])) {
            say(fmt::format("array '{}' is not finite in row {}", array.name, i / array.width));
            return;
        }
}

} // namespace tumble::observe

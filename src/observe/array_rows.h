#pragma once

#include "observe/array_file.h"

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

/// What the writers and readers of frames and layouts share: rows of vectors, and checks whose problems add up.
namespace tumble::observe {

Array reals(const char* name, std::size_t width);
Array whole(const char* name, std::size_t width);
Array vectors(const char* name, const std::vector<Eigen::Vector3d>& values);

void push(Array& array, const Eigen::Vector3d& vector);
Eigen::Vector3d vector_at(const Array& array, std::size_t row);
std::vector<Eigen::Vector3d> vectors_of(const Array& array);

/// Takes arrays out by name and remembers what was wrong.
class Taker {
public:
    explicit Taker(const ArrayFile& content) : content_(content) {}

    /// The array, or an empty one and a problem.
    const Array& take(const char* name, std::size_t width, bool is_whole);
    void same_rows(const Array& a, const Array& b);
    /// The counts are not negative and add up to the rows of `parts`.
    void sums_to(const Array& counts, const Array& parts);
    /// All are at least 0 and below `end`.
    void within(const Array& indices, std::int64_t end);
    void finite(const Array& array);
    void say(std::string what) { problems.push_back({.what = std::move(what)}); }

    Problems problems;

private:
    const ArrayFile& content_;
};

} // namespace tumble::observe

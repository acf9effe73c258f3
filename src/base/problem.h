#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tumble {

/// One thing that is wrong, where it stands, and what to do about it. Line and column count from 1; 0 means unknown.
struct Problem {
    std::string file{};
    int line = 0;
    int column = 0;
    std::string key{};
    std::string what{};
    std::string fix{};
};

using Problems = std::vector<Problem>;

/// "file:line:column: what" and, indented on the next line, what to do. Parts that are unknown are left out.
std::string to_string(const Problem& problem);

/// All problems, one after the other, each ended by a newline.
std::string to_string(const Problems& problems);

inline void append(Problems& all, const Problems& more) {
    all.insert(all.end(), more.begin(), more.end());
}

/// A value or the list of everything that kept it from being made.
template <class T> class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Problem problem) : content_(Problems{std::move(problem)}) {}
    Result(Problems problems) : content_(std::move(problems)) {}

    [[nodiscard]] bool ok() const { return content_.index() == 0; }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T& value() { return std::get<0>(content_); }
    [[nodiscard]] const T& value() const { return std::get<0>(content_); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// Empty when there is a value.
    [[nodiscard]] Problems problems() const { return ok() ? Problems{} : std::get<1>(content_); }

private:
    std::variant<T, Problems> content_;
};

/// For functions that make nothing but may fail.
struct Done {};

} // namespace tumble

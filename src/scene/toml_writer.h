#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace tumble::scene {

/// Writes keys of one table of the list under its head, each value so that reading it gives the same bits. A name that
/// the list does not hold is a mistake of the program.
class TomlWriter {
public:
    /// `dimension` of the scene, 2 or 3: how many numbers of a vector are written, and which keys there are.
    explicit TomlWriter(int dimension = 3) : dimension_(dimension) {}

    /// Begins a table: `path` finds its keys in the list, `head` is the line to write ("" at the top).
    void table(std::string_view path, const std::string& head);

    /// Values in SI, as the scene holds them.
    void number(const std::string& name, double si);
    void vector(const std::string& name, const Eigen::Vector3d& value);
    void span(const std::string& name, double lo, double hi);
    void integer(const std::string& name, long long value);
    void flag(const std::string& name, bool value);
    void text(const std::string& name, std::string_view value);
    void words(const std::string& name, const std::vector<std::string>& value);
    /// Rows, one a line, each of its first `columns` numbers.
    void rows(const std::string& name, const std::vector<std::array<double, 4>>& value, std::size_t columns = 4);

    [[nodiscard]] const std::string& result() const { return toml_; }

    /// "text" with everything escaped that TOML wants escaped.
    static std::string quoted(std::string_view text);
    /// A name as it stands in a head: bare where TOML allows, quoted elsewhere.
    static std::string name(std::string_view text);

private:
    void line(const std::string& name, const std::string& value);
    [[nodiscard]] const struct Key& key(const std::string& name) const;

    int dimension_;
    const struct KeyTable* table_ = nullptr;
    std::string toml_;
};

} // namespace tumble::scene

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The one list of what a scene may say. The reader's checks, its defaults, `tumble list keys` and
/// docs/scene_reference.md all come from it.
namespace tumble::scene {

enum class KeyType {
    text,    // any words
    file,    // a file name, relative to the scene file
    word,    // one of `words`
    words,   // a list of some of `words`; any words where that list is empty
    flag,    // true or false
    integer, // a whole number
    number,
    vector, // [x, y, z]; [x, y] in two dimensions
    span,   // [low, high]
    rows    // a list of lists of `columns` numbers; limits are those of the last
};

/// The scenes that a key belongs to. Where the two kinds of scene take something different under one name, the list has
/// the key twice, once for each.
enum class Dimensions { both, two, three };

/// What a number may be, as typed. Infinite bounds are not said.
struct Limits {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();
    bool above = false; // lo itself is refused
    bool below = false; // hi itself is refused

    [[nodiscard]] bool hold(double value) const {
        return (above ? value > lo : value >= lo) && (below ? value < hi : value <= hi);
    }
};

/// monostate: no default.
using KeyDefault = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                                std::vector<std::string>>;

struct Key {
    std::string name;
    KeyType type = KeyType::number;
    std::string unit; // as typed, SI-like notation; empty: no unit
    Limits limits;
    double si = 1; // SI value = typed value * si
    KeyDefault standard;
    bool required = false;
    std::vector<std::string> words;
    std::size_t columns = 4; // of rows
    Dimensions in = Dimensions::both;
    std::vector<std::string> only_for; // values of the table's `kind_key` that this key belongs to; empty: all
    std::string one_of;                // of the keys with the same word here exactly one must be given
    std::string sentence;
};

enum class Repeat {
    once,  // [domain]
    named, // [material.NAME]
    many   // [[fill]]
};

/// One table of a scene and its keys.
struct KeyTable {
    std::string path; // "", "domain", "material", "wall.motion"
    std::string head; // "", "[domain]", "[material.NAME]", "[[wall.motion]]"
    Repeat repeat = Repeat::once;
    bool required = false;
    std::string kind_key{}; // the key whose value says which other keys belong here; empty: none
    std::string sentence{};
    std::vector<Key> keys{};
};

const std::vector<KeyTable>& scene_keys();

/// The table with that path, or nullptr.
const KeyTable* find_table(std::string_view path);
/// The key of that name, or nullptr.
const Key* find_key(const KeyTable& table, std::string_view name);
/// Of the keys of that name the one for scenes of that dimension (2 or 3), or nullptr.
const Key* find_key(const KeyTable& table, std::string_view name, int dimension);
bool belongs_in(const Key& key, int dimension);
/// "2D", "3D", or "" for both.
const char* mark_of(Dimensions dimensions);

/// A number for a sentence: "100000" where shortest() would say "1e+05".
std::string plain(double value);

/// "number in kg/m3, above 0, at most 30000", "one of "hertz", "linear"".
std::string describe(const Key& key);
/// The same as a scene of that dimension (2 or 3) takes it.
std::string describe(const Key& key, int dimension);
/// The range alone: "above 0, at most 30000"; empty when anything goes.
std::string describe(const Limits& limits);
/// The default as TOML; empty when there is none.
std::string describe(const KeyDefault& standard);

} // namespace tumble::scene

#pragma once

#include "scene/keys.h"

#include <utility>

/// Short words for writing the list of keys; used by keys_*.cpp only.
namespace tumble::scene {

inline Limits above(double lo) {
    return {.lo = lo, .above = true};
}
inline Limits above(double lo, double hi) {
    return {.lo = lo, .hi = hi, .above = true};
}
inline Limits from(double lo) {
    return {.lo = lo};
}
inline Limits from(double lo, double hi) {
    return {.lo = lo, .hi = hi};
}

class KeyMaker {
public:
    KeyMaker(std::string name, KeyType type, std::string unit, Limits limits, std::string sentence) {
        key_.name = std::move(name);
        key_.type = type;
        key_.unit = std::move(unit);
        key_.limits = limits;
        key_.sentence = std::move(sentence);
    }
    operator Key() const { return key_; }

    KeyMaker must() const {
        return with([](Key& k) { k.required = true; });
    }
    KeyMaker otherwise(KeyDefault value) const {
        return with([&](Key& k) { k.standard = std::move(value); });
    }
    KeyMaker si(double factor) const {
        return with([&](Key& k) { k.si = factor; });
    }
    KeyMaker only_for(std::vector<std::string> kinds) const {
        return with([&](Key& k) { k.only_for = std::move(kinds); });
    }
    KeyMaker one_of(std::string group) const {
        return with([&](Key& k) { k.one_of = std::move(group); });
    }
    KeyMaker words(std::vector<std::string> allowed) const {
        return with([&](Key& k) { k.words = std::move(allowed); });
    }

    KeyMaker columns(std::size_t count) const {
        return with([&](Key& k) { k.columns = count; });
    }
    KeyMaker in_2d() const {
        return with([](Key& k) { k.in = Dimensions::two; });
    }
    KeyMaker in_3d() const {
        return with([](Key& k) { k.in = Dimensions::three; });
    }

private:
    template <class Change> KeyMaker with(Change change) const {
        KeyMaker copy = *this;
        change(copy.key_);
        return copy;
    }
    Key key_;
};

inline KeyMaker text(std::string name, std::string sentence) {
    return {std::move(name), KeyType::text, "", {}, std::move(sentence)};
}
inline KeyMaker file(std::string name, std::string sentence) {
    return {std::move(name), KeyType::file, "", {}, std::move(sentence)};
}
inline KeyMaker word(std::string name, std::vector<std::string> words, std::string sentence) {
    return KeyMaker(std::move(name), KeyType::word, "", {}, std::move(sentence)).words(std::move(words));
}
inline KeyMaker words(std::string name, std::vector<std::string> allowed, std::string sentence) {
    return KeyMaker(std::move(name), KeyType::words, "", {}, std::move(sentence)).words(std::move(allowed));
}
inline KeyMaker flag(std::string name, std::string sentence) {
    return KeyMaker(std::move(name), KeyType::flag, "", {}, std::move(sentence)).otherwise(false);
}
inline KeyMaker integer(std::string name, Limits limits, std::string sentence) {
    return {std::move(name), KeyType::integer, "", limits, std::move(sentence)};
}
inline KeyMaker number(std::string name, std::string unit, Limits limits, std::string sentence) {
    return {std::move(name), KeyType::number, std::move(unit), limits, std::move(sentence)};
}
inline KeyMaker vector(std::string name, std::string unit, Limits limits, std::string sentence) {
    return {std::move(name), KeyType::vector, std::move(unit), limits, std::move(sentence)};
}
inline KeyMaker rows(std::string name, std::string unit, std::size_t columns, Limits limits, std::string sentence) {
    return KeyMaker(std::move(name), KeyType::rows, std::move(unit), limits, std::move(sentence)).columns(columns);
}

/// The parts of the list, one file each.
std::vector<KeyTable> world_tables();
std::vector<KeyTable> matter_tables();
std::vector<KeyTable> wall_tables();
std::vector<KeyTable> output_tables();
std::vector<KeyTable> reduce_tables();

} // namespace tumble::scene

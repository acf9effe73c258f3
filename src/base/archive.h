#pragma once

#include "base/carried.h"
#include "base/hash.h"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// Values as bytes and back, bit by bit. A struct says once what it is made of, for both ways:
///
///     template <class Archive, As<Ledger> L> void carry(Archive& archive, L& ledger) {
///         auto& [lost, inserted] = ledger;
///         archive(lost, inserted);
///     }
///
/// The names in brackets must be as many as the struct has members: a struct that grows does not compile until somebody
/// has decided whether the new member is carried. carry() stands in the struct's namespace.
namespace tumble {

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they lie in memory, little end first");

/// The first `size` elements of a vector or array; the size is not written, the reader knows it by then.
template <class Values> struct Part {
    Values& values;
    std::size_t size;
};
template <class Values> Part(Values&, std::size_t) -> Part<Values>;

/// A vector whose size the reader knows and most of whose elements are nothing but zero bits: only the others take
/// room. Elements without padding.
template <class Values> struct Sparse {
    Values& values;
    std::size_t size;
};
template <class Values> Sparse(Values&, std::size_t) -> Sparse<Values>;

/// Carries a vector that is either empty or parallel to `size` others.
template <class Archive, class Values> void carry_if_any(Archive& archive, Values& values, std::size_t size) {
    bool any = !values.empty();
    archive(any);
    archive(Sparse{values, any ? size : 0});
}

/// A vector whose elements stand there before they are read, as many as were written.
template <class Values> struct Standing { Values& values; };
template <class Values> Standing(Values&) -> Standing<Values>;

namespace archive_kinds {
template <class T>
concept Number = std::is_arithmetic_v<T>;
template <class T>
concept Matrix = requires(T& m) {
    typename T::Scalar;
    m.data();
    T::SizeAtCompileTime;
};
template <class T> inline constexpr bool is_array = std::is_array_v<T>;
template <class T, std::size_t n> inline constexpr bool is_array<std::array<T, n>> = true;
template <class T> inline constexpr bool is_vector = false;
template <class T, class A> inline constexpr bool is_vector<std::vector<T, A>> = true;
template <class T> inline constexpr bool is_part = false;
template <class T> inline constexpr bool is_part<Part<T>> = true;
template <class T> inline constexpr bool is_sparse = false;
template <class T> inline constexpr bool is_sparse<Sparse<T>> = true;
template <class T> inline constexpr bool is_standing = false;
template <class T> inline constexpr bool is_standing<Standing<T>> = true;
template <class Values> using ElementOf = std::remove_cvref_t<decltype(*std::begin(std::declval<Values&>()))>;
} // namespace archive_kinds

/// Takes apart what it is given; Self says what becomes of the parts.
template <class Self> class Archive {
public:
    template <class... Ts> void operator()(Ts&&... values) { (one(values), ...); }

protected:
    template <class T> void one(T& value) {
        using namespace archive_kinds;
        using Plain = std::remove_const_t<T>;
        if constexpr (Number<Plain>)
            self().number(value);
        else if constexpr (Matrix<Plain>) {
            static_assert(Plain::SizeAtCompileTime > 0, "only matrices of fixed size");
            for (std::ptrdiff_t k = 0; k < Plain::SizeAtCompileTime; ++k)
                self().number(value.data()[k]);
        } else if constexpr (is_array<Plain>)
            for (auto& element : value)
                one(element);
        else if constexpr (std::same_as<Plain, std::string>)
            self().text(value);
        else if constexpr (std::same_as<Plain, std::filesystem::path>)
            self().path(value);
        else if constexpr (is_vector<Plain>)
            self().vector(value);
        else if constexpr (is_part<Plain>)
            self().part(value.values, value.size);
        else if constexpr (is_sparse<Plain>)
            self().sparse(value.values, value.size);
        else if constexpr (is_standing<Plain>)
            self().standing(value.values);
        else
            carry(self(), value);
    }

private:
    Self& self() { return static_cast<Self&>(*this); }
};

/// Counts the bytes that values take.
class ArchiveSize : public Archive<ArchiveSize> {
public:
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    friend Archive<ArchiveSize>;
    template <class T> void number(T&) { bytes_ += sizeof(T); }
    void text(const std::string& text) { bytes_ += sizeof(std::uint64_t) + text.size(); }
    void path(const std::filesystem::path& path) { text(path.string()); }
    template <class Values> void vector(Values& values) {
        bytes_ += sizeof(std::uint64_t);
        part(values, values.size());
    }
    template <class Values> void part(Values& values, std::size_t size) {
        for (std::size_t k = 0; k < size; ++k)
            one(values[k]);
    }
    template <class Values> void sparse(Values&, std::size_t) { bytes_ += sizeof(std::uint64_t); }
    template <class Values> void standing(Values& values) { vector(values); }

    std::size_t bytes_ = 0;
};

/// Bytes of a T as its constructor leaves it, which no T undercuts.
template <class T> std::size_t least_bytes() {
    static const std::size_t least = [] {
        T value{};
        ArchiveSize size;
        size(value);
        return size.bytes();
    }();
    return least;
}

/// Whether a T's bytes in an archive are those in memory, so that many can be copied at once.
template <class T> bool archived_as_it_lies() {
    if constexpr (std::same_as<T, bool> || !std::is_trivially_copyable_v<T>)
        return false;
    else
        return least_bytes<T>() == sizeof(T);
}

class ArchiveWriter : public Archive<ArchiveWriter> {
public:
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    std::string take() { return std::move(bytes_); }

private:
    friend Archive<ArchiveWriter>;
    void add(const void* from, std::size_t count) { bytes_.append(static_cast<const char*>(from), count); }
    template <class T> void number(const T& value) { add(&value, sizeof value); }
    void size(std::size_t count) { number(std::uint64_t{count}); }
    void text(const std::string& text) {
        size(text.size());
        bytes_ += text;
    }
    void path(const std::filesystem::path& path) { text(path.string()); }
    template <class Values> void vector(const Values& values) {
        size(values.size());
        part(values, values.size());
    }
    template <class Values> void part(const Values& values, std::size_t count) {
        using Element = archive_kinds::ElementOf<const Values>;
        if (archived_as_it_lies<Element>())
            add(values.data(), count * sizeof(Element));
        else
            for (std::size_t k = 0; k < count; ++k)
                one(values[k]);
    }
    template <class Values> void sparse(const Values& values, std::size_t count) {
        using Element = archive_kinds::ElementOf<const Values>;
        static const char zeros[sizeof(Element)] = {};
        const auto is_zero = [&](std::size_t k) { return std::memcmp(&values[k], zeros, sizeof zeros) == 0; };
        std::uint64_t others = 0;
        for (std::size_t k = 0; k < count; ++k)
            others += is_zero(k) ? 0 : 1;
        number(others);
        for (std::size_t k = 0; k < count; ++k)
            if (!is_zero(k)) {
                number(std::uint64_t{k});
                one(values[k]);
            }
    }
    template <class Values> void standing(const Values& values) { vector(values); }

    std::string bytes_;
};

/// After bytes that are too few, or sizes that the bytes cannot fill, everything reads as zero and empty.
class ArchiveReader : public Archive<ArchiveReader> {
public:
    explicit ArchiveReader(std::string_view bytes) : left_(bytes) {}

    /// All read so far made sense and nothing is left over.
    [[nodiscard]] bool whole() const { return !broken_ && left_.empty(); }

private:
    friend Archive<ArchiveReader>;
    bool has(std::size_t count, std::size_t each) {
        broken_ = broken_ || count > left_.size() / (each > 0 ? each : 1);
        return !broken_;
    }
    void get(void* to, std::size_t count) {
        std::memcpy(to, left_.data(), count);
        left_.remove_prefix(count);
    }
    template <class T> void number(T& value) {
        if (!has(1, sizeof value)) {
            value = {};
        } else if constexpr (std::same_as<T, bool>) {
            char byte = 0;
            get(&byte, 1);
            value = byte != 0;
        } else {
            get(&value, sizeof value);
        }
    }
    std::size_t size() {
        std::uint64_t count = 0;
        number(count);
        return count;
    }
    void text(std::string& text) {
        const std::size_t count = size();
        text.clear();
        if (has(count, 1)) {
            text.assign(left_.data(), count);
            left_.remove_prefix(count);
        }
    }
    void path(std::filesystem::path& path) {
        std::string name;
        text(name);
        path = name;
    }
    template <class Values> void vector(Values& values) { part(values, size()); }
    template <class Values> void part(Values& values, std::size_t count) {
        using Element = archive_kinds::ElementOf<Values>;
        const bool fits = has(count, least_bytes<Element>());
        if constexpr (archive_kinds::is_vector<Values>) {
            values.clear();
            values.resize(fits ? count : 0);
        }
        broken_ = broken_ || count > values.size();
        if (broken_)
            return;
        if (archived_as_it_lies<Element>() && count > 0)
            get(values.data(), count * sizeof(Element));
        else
            for (std::size_t k = 0; k < count; ++k)
                one(values[k]);
    }
    template <class Values> void sparse(Values& values, std::size_t count) {
        values.clear();
        const std::size_t others = size();
        broken_ = broken_ || others > count;
        if (broken_)
            return;
        values.resize(count);
        for (std::size_t k = 0; k < others && !broken_; ++k) {
            const std::size_t at = size();
            broken_ = broken_ || at >= count;
            if (!broken_)
                one(values[at]);
        }
    }
    template <class Values> void standing(Values& values) {
        broken_ = broken_ || size() != values.size();
        for (auto& element : values)
            one(element);
    }

    std::string_view left_;
    bool broken_ = false;
};

/// What kinds of numbers follow each other, whatever their values: bytes can be read by a program whose layout is that
/// of the program that wrote them.
class ArchiveLayout : public Archive<ArchiveLayout> {
public:
    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

private:
    friend Archive<ArchiveLayout>;
    template <class T> void number(T&) {
        hash_.add(std::string_view(std::is_floating_point_v<T> ? "f" : std::is_signed_v<T> ? "i" : "u"));
        hash_.add(sizeof(T));
    }
    void text(const std::string&) { hash_.add(std::string_view("text")); }
    void path(const std::filesystem::path&) { hash_.add(std::string_view("path")); }
    template <class Values> void vector(Values& values) { some_of("vector", values); }
    template <class Values> void part(Values& values, std::size_t) { some_of("part", values); }
    template <class Values> void sparse(Values& values, std::size_t) { some_of("sparse", values); }
    template <class Values> void standing(Values& values) { some_of("standing", values); }
    template <class Values> void some_of(std::string_view kind, Values&) {
        hash_.add(kind);
        archive_kinds::ElementOf<Values> element{};
        one(element);
        hash_.add(std::string_view("end"));
    }

    Hash64 hash_;
};

template <class T> std::uint64_t archive_layout_of(T& value) {
    ArchiveLayout layout;
    layout(value);
    return layout.value();
}

} // namespace tumble

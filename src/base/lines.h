#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace tumble {

/// Array of 64-byte aligned lines.
template <class T> struct LineAllocator {
    using value_type = T;
    LineAllocator() = default;
    template <class U> LineAllocator(const LineAllocator<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
    void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
    friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};
template <class T> using Lines = std::vector<T, LineAllocator<T>>;

} // namespace tumble

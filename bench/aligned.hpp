#pragma once
/// Arrays that begin at a register's boundary, for plain double as for intervals: else every access
/// touches two cache lines.
#include <cstddef>
#include <new>
#include <vector>

namespace graze::bench {

template <class T> struct aligned {
  using value_type = T;
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t{64}));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t{64}); }
  bool operator==(const aligned&) const { return true; }
};
template <class T> using aligned_vector = std::vector<T, aligned<T>>;

} // namespace graze::bench

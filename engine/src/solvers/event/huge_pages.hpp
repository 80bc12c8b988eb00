#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace carom::event {

/// An allocator that asks for large memory pages where a block is large: a run that jumps about in
/// it then finds its addresses in the translation cache.
template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t{1} << 21;

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}  // NOLINT(google-explicit-constructor)

  static std::align_val_t alignment(std::size_t n) {
    return std::align_val_t{n * sizeof(T) >= kPage ? kPage : std::max<std::size_t>(alignof(T), 64)};
  }
  T* allocate(std::size_t n) {
    void* const block = ::operator new(n * sizeof(T), alignment(n));
    if (n * sizeof(T) >= kPage) madvise(block, n * sizeof(T), MADV_HUGEPAGE);  // only advice
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t n) { ::operator delete(block, alignment(n)); }
  template <class U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }
};

template <class T>
using HugeVector = std::vector<T, HugePages<T>>;

}  // namespace carom::event

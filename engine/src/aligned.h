#pragma once

#include <cstddef>
#include <new>
#include <vector>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace hooke {

/// One cache line: arrays that kernels read start on it.
inline constexpr std::size_t cache_line = 64;

/// What processors and systems call a huge page, nearly everywhere.
inline constexpr std::size_t huge_page = 2 * 1024 * 1024;

/// Asks the system to back memory with huge pages: a step walks through a dozen arrays at once, more than the
/// processor remembers small pages for. It may decline.
inline void advise_huge_pages([[maybe_unused]] void* pointer, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(pointer, bytes, MADV_HUGEPAGE);
#endif
}

/// Allocates on cache lines, and what is large on huge pages.
template <class T>
struct AlignedAllocator {
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const pointer = ::operator new(bytes, alignment(bytes));
    if (bytes >= huge_page) advise_huge_pages(pointer, bytes);
    return static_cast<T*>(pointer);
  }
  void deallocate(T* pointer, std::size_t count) { ::operator delete(pointer, alignment(count * sizeof(T))); }

  bool operator==(const AlignedAllocator&) const { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= huge_page ? huge_page : cache_line};
  }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace hooke

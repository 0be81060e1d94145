#include "allocation/counted_memory.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count{0}, held{0};

/// Lies right in front of what is handed out.
struct Label {
  std::size_t bytes;   ///< that were asked for
  std::size_t before;  ///< from the start of the memory to what is handed out
};

void* counted(std::size_t bytes, std::size_t alignment) {
  const std::size_t before = std::max(alignment, sizeof(Label));
  // aligned_alloc wants a multiple of the alignment.
  const std::size_t whole = (before + bytes + alignment - 1) / alignment * alignment;
  auto* const start = static_cast<std::byte*>(std::aligned_alloc(alignment, whole));
  if (start == nullptr) throw std::bad_alloc();
  ++count;
  held += bytes;
  *reinterpret_cast<Label*>(start + before - sizeof(Label)) = {bytes, before};
  return start + before;
}

void release(void* pointer) {
  if (pointer == nullptr) return;
  auto* const handed_out = static_cast<std::byte*>(pointer);
  const Label label = *reinterpret_cast<const Label*>(handed_out - sizeof(Label));
  held -= label.bytes;
  std::free(handed_out - label.before);
}

}  // namespace

namespace hooke::test {

std::size_t allocations() {
  return count;
}

std::size_t held_bytes() {
  return held;
}

}  // namespace hooke::test

void* operator new(std::size_t bytes) {
  return counted(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, std::size_t(alignment));
}
void operator delete(void* pointer) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::align_val_t) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::size_t, std::align_val_t) noexcept {
  release(pointer);
}

#include "benchmarks/simulation/memory.hpp"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

bool counting = false;
std::int64_t bytes_held = 0;

/// Before each block; as large as keeps the block aligned.
struct alignas(std::max_align_t) BlockHead {
  std::size_t bytes;
  bool counted;
};

}  // namespace

void* operator new(std::size_t bytes) {
  auto* const head = static_cast<BlockHead*>(std::malloc(sizeof(BlockHead) + bytes));
  if (head == nullptr) throw std::bad_alloc();
  *head = {.bytes = bytes, .counted = counting};
  if (counting) bytes_held += static_cast<std::int64_t>(bytes);
  return head + 1;
}

void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  auto* const head = static_cast<BlockHead*>(block) - 1;
  if (head->counted) bytes_held -= static_cast<std::int64_t>(head->bytes);
  std::free(head);
}

void operator delete(void* block, std::size_t) noexcept {
  operator delete(block);
}

namespace lamprey::benchmarks {

CountedAllocations::CountedAllocations() {
  counting = true;
}

CountedAllocations::~CountedAllocations() {
  counting = false;
}

std::int64_t counted_bytes() {
  return bytes_held;
}

}  // namespace lamprey::benchmarks

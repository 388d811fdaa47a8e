#pragma once

#include <cstdint>

/// Whose memory it is: a program that links this has an operator new by which each block remembers who has made it.
/// What libraries get by malloc (SQLite) is not counted. One thread.
namespace lamprey::benchmarks {

/// What is allocated while one of these lives is counted until it is freed, whoever frees it.
class CountedAllocations {
 public:
  CountedAllocations();
  ~CountedAllocations();
  CountedAllocations(const CountedAllocations&) = delete;
  CountedAllocations& operator=(const CountedAllocations&) = delete;
};

/// Octets that are counted and have not been freed.
std::int64_t counted_bytes();

}  // namespace lamprey::benchmarks

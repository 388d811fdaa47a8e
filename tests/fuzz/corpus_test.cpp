#include "tests/fuzz/fuzzing.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <utility>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// The fuzzer's body ends the program if a file breaks what must hold for all of them.
TEST(Corpus, IsRefusedOrReadWithoutHarm) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(LAMPREY_CORPUS)) files.push_back(entry.path());
  std::ranges::sort(files);
  EXPECT_GT(files.size(), 10U);
  for (const auto& path : files) {
    SCOPED_TRACE(path);
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> octets{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(octets.data()), octets.size()), 0);
    EXPECT_EQ(std::exchange(lamprey::fuzzing::planted_bug_reached, 0), 0) << "nothing is left to find: remove it";
  }
}

}  // namespace

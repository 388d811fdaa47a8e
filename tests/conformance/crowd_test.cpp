#include "messaging/qos.hpp"
#include "tests/conformance/numbered.hpp"
#include "tests/conformance/other_program.hpp"
#include "tests/conformance/world.hpp"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Many programs on one host without multicast.
namespace lamprey::messaging::conformance {
namespace {

using ::testing::ElementsAre;

/// What they say to find each other grows with the square of their number: 64 at full size only.
std::uint64_t members() {
  const char* const size = std::getenv("LAMPREY_TEST_SIZE");
  return size != nullptr && std::string_view(size) == "full" ? 64 : 24;
}

class Crowd : public World {};

TEST_P(Crowd, OfProgramsMeetsWholeAndEachAnswersWhatIsMeantForIt) {
  const auto count = members();
  auto coordinator = join_writer();
  Inbox<ResultAcknowledgement> answers(*coordinator);
  std::vector<std::unique_ptr<Writer<Lease>>> writers;
  std::vector<std::unique_ptr<OtherProgram>> programs;
  std::vector<std::uint64_t> expected;
  for (std::uint64_t i = 1; i <= count; ++i) {
    writers.push_back(coordinator->writer<Lease>(Partition::of(i)));
    write(*writers.back(), numbered<Lease>(1000 + i));
    // From both sides of a pair in turn, so that in a mixed one each vendor has many of either to talk to.
    const auto vendor = i % 2 == 0 ? GetParam().writer : GetParam().reader;
    programs.push_back(std::make_unique<OtherProgram>(
        options(vendor, ""),
        std::vector<std::string>{"lease", std::to_string(i), "join-crowd", std::to_string(count)}));
    expected.push_back(1000 + i);
  }
  // Each answers once it knows of all others.
  EXPECT_TRUE(answers.take_until_size(count));
  EXPECT_THAT(numbers_of(answers.samples), ::testing::UnorderedElementsAreArray(expected));
  for (std::uint64_t i = 1; i <= count; ++i) {
    auto& program = *programs[i - 1];
    EXPECT_TRUE(program.listen_until([](const auto& said) { return !said.empty(); }));
    EXPECT_THAT(program.said, ElementsAre(1000 + i)) << "program " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Port, Crowd, ::testing::ValuesIn(network_pairs()), pair_name);

}  // namespace
}  // namespace lamprey::messaging::conformance

#include "experiment/job.hpp"

#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <set>
#include <string_view>

namespace lamprey::experiment {
namespace {

Job example() {
  return job_with(
      {{"mutation", text("one")}, {"steps", text("normal")}, {"acceptance", text("annealing")}, {"temperature", 2.5}});
}

TEST(Identity, IsTheWorkedExampleOfTheFormatsPage) {
  const std::string_view hashed =
      "lamprey-job/1\n"
      "science=1\n"
      "seed=2006\n"
      "replicate=0\n"
      "acceptance=annealing\n"
      "mutation=one\n"
      "steps=normal\n"
      "temperature=2.5\n";
  EXPECT_EQ(identity(example()), sha256(hashed));
  EXPECT_EQ(to_hex(identity(example())), "7a6f3e981d3651556fcf0e3700a717d716d5cdef972e58529f8b5a3933a4d636");
}

TEST(StreamKey, IsTheWorkedExampleOfTheFormatsPageWithoutTheScienceVersion) {
  const std::string_view hashed =
      "lamprey-stream/1\n"
      "seed=2006\n"
      "replicate=0\n"
      "acceptance=annealing\n"
      "mutation=one\n"
      "steps=normal\n"
      "temperature=2.5\n";
  EXPECT_EQ(stream_key(example()), leading_128_bits(sha256(hashed)).high);
  EXPECT_EQ(stream_key(example()), 0x4abadb0d7c32ee8fU);
}

TEST(Identity, OfADefaultJobHasNoParameters) {
  EXPECT_EQ(identity(job_with({}, 7, 3)), sha256(std::string_view("lamprey-job/1\nscience=1\nseed=7\nreplicate=3\n")));
}

TEST(Identity, ChangesWithSeedReplicateAndParametersAndNotWithTheNumber) {
  const Job job = example();
  std::set<Digest> identities{identity(job)};
  std::set<std::uint64_t> keys{stream_key(job)};
  const auto expect_other = [&](const Job& other) {
    EXPECT_TRUE(identities.insert(identity(other)).second);
    EXPECT_TRUE(keys.insert(stream_key(other)).second);
  };
  Job other = job;
  other.seed = 2007;
  expect_other(other);
  other = job;
  other.replicate = 1;
  expect_other(other);
  other = job;
  other.parameters.set("cycles", whole(999));
  expect_other(other);
  other = job;
  other.number = 41;
  EXPECT_EQ(identity(other), identity(job));
  EXPECT_EQ(stream_key(other), stream_key(job));
}

TEST(Identity, LargestSeedAndReplicateAreWrittenInFull) {
  EXPECT_EQ(identity(job_with({}, 18446744073709551615U, 4294967295U)),
            sha256(std::string_view("lamprey-job/1\nscience=1\nseed=18446744073709551615\nreplicate=4294967295\n")));
}

}  // namespace
}  // namespace lamprey::experiment

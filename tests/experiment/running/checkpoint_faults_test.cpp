#include "experiment/checkpoint.hpp"
#include "idl/checkpoint.pb.h"
#include "tests/experiment/running/jobs.hpp"

#include <boost/crc.hpp>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace lamprey::experiment {
namespace {

using Octets = std::vector<std::uint8_t>;

Job small_job() {
  return job_with({{"acceptance", text("annealing")},
                   {"temperature", 1000.0},
                   {"posture", text("carry")},
                   {"record", text("details")},
                   {"cycles", whole(40)}});
}

Octets small_checkpoint() {
  const Job job = small_job();
  JobRun run(job);
  while (run.outcome().cycles < 15) run.advance();
  EXPECT_GE(run.outcome().trace.size(), 2U);
  return write_checkpoint(run, job, 0.25);
}

std::string reason_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const CheckpointError& error) {
    return error.what();
  }
  return {};
}

std::string refusal(const Octets& octets, const Job& job = small_job()) {
  return reason_of([&] { resume(job, octets); });
}

/// With a CRC that agrees.
Octets sealed(const idl::Checkpoint& message) {
  const std::string body = message.SerializeAsString();
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(body.data(), body.size());
  Octets octets(body.begin(), body.end());
  for (int i = 0; i < 4; ++i) octets.push_back(static_cast<std::uint8_t>(crc.checksum() >> (8 * i)));
  return octets;
}

idl::Checkpoint opened(const Octets& octets) {
  idl::Checkpoint message;
  EXPECT_TRUE(message.ParseFromArray(octets.data(), static_cast<int>(octets.size()) - 4));
  return message;
}

/// The small checkpoint with one thing changed, and the CRC to go with it.
Octets changed(const std::function<void(idl::Checkpoint&)>& change) {
  idl::Checkpoint message = opened(small_checkpoint());
  change(message);
  return sealed(message);
}

TEST(CheckpointFaults, TheUnchangedOneIsAccepted) {
  EXPECT_EQ(changed([](auto&) {}), small_checkpoint());
  EXPECT_EQ(refusal(small_checkpoint()), "");
}

TEST(CheckpointFaults, AFlippedBitOfAnyOctetIsRefused) {
  const Octets good = small_checkpoint();
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xFF}) {
      Octets bad = good;
      bad[at] = static_cast<std::uint8_t>(bad[at] ^ flip);
      EXPECT_EQ(refusal(bad), "its CRC does not agree: it is damaged or cut") << at;
      EXPECT_THROW(read_checkpoint_head(bad), CheckpointError);
      EXPECT_THROW(read_checkpoint_trace(bad), CheckpointError);
    }
  }
}

TEST(CheckpointFaults, EveryCutAndAnyAdditionIsRefused) {
  const Octets good = small_checkpoint();
  for (std::size_t length = 0; length < good.size(); ++length) {
    const Octets bad(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_NE(refusal(bad), "") << length;
    EXPECT_THROW(read_checkpoint_head(bad), CheckpointError);
  }
  Octets longer = good;
  longer.push_back(0);
  EXPECT_NE(refusal(longer), "");
}

TEST(CheckpointFaults, AFlippedOctetOfTheStateIsRefusedOrLeadsToSomeOutcomeEvenIfTheCrcAgrees) {
  // Whoever can write a CRC may give a false state, but must not end the program.
  for (const char* trainer : {"rtea", "genetic_algorithm", "evolution_strategy"}) {
    const Job job = job_with({{"trainer", text(trainer)},
                              {"posture", text("carry")},
                              {"actuator", text("leaky_chain")},
                              {"strategy", text("mu_comma_lambda")},
                              {"population", whole(5)},
                              {"offspring", whole(6)},
                              {"time_steps", whole(20)},
                              {"cycles", whole(14)}});
    JobRun run(job);
    while (run.outcome().cycles < 9) run.advance(1);
    const idl::Checkpoint good = opened(write_checkpoint(run, job, 0));
    for (const bool of_trainer : {true, false}) {
      const std::string& octets = of_trainer ? good.trainer() : good.recorder();
      for (std::size_t at = 0; at < octets.size(); ++at) {
        for (const char value : {'\0', '\x7f', '\xff'}) {
          idl::Checkpoint bad = good;
          (*(of_trainer ? bad.mutable_trainer() : bad.mutable_recorder()))[at] = value;
          try {
            JobRun resumed = resume(job, sealed(bad)).run;
            while (!resumed.finished()) resumed.advance();
          } catch (const CheckpointError& error) {
            EXPECT_STRNE(error.what(), "");
          }
        }
      }
    }
  }
}

TEST(CheckpointFaults, AnotherJobsCheckpointIsRefusedWithBothIdentities) {
  const Job other = job_with({{"mutation", text("one")}, {"cycles", whole(40)}});
  EXPECT_EQ(refusal(small_checkpoint(), other),
            "it is of the job " + to_hex(identity(small_job())) + ", not of " + to_hex(identity(other)));
}

TEST(CheckpointFaults, AnotherFormatOrScienceVersionIsRefused) {
  const auto newer = changed([](auto& message) { message.set_format(2); });
  EXPECT_EQ(refusal(newer), "it is of format version 2; this program has 1");
  EXPECT_THROW(read_checkpoint_head(newer), CheckpointError);
  const auto other = changed([](auto& message) { message.set_science_version(science_version + 1); });
  EXPECT_EQ(refusal(other), "it is of science version 2; this program has 1");
  EXPECT_THROW(read_checkpoint_trace(other), CheckpointError);
}

TEST(CheckpointFaults, ImpossibleValuesAreRefused) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::function<void(idl::Checkpoint&)>, std::string>> cases{
      {[](auto& m) { m.set_cycle(40); }, "cycle is 40, but the job has 40"},
      {[](auto& m) { m.set_cycle(4'000'000'000U); }, "cycle is 4000000000, but the job has 40"},
      {[](auto& m) { m.set_seconds(-1); }, "its seconds of computation are negative or no number"},
      {[=](auto& m) { m.set_seconds(nothing); }, "its seconds of computation are negative or no number"},
      {[](auto& m) { m.set_identity("short"); }, "its identity has 5 octets"},
      {[](auto& m) { m.add_trace_fuel(1); }, "the columns of its trace differ in length"},
      {[](auto& m) { m.clear_trace_cycle(); }, "the columns of its trace differ in length"},
      {[](auto& m) { m.set_trace_cycle(0, 15); }, "row 0 of its trace is of cycle 15, out of order or not done yet"},
      {[](auto& m) { m.set_trace_cycle(1, m.trace_cycle(0)); },
       "row 1 of its trace is of cycle " + std::to_string(opened(small_checkpoint()).trace_cycle(0)) +
           ", out of order or not done yet"},
      {[=](auto& m) { m.set_trace_total(0, nothing); }, "row 0 of its trace is not of finite numbers"},
      {[](auto& m) { m.clear_trainer(); }, "it ends before gene"},
      {[](auto& m) { m.mutable_trainer()->append("x"); }, "1 octets too many"},
      {[](auto& m) { m.clear_recorder(); }, "it ends before stability"},
      {[](auto& m) { m.mutable_recorder()->append("xy"); }, "2 octets too many"}};
  for (const auto& [change, reason] : cases) EXPECT_EQ(refusal(changed(change)), reason);
}

TEST(CheckpointFaults, OctetsThatAreNoMessageAreRefusedEvenIfTheCrcAgrees) {
  Octets octets{0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(octets.data(), octets.size());
  for (int i = 0; i < 4; ++i) octets.push_back(static_cast<std::uint8_t>(crc.checksum() >> (8 * i)));
  EXPECT_EQ(refusal(octets), "it cannot be read");
}

TEST(CheckpointFaults, TheCheckpointOfAnUnsavableTrainerIsRefused) {
  const Job job = job_with({{"trainer", text("pagmo_sga")}, {"cycles", whole(40)}});
  idl::Checkpoint message = opened(small_checkpoint());
  const Digest name = identity(job);
  message.set_identity(std::string(name.begin(), name.end()));
  EXPECT_EQ(refusal(sealed(message), job), "its trainer cannot be saved");
}

TEST(CheckpointFaults, ARunThatIsTooLargeHasNone) {
  // Without disturbance and steps every cycle is accepted, and a row of the trace takes 35 octets: 449,000 fit.
  const Job job = job_with({{"equilibrium_disturbance", whole(0)},
                            {"mutation_size", whole(0)},
                            {"time_steps", whole(1)},
                            {"cycles", whole(1'000'000)}});
  JobRun run(job);
  const auto size_at = [&](std::uint32_t cycle) {
    while (run.outcome().cycles < cycle) run.advance();
    EXPECT_EQ(run.outcome().accepted, cycle);
    return write_checkpoint(run, job, 0).size();
  };
  const std::size_t before = size_at(440'000);
  EXPECT_GT(before, 440'000U * 35 * 9 / 10);
  EXPECT_LE(before, maximum_checkpoint_bytes);
  EXPECT_EQ(size_at(460'000), 0U) << "found when it is written";
  EXPECT_EQ(size_at(480'000), 0U) << "known before";
}

TEST(CheckpointFaults, OctetsBeyondTheLimitAreNotEvenLookedAt) {
  EXPECT_EQ(refusal(Octets(maximum_checkpoint_bytes + 1)), "it has 15728641 octets, at most 15728640");
}

}  // namespace
}  // namespace lamprey::experiment

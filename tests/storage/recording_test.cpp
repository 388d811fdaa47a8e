#include "storage/recording.hpp"

#include "idl/recording.pb.h"
#include "tests/storage/support.hpp"

#include <functional>
#include <gmock/gmock.h>
#include <limits>

namespace lamprey::storage::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Octets = std::vector<std::uint8_t>;

Octets octets_of(const google::protobuf::MessageLite& message) {
  const std::string text = message.SerializeAsString();
  return {text.begin(), text.end()};
}

idl::RobotRecording message_of(const RobotRecording& recording) {
  idl::RobotRecording message;
  message.set_robot(recording.robot);
  message.set_token(recording.token);
  for (const auto& tried : recording.tries) {
    auto& evaluation = *message.add_evaluations();
    evaluation.set_evaluation(tried.evaluation);
    evaluation.set_attempt(tried.attempt);
    evaluation.set_voided(tried.voided);
    evaluation.set_measured(tried.measured);
    for (const auto position : tried.commanded) evaluation.add_commanded(position);
    for (const auto position : tried.reported) evaluation.add_reported(position);
    for (const auto feet : tried.feet_down) evaluation.add_feet_down(static_cast<std::uint32_t>(feet));
  }
  return message;
}

/// What the parser says to a recording in order, after a change.
std::string refusal_of(const std::function<void(idl::RobotRecording&)>& change) {
  auto message = message_of(made_up_recording(3));
  change(message);
  const auto parsed = parse_recording(octets_of(message));
  EXPECT_EQ(parsed.recording.has_value(), parsed.refusal.empty());
  return parsed.refusal;
}

TEST(RecordingParser, ReadsWhatAWorkerWrites) {
  for (std::uint64_t number = 0; number < 5; ++number) {
    const auto recording = made_up_recording(number);
    const auto parsed = parse_recording(octets_of(message_of(recording)));
    EXPECT_EQ(parsed.refusal, "");
    EXPECT_EQ(parsed.recording, recording);
  }
}

TEST(RecordingParser, TakesTriesThatWereVoidBeforeTheyBeganAndTheLimitsOfEveryBound) {
  auto recording = made_up_recording(1);
  recording.robot = std::string(64, 'r');
  recording.token = std::numeric_limits<std::uint64_t>::max();
  recording.tries.resize(1);
  recording.tries[0].commanded[0] = -furthest_position;
  recording.tries[0].reported[1] = furthest_position;
  recording.tries[0].voided = std::string(longest_void_reason, 'v');
  for (std::uint32_t attempt = 1; attempt < most_tries_of_evaluation; ++attempt) {
    recording.tries.push_back({.evaluation = 0, .attempt = attempt, .voided = "nothing was heard of step 0"});
  }
  EXPECT_EQ(recording.tries.back().time_steps(), 0U);
  EXPECT_EQ(parse_recording(octets_of(message_of(recording))).recording, recording);
}

TEST(RecordingParser, RefusesOctetsThatAreNoRecording) {
  for (const Octets& octets : {Octets{0x1a}, Octets{0xff, 0xff}, Octets{0x1a, 5, 1}, Octets(300, 0x0b),
                               Octets{0x1a, 2, 0x22, 9}, Octets{0x0a, 1, 0xff}}) {
    EXPECT_EQ(parse_recording(octets).refusal, "it is no recording");
  }
  // A whole one that breaks off anywhere, or has a flipped bit, is read or refused, and no more.
  const auto whole = octets_of(message_of(made_up_recording(2)));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto parsed = parse_recording(std::span(whole).first(length));
    EXPECT_EQ(parsed.recording.has_value(), parsed.refusal.empty());
    auto flipped = whole;
    flipped[length] ^= static_cast<std::uint8_t>(1U << length % 8);
    const auto other = parse_recording(flipped);
    EXPECT_EQ(other.recording.has_value(), other.refusal.empty());
    EXPECT_EQ(other.recording ? recording_fault(*other.recording) : "", "");
  }
}

TEST(RecordingParser, RefusesNamesThatNoRobotHas) {
  for (const std::string name : {"", "a b", "a'b", "r/1", "\x1b[2J", "r\xc3\xb6"}) {
    EXPECT_THAT(refusal_of([&](auto& message) { message.set_robot(name); }), HasSubstr("the robot's name is '"));
  }
  EXPECT_THAT(refusal_of([](auto& message) { message.set_robot(std::string(65, 'a')); }), HasSubstr("1 to 64"));
  EXPECT_EQ(refusal_of([](auto& message) { message.set_robot("\x1b"); }).find('\x1b'), std::string::npos);
}

TEST(RecordingParser, RefusesPositionsBeyondEveryRobot) {
  EXPECT_EQ(refusal_of([](auto& message) { message.mutable_evaluations(1)->set_commanded(3, 100'001); }),
            "evaluation 0, try 1: a position commanded is 100001 hundredths, beyond -100000..100000");
  EXPECT_THAT(refusal_of([](auto& message) {
                message.mutable_evaluations(2)->set_reported(0, std::numeric_limits<std::int32_t>::min());
              }),
              AllOf(HasSubstr("evaluation 1, try 0"), HasSubstr("reported is -2147483648")));
}

TEST(RecordingParser, RefusesRowsThatDoNotGoTogether) {
  EXPECT_EQ(refusal_of([](auto& message) { message.mutable_evaluations(0)->add_commanded(1); }),
            "evaluation 0, try 0: 17 positions commanded for 2 rows of 8");
  EXPECT_THAT(refusal_of([](auto& message) { message.mutable_evaluations(0)->clear_reported(); }),
              HasSubstr("0 positions reported for 2 rows of 8"));
  EXPECT_THAT(refusal_of([](auto& message) { message.mutable_evaluations(1)->add_feet_down(0); }),
              HasSubstr("32 positions commanded for 5 rows"));
  EXPECT_THAT(refusal_of([](auto& message) {
                auto& last = *message.mutable_evaluations(2);
                last.clear_commanded();
                last.clear_reported();
                last.clear_feet_down();
              }),
              HasSubstr("evaluation 1, try 0: it counts and has no rows"));
}

TEST(RecordingParser, RefusesFeetThatNoQuadrupedHas) {
  for (const std::uint32_t feet : {16U, 0x80000000U, 0xffffffffU}) {
    EXPECT_THAT(refusal_of([&](auto& message) { message.mutable_evaluations(0)->set_feet_down(0, feet); }),
                HasSubstr("more than the bits of 4 legs"));
  }
}

TEST(RecordingParser, RefusesTriesOutOfOrder) {
  EXPECT_EQ(refusal_of([](auto& message) { message.mutable_evaluations(0)->clear_voided(); }),
            "evaluation 0, try 1: it comes where try 0 of evaluation 1 is due");
  EXPECT_EQ(refusal_of([](auto& message) { message.mutable_evaluations(2)->set_evaluation(2); }),
            "evaluation 2, try 0: it comes where try 0 of evaluation 1 is due");
  EXPECT_THAT(refusal_of([](auto& message) { message.mutable_evaluations(0)->set_attempt(4'000'000'000); }),
              HasSubstr("where try 0 of evaluation 0 is due"));
  EXPECT_THAT(refusal_of([](auto& message) {
                message.mutable_evaluations(2)->set_voided("why");
                *message.add_evaluations() = message.evaluations(2);
              }),
              HasSubstr("where try 1 of evaluation 1 is due"));
}

TEST(RecordingParser, RefusesMoreTriesThanAWorkerMakes) {
  EXPECT_EQ(refusal_of([](auto& message) {
              message.clear_evaluations();
              for (std::uint32_t attempt = 0; attempt <= most_tries_of_evaluation; ++attempt) {
                auto& tried = *message.add_evaluations();
                tried.set_attempt(attempt);
                tried.set_voided("late");
              }
            }),
            "evaluation 0, try 20: at most 20 tries of an evaluation are possible");
  Octets many;
  for (std::uint64_t tried = 0; tried <= most_tries; ++tried) many.insert(many.end(), {0x1a, 0});
  EXPECT_EQ(parse_recording(many).refusal, "it has 100001 tries, at most 100000 are possible");
}

TEST(RecordingParser, RefusesReasonsThatNobodyCanRead) {
  EXPECT_THAT(refusal_of([](auto& message) { message.mutable_evaluations(0)->set_voided("a\x1b[31m"); }),
              AllOf(HasSubstr("evaluation 0, try 0"), HasSubstr("no readable text: 'a\\x1b")));
  EXPECT_THAT(refusal_of([](auto& message) { message.mutable_evaluations(0)->set_voided(std::string(4097, 'x')); }),
              HasSubstr("has 4097 bytes, at most 4096"));
}

TEST(RecordingParser, RefusesMoreThanItIsWorth) {
  RobotRecording recording{.robot = "r", .tries = {{}}};
  auto& tried = recording.tries[0];
  constexpr std::size_t rows = most_recorded_values / (2 * robot_servos + 1) + 1;
  tried.commanded.assign(rows * robot_servos, 0);
  tried.reported.assign(rows * robot_servos, 0);
  tried.feet_down.assign(rows, 0);
  EXPECT_EQ(parse_recording(octets_of(message_of(recording))).refusal, "it has more than 10000000 values");
  EXPECT_THAT(parse_recording(Octets(most_recording_bytes + 1)).refusal, HasSubstr("at most 33554432 are possible"));
}

TEST(WholeNumbers, HaveOneText) {
  const std::vector<std::int32_t> numbers{1000, 0, -25, std::numeric_limits<std::int32_t>::min()};
  std::string text;
  write_whole_numbers(numbers, text);
  EXPECT_EQ(text, "[1000,0,-25,-2147483648]");
  EXPECT_EQ(read_whole_numbers(text), numbers);
  write_whole_numbers({}, text);
  EXPECT_EQ(text, "[]");
  EXPECT_EQ(read_whole_numbers("[]"), std::vector<std::int32_t>());
  for (const auto* wrong :
       {"",     "[",    "]",    "1",      "[1",    "1]",    "[,]",          "[1,]",  "[,1]",   "[1 ]", "[ 1]",
        "[01]", "[-0]", "[+1]", "[1,,2]", "[1.0]", "[1e2]", "[2147483648]", "[[1]]", "[1][2]", "[1]]", "[null]"}) {
    EXPECT_EQ(read_whole_numbers(wrong), std::nullopt) << wrong;
  }
}

}  // namespace
}  // namespace lamprey::storage::testing

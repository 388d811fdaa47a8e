#include "storage/recording.hpp"

#include "experiment/problem.hpp"
#include "idl/recording.pb.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <limits>
#include <string>
#include <utility>

namespace lamprey::storage {

namespace {

using google::protobuf::internal::WireFormatLite;

constexpr std::int32_t every_foot = (1 << robot_legs) - 1;
constexpr std::size_t longest_name = 64;

/// Longest of a number and its comma.
constexpr std::size_t longest_number = std::numeric_limits<std::int32_t>::digits10 + 3;

bool is_robot_name(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
           c == '-';
  };
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, allowed);
}

/// How many tries the message has, found without making them: two octets of an empty one would become a hundred and
/// more in memory. Nothing if the octets are malformed at this level.
std::optional<std::uint64_t> count_tries(std::span<const std::uint8_t> octets) {
  google::protobuf::io::CodedInputStream input(octets.data(), static_cast<int>(octets.size()));
  std::uint64_t tries = 0;
  while (const std::uint32_t tag = input.ReadTag()) {
    if (WireFormatLite::GetTagFieldNumber(tag) == idl::RobotRecording::kEvaluationsFieldNumber) ++tries;
    if (!WireFormatLite::SkipField(&input, tag)) return std::nullopt;
  }
  if (!input.ConsumedEntireMessage()) return std::nullopt;
  return tries;
}

template <typename Numbers>
std::vector<std::int32_t> whole_numbers(const Numbers& numbers) {
  constexpr std::uint32_t most = std::numeric_limits<std::int32_t>::max();
  std::vector<std::int32_t> values;
  values.reserve(static_cast<std::size_t>(numbers.size()));
  for (const auto number : numbers) {
    // What is beyond is out of any range here, and stays so.
    const bool beyond = number > 0 && static_cast<std::uint32_t>(number) > most;
    values.push_back(beyond ? std::numeric_limits<std::int32_t>::max() : static_cast<std::int32_t>(number));
  }
  return values;
}

RobotTry one_try(idl::RobotEvaluation& message) {
  return {.evaluation = message.evaluation(),
          .attempt = message.attempt(),
          .voided = std::move(*message.mutable_voided()),
          .measured = message.measured(),
          .commanded = whole_numbers(message.commanded()),
          .reported = whole_numbers(message.reported()),
          .feet_down = whole_numbers(message.feet_down())};
}

std::string fault_of_positions(std::string_view name, const std::vector<std::int32_t>& positions, std::size_t rows) {
  if (positions.size() != robot_servos * rows) {
    return std::to_string(positions.size()) + " positions " + std::string(name) + " for " + std::to_string(rows) +
           " rows of " + std::to_string(robot_servos);
  }
  const auto beyond = std::ranges::find_if(
      positions, [](std::int32_t position) { return position < -furthest_position || position > furthest_position; });
  if (beyond == positions.end()) return {};
  return "a position " + std::string(name) + " is " + std::to_string(*beyond) + " hundredths, beyond -" +
         std::to_string(furthest_position) + ".." + std::to_string(furthest_position);
}

/// The try after `before`, if there was one: the next of the same evaluation after one that was void, else the first
/// of the next evaluation.
std::string fault_of_order(const RobotTry* before, const RobotTry& tried) {
  std::uint64_t evaluation = 0;
  std::uint64_t attempt = 0;
  if (before != nullptr) {
    const bool again = !before->voided.empty();
    evaluation = std::uint64_t{before->evaluation} + (again ? 0 : 1);
    attempt = again ? std::uint64_t{before->attempt} + 1 : 0;
  }
  if (tried.evaluation == evaluation && tried.attempt == attempt) return {};
  return "it comes where try " + std::to_string(attempt) + " of evaluation " + std::to_string(evaluation) + " is due";
}

std::string fault_of(const RobotTry* before, const RobotTry& tried) {
  if (auto fault = fault_of_order(before, tried); !fault.empty()) return fault;
  if (tried.attempt >= most_tries_of_evaluation) {
    return "at most " + std::to_string(most_tries_of_evaluation) + " tries of an evaluation are possible";
  }
  if (tried.voided.size() > longest_void_reason) {
    return "the reason for which it is void has " + std::to_string(tried.voided.size()) + " bytes, at most " +
           std::to_string(longest_void_reason) + " are possible";
  }
  if (experiment::first_unreadable(tried.voided) != std::string::npos) {
    return "the reason for which it is void is no readable text: '" + experiment::printable(tried.voided) + "'";
  }
  const std::size_t rows = tried.feet_down.size();
  if (auto fault = fault_of_positions("commanded", tried.commanded, rows); !fault.empty()) return fault;
  if (auto fault = fault_of_positions("reported", tried.reported, rows); !fault.empty()) return fault;
  const auto no_feet =
      std::ranges::find_if(tried.feet_down, [](std::int32_t feet) { return feet < 0 || feet > every_foot; });
  if (no_feet != tried.feet_down.end()) {
    return "the feet down are " + std::to_string(*no_feet) + ", more than the bits of " + std::to_string(robot_legs) +
           " legs";
  }
  if (rows == 0 && tried.voided.empty()) return "it counts and has no rows";
  return {};
}

}  // namespace

std::string recording_fault(const RobotRecording& recording) {
  if (!is_robot_name(recording.robot)) {
    return "the robot's name is '" + experiment::printable(recording.robot) + "'; a name is 1 to " +
           std::to_string(longest_name) + " of A-Z, a-z, 0-9, '_', '.' and '-'";
  }
  if (recording.tries.size() > most_tries) {
    return "it has " + std::to_string(recording.tries.size()) + " tries, at most " + std::to_string(most_tries) +
           " are possible";
  }
  std::uint64_t values = 0;
  const RobotTry* before = nullptr;
  for (const auto& tried : recording.tries) {
    values += tried.commanded.size() + tried.reported.size() + tried.feet_down.size();
    if (values > most_recorded_values) return "it has more than " + std::to_string(most_recorded_values) + " values";
    if (const auto fault = fault_of(before, tried); !fault.empty()) {
      return "evaluation " + std::to_string(tried.evaluation) + ", try " + std::to_string(tried.attempt) + ": " + fault;
    }
    before = &tried;
  }
  return {};
}

ParsedRecording parse_recording(std::span<const std::uint8_t> octets) {
  const auto refuse = [](std::string why) { return ParsedRecording{std::nullopt, std::move(why)}; };
  if (octets.size() > most_recording_bytes) {
    return refuse("it has " + std::to_string(octets.size()) + " bytes, at most " +
                  std::to_string(most_recording_bytes) + " are possible");
  }
  const auto tries = count_tries(octets);
  if (tries && *tries > most_tries) {
    return refuse("it has " + std::to_string(*tries) + " tries, at most " + std::to_string(most_tries) +
                  " are possible");
  }
  idl::RobotRecording message;
  if (!tries || !message.ParseFromArray(octets.data(), static_cast<int>(octets.size()))) {
    return refuse("it is no recording");
  }
  RobotRecording recording{.robot = message.robot(), .token = message.token(), .tries = {}};
  recording.tries.reserve(static_cast<std::size_t>(message.evaluations_size()));
  for (auto& evaluation : *message.mutable_evaluations()) recording.tries.push_back(one_try(evaluation));
  if (auto fault = recording_fault(recording); !fault.empty()) return refuse(std::move(fault));
  return {std::move(recording), {}};
}

void write_whole_numbers(std::span<const std::int32_t> numbers, std::string& text) {
  text.clear();
  text += '[';
  std::array<char, longest_number> digits{};
  for (const std::int32_t number : numbers) {
    if (text.size() > 1) text += ',';
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
  }
  text += ']';
}

std::optional<std::vector<std::int32_t>> read_whole_numbers(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  std::vector<std::int32_t> numbers;
  numbers.reserve(static_cast<std::size_t>(std::ranges::count(text, ',')) + 1);
  const char* position = text.data() + 1;
  const char* const end = text.data() + text.size() - 1;
  while (position != end) {
    std::int32_t number = 0;
    const auto [after, error] = std::from_chars(position, end, number);
    if (error != std::errc{}) return std::nullopt;
    numbers.push_back(number);
    position = after;
    if (position == end) break;
    if (*position++ != ',' || position == end) return std::nullopt;
  }
  std::string again;
  write_whole_numbers(numbers, again);
  if (again != text) return std::nullopt;  // another spelling
  return numbers;
}

}  // namespace lamprey::storage

#include "messaging/fastdds/result_batch_type.hpp"

#include "messaging/wire_enums.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

using eprosima::fastrtps::rtps::SerializedPayload_t;
using experiment::AcceptedChange;
using experiment::Score;

template <class Number>
concept Primitive = std::is_arithmetic_v<Number>;

constexpr std::size_t encapsulation_bytes = 4;
constexpr bool little_endian = std::endian::native == std::endian::little;

constexpr std::size_t aligned(std::size_t position, std::size_t size) {
  return (position + size - 1) / size * size;
}

// Both walk over plain CDR: each primitive is aligned to its size, counted from the end of the encapsulation.

class Size {
 public:
  template <Primitive Number>
  void put(Number) {
    bytes_ = aligned(bytes_, sizeof(Number)) + sizeof(Number);
  }
  void put(std::span<const std::uint8_t> octets) { bytes_ += octets.size(); }

  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

/// Writes nothing beyond the end.
class Output {
 public:
  explicit Output(std::span<std::uint8_t> body) : body_(body) {}

  template <Primitive Number>
  void put(Number number) {
    const std::size_t start = aligned(position_, sizeof(Number));
    if (start + sizeof(Number) > body_.size()) {
      good_ = false;
      return;
    }
    std::fill(body_.data() + position_, body_.data() + start, std::uint8_t{0});
    std::memcpy(body_.data() + start, &number, sizeof(Number));
    position_ = start + sizeof(Number);
  }
  void put(std::span<const std::uint8_t> octets) {
    if (octets.size() > body_.size() - position_) {
      good_ = false;
      return;
    }
    std::copy(octets.begin(), octets.end(), body_.data() + position_);
    position_ += octets.size();
  }

  bool good() const { return good_; }
  std::size_t bytes() const { return position_; }

 private:
  std::span<std::uint8_t> body_;
  std::size_t position_ = 0;
  bool good_ = true;
};

template <class Out>
void put_length(Out& out, std::size_t length) {
  out.put(static_cast<std::uint32_t>(length));
}

template <class Out>
void put_text(Out& out, const std::string& text) {
  put_length(out, text.size() + 1);
  out.put(std::span(reinterpret_cast<const std::uint8_t*>(text.c_str()), text.size() + 1));
}

template <class Out>
void put_score(Out& out, const Score& score) {
  out.put(score.stability);
  out.put(score.distance);
  out.put(score.fuel);
  out.put(score.total);
}

template <class Out, class Field>
void put_column(Out& out, const std::vector<AcceptedChange>& trace, Field field) {
  put_length(out, trace.size());
  for (const auto& change : trace) out.put(field(change));
}

template <class Out>
void put_outcome(Out& out, const experiment::Outcome& outcome) {
  put_score(out, outcome.expected);
  put_score(out, outcome.initial);
  put_score(out, outcome.evolved);
  put_score(out, outcome.highest);
  put_score(out, outcome.final);
  out.put(outcome.cycles);
  out.put(outcome.accepted);
  out.put(outcome.successes);
  out.put(outcome.success_rate);
  put_column(out, outcome.trace, [](const AcceptedChange& change) { return change.cycle; });
  put_column(out, outcome.trace, [](const AcceptedChange& change) { return change.score.stability; });
  put_column(out, outcome.trace, [](const AcceptedChange& change) { return change.score.distance; });
  put_column(out, outcome.trace, [](const AcceptedChange& change) { return change.score.fuel; });
  put_column(out, outcome.trace, [](const AcceptedChange& change) { return change.score.total; });
  put_length(out, outcome.measures.size());
  for (const auto& measure : outcome.measures) {
    put_text(out, measure.name);
    out.put(measure.index);
    out.put(measure.value);
  }
}

template <class Out>
void put_result(Out& out, const JobResult& result) {
  out.put(result.job);
  out.put(static_cast<std::uint32_t>(result.kind));
  out.put(result.lease);
  out.put(result.fragment);
  out.put(result.fragments);
  out.put(result.identity);
  out.put(result.digest);
  put_outcome(out, result.outcome);
  out.put(result.seconds);
  out.put(result.waited);
  put_text(out, result.reason);
  put_length(out, result.recording.size());
  out.put(result.recording);
}

template <class Out>
void put_batch(Out& out, const ResultBatch& batch) {
  out.put(batch.origin.worker);
  out.put(batch.origin.database.high);
  out.put(batch.origin.database.low);
  out.put(batch.origin.epoch);
  out.put(batch.origin.science_version);
  out.put(batch.sequence);
  out.put(batch.sweep.high);
  out.put(batch.sweep.low);
  put_length(out, batch.results.size());
  for (const auto& result : batch.results) put_result(out, result);
}

/// Once it has run past the end it stays failed, and all numbers are 0.
class Input {
 public:
  explicit Input(std::span<const std::uint8_t> payload) {
    if (payload.size() < encapsulation_bytes) return;
    swapped_ = ((payload[1] & 1u) != 0) != little_endian;
    body_ = payload.subspan(encapsulation_bytes);
    good_ = true;
  }

  bool good() const { return good_; }

  template <Primitive Number>
  void get(Number& number) {
    number = 0;
    const std::size_t start = aligned(position_, sizeof(Number));
    if (!good_ || start + sizeof(Number) > body_.size()) {
      good_ = false;
      return;
    }
    std::array<std::uint8_t, sizeof(Number)> octets;
    std::memcpy(octets.data(), body_.data() + start, sizeof(Number));
    if (swapped_) std::reverse(octets.begin(), octets.end());
    number = std::bit_cast<Number>(octets);
    position_ = start + sizeof(Number);
  }

  std::span<const std::uint8_t> octets(std::size_t count) {
    if (!good_ || count > body_.size() - position_) {
      good_ = false;
      return {};
    }
    position_ += count;
    return body_.subspan(position_ - count, count);
  }

  /// Of a sequence whose elements have at least `bytes` each: as many as can still follow, or failure.
  std::size_t length(std::size_t bytes) {
    std::uint32_t count = 0;
    get(count);
    if (good_ && count > (body_.size() - position_) / bytes) good_ = false;
    return good_ ? count : 0;
  }

 private:
  std::span<const std::uint8_t> body_;
  std::size_t position_ = 0;
  bool swapped_ = false;
  bool good_ = false;
};

// The least that an element of a sequence has, without alignment.
constexpr std::size_t row_bytes = sizeof(std::uint32_t) + 4 * sizeof(double);  // of a trace, in all of its columns
constexpr std::size_t measure_bytes = 16;
constexpr std::size_t result_bytes = 300;

void get(Input& in, std::string& text) {
  const auto octets = in.octets(in.length(1));
  text.assign(octets.begin(), octets.end());
  if (!text.empty() && text.back() == '\0') text.pop_back();
}

void get(Input& in, std::vector<std::uint8_t>& octets) {
  const auto found = in.octets(in.length(1));
  octets.assign(found.begin(), found.end());
}

void get(Input& in, experiment::Digest& digest) {
  const auto octets = in.octets(digest.size());
  std::copy(octets.begin(), octets.end(), digest.begin());
}

void get(Input& in, Score& score) {
  in.get(score.stability);
  in.get(score.distance);
  in.get(score.fuel);
  in.get(score.total);
}

/// False if it is not as long as the trace.
template <class Field>
bool get_column(Input& in, std::vector<AcceptedChange>& trace, Field field) {
  if (in.length(sizeof(double)) != trace.size()) return false;
  for (auto& change : trace) in.get(field(change));
  return true;
}

bool get(Input& in, std::vector<AcceptedChange>& trace) {
  trace.resize(in.length(row_bytes));
  for (auto& change : trace) in.get(change.cycle);
  return get_column(in, trace, [](AcceptedChange& change) -> double& { return change.score.stability; }) &&
         get_column(in, trace, [](AcceptedChange& change) -> double& { return change.score.distance; }) &&
         get_column(in, trace, [](AcceptedChange& change) -> double& { return change.score.fuel; }) &&
         get_column(in, trace, [](AcceptedChange& change) -> double& { return change.score.total; });
}

bool get(Input& in, experiment::Outcome& outcome) {
  get(in, outcome.expected);
  get(in, outcome.initial);
  get(in, outcome.evolved);
  get(in, outcome.highest);
  get(in, outcome.final);
  in.get(outcome.cycles);
  in.get(outcome.accepted);
  in.get(outcome.successes);
  in.get(outcome.success_rate);
  if (!get(in, outcome.trace)) return false;
  outcome.measures.resize(in.length(measure_bytes));
  for (auto& measure : outcome.measures) {
    get(in, measure.name);
    in.get(measure.index);
    in.get(measure.value);
  }
  return true;
}

/// False if it is not sensible; the rest is then left unread.
bool get(Input& in, JobResult& result) {
  std::uint32_t kind = 0;
  in.get(result.job);
  in.get(kind);
  in.get(result.lease);
  in.get(result.fragment);
  in.get(result.fragments);
  get(in, result.identity);
  get(in, result.digest);
  if (!set_enumerator(result.kind, kind) || !get(in, result.outcome)) return false;
  in.get(result.seconds);
  in.get(result.waited);
  get(in, result.reason);
  get(in, result.recording);
  return true;
}

bool get(Input& in, ResultBatch& batch) {
  in.get(batch.origin.worker);
  in.get(batch.origin.database.high);
  in.get(batch.origin.database.low);
  in.get(batch.origin.epoch);
  in.get(batch.origin.science_version);
  in.get(batch.sequence);
  in.get(batch.sweep.high);
  in.get(batch.sweep.low);
  batch.results.resize(in.length(result_bytes));
  return std::all_of(batch.results.begin(), batch.results.end(), [&](JobResult& result) { return get(in, result); });
}

std::size_t payload_bytes(const ResultBatch& batch) {
  Size size;
  put_batch(size, batch);
  return encapsulation_bytes + size.bytes();
}

}  // namespace

bool ResultBatchType::serialize(void* data, SerializedPayload_t* payload) {
  if (payload->max_size < encapsulation_bytes) return false;
  payload->encapsulation = little_endian ? CDR_LE : CDR_BE;
  const std::array<std::uint8_t, encapsulation_bytes> encapsulation{
      0, little_endian ? std::uint8_t{1} : std::uint8_t{0}, 0, 0};
  std::copy(encapsulation.begin(), encapsulation.end(), payload->data);
  Output output(std::span(payload->data, payload->max_size).subspan(encapsulation_bytes));
  put_batch(output, *static_cast<const ResultBatchOnWire*>(data)->outgoing);
  payload->length = static_cast<std::uint32_t>(encapsulation_bytes + output.bytes());
  return output.good();
}

bool ResultBatchType::deserialize(SerializedPayload_t* payload, void* data) {
  auto& batch = *static_cast<ResultBatchOnWire*>(data);
  Input input({payload->data, payload->length});
  batch.incoming = {};
  batch.sensible = get(input, batch.incoming);
  return input.good();
}

std::function<std::uint32_t()> ResultBatchType::getSerializedSizeProvider(void* data) {
  return [data] { return static_cast<std::uint32_t>(payload_bytes(*static_cast<ResultBatchOnWire*>(data)->outgoing)); };
}

void* ResultBatchType::createData() {
  return new ResultBatchOnWire;
}

void ResultBatchType::deleteData(void* data) {
  delete static_cast<ResultBatchOnWire*>(data);
}

void to_wire(const ResultBatch& sample, ResultBatchOnWire& to) {
  to.outgoing = &sample;
}

bool from_wire(ResultBatchOnWire& from, ResultBatch& sample) {
  sample = std::move(from.incoming);
  return from.sensible;
}

}  // namespace lamprey::messaging::fastdds

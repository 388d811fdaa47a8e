#include "messaging/fastdds/payload_check.hpp"

#include <cstddef>

namespace lamprey::messaging::fastdds {
namespace {

/// Walks over plain CDR: each primitive is aligned to its size, counted from the end of the encapsulation. Once it has
/// run past the end it stays failed and does nothing.
class Walker {
 public:
  explicit Walker(std::span<const std::uint8_t> payload) {
    if (payload.size() < 4) return;
    little_endian_ = (payload[1] & 1u) != 0;
    body_ = payload.subspan(4);
    good_ = true;
  }

  bool good() const { return good_; }

  Walker& u32(std::size_t count = 1) { return primitives(4, count); }
  Walker& u64(std::size_t count = 1) { return primitives(8, count); }
  Walker& real(std::size_t count = 1) { return primitives(8, count); }
  Walker& octets(std::size_t count) { return primitives(1, count); }
  Walker& text() { return octets(length()); }

  Walker& u32s() { return primitives_if_any(4); }
  Walker& reals() { return primitives_if_any(8); }
  Walker& octet_sequence() { return octets(length()); }

  /// `element(walker)` for each element.
  template <class Element>
  Walker& sequence(Element element) {
    const std::size_t count = length();
    for (std::size_t i = 0; i < count && good_; ++i) element(*this);
    return *this;
  }

 private:
  Walker& primitives(std::size_t size, std::size_t count) {
    if (!good_) return *this;
    const std::size_t start = (position_ + size - 1) / size * size;
    good_ = start <= body_.size() && count <= (body_.size() - start) / size;
    if (good_) position_ = start + count * size;
    return *this;
  }

  Walker& primitives_if_any(std::size_t size) {
    const std::size_t count = length();
    return count == 0 ? *this : primitives(size, count);
  }

  /// Every element takes at least one byte, so a length beyond what is left is impossible whatever it counts.
  std::size_t length() {
    u32();
    if (!good_) return 0;
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t place = little_endian_ ? i : 3 - i;
      value |= std::size_t{body_[position_ - 4 + i]} << (8 * place);
    }
    good_ = value <= body_.size() - position_;
    return good_ ? value : 0;
  }

  std::span<const std::uint8_t> body_;
  std::size_t position_ = 0;
  bool little_endian_ = true;
  bool good_ = false;
};

// The types of idl/lamprey.idl, field by field.

Walker& origin(Walker& walker) {
  return walker.u64(3).u32();
}
Walker& ranges(Walker& walker) {
  return walker.sequence([](Walker& range) { range.u64(2); });
}
bool correlated_payload(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  return origin(walker.u64()).u64(2).octet_sequence().good();
}

}  // namespace

template <>
bool lengths_are_possible<WorkerStatus>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  origin(walker.u64()).u64().u32(3).u64(3);
  walker.sequence([](Walker& lease) { ranges(lease.u64(6)); });
  walker.sequence([](Walker& running) { running.u64(3).u32().real(); });
  walker.text().u32().text().text().text().text().text();
  walker.sequence([](Walker& label) { label.text(); });
  return walker.sequence([](Walker& counter) { counter.text().u64(); }).good();
}

template <>
bool lengths_are_possible<SweepSpecification>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  return origin(walker.u64(3)).text().octets(1).octet_sequence().good();
}

template <>
bool lengths_are_possible<Lease>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  origin(walker.u64()).u32().u64(4);
  return ranges(walker).u32().real().octets(1).octet_sequence().text().good();
}

template <>
bool lengths_are_possible<ResultAcknowledgement>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  return origin(walker.u64()).sequence([](Walker& result) { result.u64(3).octets(32).u32().text(); }).good();
}

template <>
bool lengths_are_possible<Checkpoint>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  return origin(walker.u64()).u64(4).u32().real().octets(32).octet_sequence().good();
}

template <>
bool lengths_are_possible<Request>(std::span<const std::uint8_t> payload) {
  return correlated_payload(payload);
}

template <>
bool lengths_are_possible<Reply>(std::span<const std::uint8_t> payload) {
  return correlated_payload(payload);
}

template <>
bool lengths_are_possible<SweepProgress>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  return origin(walker.u64(3)).text().text().u64(8).real(2).u32().good();
}

template <>
bool lengths_are_possible<Traffic>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  walker.octets(16).real().u64();
  return walker.sequence([](Walker& topic) { topic.text().u64(3); }).good();
}

// The types of idl/robot.idl.

template <>
bool lengths_are_possible<RobotStatus>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  walker.u64().text().u32().octets(1).text().u64(4).real().text().text().text().text().u32().text().text();
  return walker.sequence([](Walker& counter) { counter.text().u64(); }).good();
}

template <>
bool lengths_are_possible<RobotRequest>(std::span<const std::uint8_t> payload) {
  return Walker(payload).u64(3).u32().u64().octets(1).real(servos).text().good();
}

template <>
bool lengths_are_possible<RobotReply>(std::span<const std::uint8_t> payload) {
  return Walker(payload).u64(3).octets(1).text().u64().u32(2).octets(1).good();
}

template <>
bool lengths_are_possible<ServoCommand>(std::span<const std::uint8_t> payload) {
  return Walker(payload).u64(3).u32().octets(1).real(servos).good();
}

template <>
bool lengths_are_possible<ServoState>(std::span<const std::uint8_t> payload) {
  return Walker(payload).u64(3).u32(2).text().real(2 * servos).octets(1).u32().u64(2).good();
}

// The types of idl/ros2.idl.

template <>
bool lengths_are_possible<ros2::JointState>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  walker.u32(2).text().sequence([](Walker& name) { name.text(); });
  return walker.reals().reals().reals().good();
}

template <>
bool lengths_are_possible<ros2::Diagnostics>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  walker.u32(2).text().sequence([](Walker& status) {
    status.octets(1).text().text().text().sequence([](Walker& value) { value.text().text(); });
  });
  return walker.good();
}

template <>
bool lengths_are_possible<ros2::JointCommand>(std::span<const std::uint8_t> payload) {
  Walker walker(payload);
  walker.sequence([](Walker& dimension) { dimension.text().u32(2); });
  return walker.u32().reals().good();
}

}  // namespace lamprey::messaging::fastdds

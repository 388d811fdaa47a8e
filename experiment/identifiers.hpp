#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lamprey::experiment {

/// Version of everything that decides an outcome: models, operators, defaults, random streams. Any change that alters
/// a bit of any outcome raises it. Part of a job's identity.
inline constexpr std::uint32_t science_version = 1;

/// A SHA-256 value: of a job's identity, or of its outcome.
using Digest = std::array<std::uint8_t, 32>;

/// 128 bits that name a database or a sweep everywhere: on the wire, in SQLite and in logs (32 lower-case hex digits).
struct Id128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  auto operator<=>(const Id128&) const = default;
};

/// Lower-case hexadecimal.
std::string to_hex(std::span<const std::uint8_t> bytes);
std::string to_hex(const Id128& id);

/// The inverse of to_hex; nothing if the text is not exactly 64 (32) hex digits.
std::optional<Digest> digest_from_hex(std::string_view text);
std::optional<Id128> id128_from_hex(std::string_view text);

/// SHA-256 (FIPS 180-4) of the bytes.
Digest sha256(std::span<const std::uint8_t> bytes);
Digest sha256(std::string_view text);

/// The first 128 bits of a digest, read big-endian.
Id128 leading_128_bits(const Digest& digest);

}  // namespace lamprey::experiment

template <>
struct std::hash<lamprey::experiment::Id128> {
  std::size_t operator()(const lamprey::experiment::Id128& id) const noexcept { return id.high ^ (id.low * 31); }
};

#include "experiment/identifiers.hpp"

#include <openssl/evp.h>
#include <stdexcept>

namespace lamprey::experiment {

namespace {

constexpr std::string_view hex_digits = "0123456789abcdef";

int hex_value(char digit) {
  const auto position = hex_digits.find(digit);
  return position == std::string_view::npos ? -1 : static_cast<int>(position);
}

template <std::size_t Size>
std::optional<std::array<std::uint8_t, Size>> bytes_from_hex(std::string_view text) {
  if (text.size() != 2 * Size) return std::nullopt;
  std::array<std::uint8_t, Size> bytes{};
  for (std::size_t i = 0; i < Size; ++i) {
    const int high = hex_value(text[2 * i]);
    const int low = hex_value(text[2 * i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    bytes[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return bytes;
}

std::uint64_t big_endian(std::span<const std::uint8_t, 8> bytes) {
  std::uint64_t value = 0;
  for (const auto byte : bytes) value = value << 8 | byte;
  return value;
}

}  // namespace

std::string to_hex(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const auto byte : bytes) {
    text += hex_digits[byte >> 4];
    text += hex_digits[byte & 15];
  }
  return text;
}

std::string to_hex(const Id128& id) {
  std::array<std::uint8_t, 16> bytes{};
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[i] = static_cast<std::uint8_t>(id.high >> (56 - 8 * i));
    bytes[8 + i] = static_cast<std::uint8_t>(id.low >> (56 - 8 * i));
  }
  return to_hex(bytes);
}

std::optional<Digest> digest_from_hex(std::string_view text) {
  return bytes_from_hex<32>(text);
}

std::optional<Id128> id128_from_hex(std::string_view text) {
  const auto bytes = bytes_from_hex<16>(text);
  if (!bytes) return std::nullopt;
  const std::span<const std::uint8_t, 16> all(*bytes);
  return Id128{big_endian(all.first<8>()), big_endian(all.last<8>())};
}

Digest sha256(std::span<const std::uint8_t> bytes) {
  Digest digest{};
  unsigned int length = 0;
  // EVP uses the processor's SHA instructions where it has them.
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1 ||
      length != digest.size()) {
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  }
  return digest;
}

Digest sha256(std::string_view text) {
  return sha256(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

Id128 leading_128_bits(const Digest& digest) {
  const std::span<const std::uint8_t, 32> all(digest);
  return {big_endian(all.first<8>()), big_endian(all.subspan<8, 8>())};
}

}  // namespace lamprey::experiment

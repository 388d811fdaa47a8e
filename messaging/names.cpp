#include "messaging/names.hpp"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>

namespace lamprey::messaging {

namespace {

/// Whether all are letters and digits of ASCII, or one of `others`.
bool consists_of(std::string_view text, std::string_view others) {
  return std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || others.find(c) != others.npos;
  });
}

}  // namespace

bool is_valid_isolation(std::string_view name) {
  return !name.empty() && name.size() <= 64 && consists_of(name, "_.-");
}

bool is_valid_peer(std::string_view host) {
  return !host.empty() && host.size() <= 253 && consists_of(host, "_.-:");
}

std::string partition_name(std::string_view isolation, Partition partition) {
  std::string name(isolation);
  if (partition == Partition::common()) return name + "/common";
  std::array<char, 18> receiver{};
  std::snprintf(receiver.data(), receiver.size(), "/%016" PRIx64, partition.receiver);
  return name + receiver.data();
}

}  // namespace lamprey::messaging

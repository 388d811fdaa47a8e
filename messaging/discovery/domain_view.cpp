#include "messaging/discovery/domain_view.hpp"

#include "messaging/discovery/server_address.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace lamprey::messaging::discovery {
namespace {

/// https://www.dds-foundation.org/dds-rtps-vendor-and-product-ids/
constexpr std::array<std::pair<std::uint8_t, std::string_view>, 12> vendors{{
    {0x01, "RTI Connext"},
    {0x02, "OpenSplice"},
    {0x03, "OpenDDS"},
    {0x06, "CoreDX"},
    {0x09, "InterCOM DDS"},
    {0x0f, "Fast DDS"},
    {0x10, "Cyclone DDS"},
    {0x11, "GurumDDS"},
    {0x12, "RustDDS"},
    {0x14, "Dust DDS"},
    {0x15, "HDDS"},
    {0x16, "IntercomDDS"},
}};

}  // namespace

std::string to_text(const Guid& guid) {
  std::string text;
  for (std::size_t i = 0; i < guid.size(); ++i) {
    std::array<char, 3> digits{};
    std::snprintf(digits.data(), digits.size(), "%02x", guid[i]);
    if (i > 0 && i % 4 == 0) text += '.';
    text += digits.data();
  }
  return text;
}

std::string vendor_of(const Participant& participant) {
  const auto vendor = std::ranges::find(vendors, participant.guid[1], [](const auto& pair) { return pair.first; });
  if (participant.guid[0] == 1 && vendor != vendors.end()) return std::string(vendor->second);
  if (server_identity(participant.guid)) return "Fast DDS";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "vendor %02x.%02x", participant.guid[0], participant.guid[1]);
  return text.data();
}

std::string_view to_text(Durability durability) {
  constexpr std::array<std::string_view, 4> texts{"volatile", "transient-local", "transient", "persistent"};
  return texts[static_cast<std::size_t>(durability)];
}

std::string_view to_text(Liveliness liveliness) {
  constexpr std::array<std::string_view, 3> texts{"automatic", "manual by participant", "manual by topic"};
  return texts[static_cast<std::size_t>(liveliness)];
}

}  // namespace lamprey::messaging::discovery

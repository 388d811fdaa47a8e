#include "messaging/discovery/mismatches.hpp"

#include <algorithm>
#include <fnmatch.h>
#include <map>
#include <string_view>

namespace lamprey::messaging::discovery {
namespace {

bool is_pattern(const std::string& partition) {
  return partition.find_first_of("*?[") != std::string::npos;
}

/// Two patterns never match each other.
bool equal_partitions(const std::string& one, const std::string& other) {
  if (is_pattern(one) == is_pattern(other)) return !is_pattern(one) && one == other;
  const auto& [pattern, name] = is_pattern(one) ? std::tie(one, other) : std::tie(other, one);
  return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

const std::vector<std::string>& partitions_of(const EndpointQos& qos) {
  static const std::vector<std::string> the_default{""};
  return qos.partitions.empty() ? the_default : qos.partitions;
}

std::string_view reliability(bool reliable) {
  return reliable ? "reliable" : "best effort";
}
std::string_view ownership(bool exclusive) {
  return exclusive ? "exclusive" : "shared";
}
std::string milliseconds(std::chrono::nanoseconds duration) {
  if (duration == EndpointQos::infinite) return "infinite";
  return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(duration).count()) + " ms";
}

std::string representation(std::int16_t number) {
  constexpr std::array<std::string_view, 3> names{"XCDR1", "XML", "XCDR2"};
  if (number >= 0 && static_cast<std::size_t>(number) < names.size()) {
    return std::string(names[static_cast<std::size_t>(number)]);
  }
  return "representation " + std::to_string(number);
}

/// A writer writes in the first that it names; XCDR1 where it names none.
std::int16_t written_in(const EndpointQos& writer) {
  return writer.representations.empty() ? std::int16_t{0} : writer.representations.front();
}

bool reads(const EndpointQos& reader, std::int16_t number) {
  if (reader.representations.empty()) return number == 0;
  return std::ranges::find(reader.representations, number) != reader.representations.end();
}

std::string conflict(std::string_view what, std::string_view offered, std::string_view requested) {
  std::string text(what);
  text += what.empty() ? "" : ": ";
  text += "the writer offers ";
  text += offered;
  text += ", the reader asks for ";
  return text += requested;
}

}  // namespace

bool share_a_partition(const EndpointQos& one, const EndpointQos& other) {
  return std::ranges::any_of(partitions_of(one), [&](const auto& partition) {
    return std::ranges::any_of(partitions_of(other),
                               [&](const auto& another) { return equal_partitions(partition, another); });
  });
}

std::string incompatibility(const Endpoint& writer, const Endpoint& reader) {
  const auto& offered = writer.qos;
  const auto& requested = reader.qos;
  if (writer.type != reader.type) {
    return "the writer's type is '" + writer.type + "', the reader's '" + reader.type + "'";
  }
  if (requested.reliable && !offered.reliable) {
    return conflict("", reliability(offered.reliable), reliability(requested.reliable));
  }
  if (requested.durability > offered.durability) {
    return conflict("durability", to_text(offered.durability), to_text(requested.durability));
  }
  if (requested.exclusive != offered.exclusive) {
    return conflict("ownership", ownership(offered.exclusive), ownership(requested.exclusive));
  }
  if (requested.deadline < offered.deadline) {
    return conflict("deadline", milliseconds(offered.deadline), milliseconds(requested.deadline));
  }
  if (requested.liveliness > offered.liveliness) {
    return conflict("liveliness", to_text(offered.liveliness), to_text(requested.liveliness));
  }
  if (requested.liveliness_lease < offered.liveliness_lease) {
    return conflict("liveliness lease", milliseconds(offered.liveliness_lease),
                    milliseconds(requested.liveliness_lease));
  }
  if (const auto number = written_in(offered); !reads(requested, number)) {
    return conflict("data representation", representation(number),
                    requested.representations.empty() ? "XCDR1" : representation(requested.representations.front()));
  }
  return {};
}

std::vector<Mismatch> mismatches(const DomainView& view) {
  std::map<std::string_view, std::vector<const Endpoint*>> readers;
  for (const auto& endpoint : view.endpoints) {
    if (!endpoint.writes) readers[endpoint.topic].push_back(&endpoint);
  }
  std::vector<Mismatch> found;
  for (const auto& writer : view.endpoints) {
    if (!writer.writes) continue;
    for (const auto* reader : readers[writer.topic]) {
      if (!share_a_partition(writer.qos, reader->qos)) continue;
      if (auto reason = incompatibility(writer, *reader); !reason.empty()) {
        found.push_back({writer, *reader, std::move(reason)});
      }
    }
  }
  return found;
}

std::vector<std::string> topics_of_other_wire_versions(const DomainView& view, std::uint32_t wire) {
  constexpr std::string_view ours = "lamprey/";
  const std::string current = std::string(ours) + std::to_string(wire) + "/";
  std::vector<std::string> topics;
  for (const auto& endpoint : view.endpoints) {
    if (endpoint.topic.starts_with(ours) && !endpoint.topic.starts_with(current)) topics.push_back(endpoint.topic);
  }
  std::ranges::sort(topics);
  topics.erase(std::unique(topics.begin(), topics.end()), topics.end());
  return topics;
}

}  // namespace lamprey::messaging::discovery

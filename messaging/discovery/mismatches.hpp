#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <string>
#include <vector>

namespace lamprey::messaging::discovery {

/// A writer and a reader of one topic that share a partition, and still exchange nothing: DDS says so to neither
/// program unless it asks.
struct Mismatch {
  Endpoint writer;
  Endpoint reader;
  std::string reason;  ///< "the writer offers best effort, the reader asks for reliable"
};

/// Whether a partition of one is one of the other's; wildcards (* ? [ ]) as fnmatch(3) has them, on one side only.
bool share_a_partition(const EndpointQos& one, const EndpointQos& other);

/// Why they don't match although they share a topic and a partition, or nothing: another type, or a policy of the
/// writer's that is less than the reader asks for (section 2.2.3 of DDS 1.4, and 7.6.3.1 of DDS-XTypes for the
/// representation).
std::string incompatibility(const Endpoint& writer, const Endpoint& reader);

/// In the order of the view's endpoints: the writers', then the readers'.
std::vector<Mismatch> mismatches(const DomainView& view);

/// Topics "lamprey/N/…" of the view whose N is not `wire`, each once, sorted: programs that use them are of another
/// version and never meet ours. Other topics are nobody's business here.
std::vector<std::string> topics_of_other_wire_versions(const DomainView& view, std::uint32_t wire);

}  // namespace lamprey::messaging::discovery

#include "messaging/cyclonedds/domain.hpp"

#include "messaging/tuning.hpp"

#include <atomic>
#include <optional>
#include <stdexcept>

namespace lamprey::messaging::cyclonedds {

Entity make_domain(const JoinOptions& options, KeyHashes key_hashes) {
  const auto configured = [&](std::optional<std::uint32_t> external_domain) {
    return configuration(options, external_domain, key_hashes);
  };
  const dds_entity_t first = dds_create_domain(options.domain, configured({}).c_str());
  if (first != DDS_RETCODE_PRECONDITION_NOT_MET) return {first, "domain"};
  static std::atomic<dds_domainid_t> next = highest_domain + 1;
  return {dds_create_domain(next++, configured(options.domain).c_str()), "domain"};
}

dds_domainid_t number_of(const Entity& domain) {
  dds_domainid_t number = 0;
  if (const auto code = dds_get_domainid(domain.get(), &number); code < 0) {
    throw std::runtime_error(describe("cannot ask for the domain's number", code));
  }
  return number;
}

}  // namespace lamprey::messaging::cyclonedds

#include "messaging/cyclonedds/participant.hpp"
#include "messaging/vendor_library.hpp"

#include <exception>

lamprey::messaging::Participant* lamprey_messaging_join(const lamprey::messaging::JoinOptions& options,
                                                        std::string& error) noexcept {
  try {
    return lamprey::messaging::cyclonedds::make_participant(options).release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}

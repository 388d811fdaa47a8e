#pragma once

#include <dds/dds.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

/// Owners of Cyclone's handles.
namespace lamprey::messaging::cyclonedds {

inline std::string describe(const std::string& what, dds_return_t code) {
  return what + ": " + dds_strretcode(-code) + " (Cyclone DDS " + std::to_string(code) + ")";
}

class Entity {
 public:
  /// Takes what dds_create_… returned; throws std::runtime_error if that is an error.
  Entity(dds_entity_t handle, const std::string& what) : handle_(handle) {
    if (handle < 0) throw std::runtime_error(describe("cannot create " + what, handle));
  }
  ~Entity() {
    if (handle_ > 0) dds_delete(handle_);
  }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Entity(const Entity&) = delete;
  Entity& operator=(const Entity&) = delete;

  dds_entity_t get() const { return handle_; }

 private:
  dds_entity_t handle_;
};

struct Delete {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
  void operator()(dds_listener_t* listener) const { dds_delete_listener(listener); }
};
using Qos = std::unique_ptr<dds_qos_t, Delete>;
using Listener = std::unique_ptr<dds_listener_t, Delete>;

}  // namespace lamprey::messaging::cyclonedds

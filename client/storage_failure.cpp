#include "client/storage_failure.hpp"

namespace lamprey::client {

namespace {

std::string kind_name(storage::StorageError::Kind kind) {
  using Kind = storage::StorageError::Kind;
  switch (kind) {
    case Kind::missing:
      return "missing";
    case Kind::not_a_database:
      return "not_a_database";
    case Kind::newer_schema:
      return "newer_schema";
    case Kind::older_schema:
      return "older_schema";
    case Kind::other_science:
      return "other_science";
    case Kind::in_use:
      return "in_use";
    case Kind::network_file_system:
      return "network_file_system";
    case Kind::name_taken:
      return "name_taken";
    case Kind::not_possible:
      return "not_possible";
    case Kind::corrupt:
      return "corrupt";
    case Kind::full:
      return "full";
    case Kind::busy:
      return "busy";
    case Kind::read_only:
      return "read_only";
    case Kind::input_output:
      return "input_output";
  }
  return "storage";
}

}  // namespace

Failure storage_failure(const storage::StorageError& error) {
  using Kind = storage::StorageError::Kind;
  const bool input = error.kind() == Kind::name_taken || error.kind() == Kind::not_possible;
  return {input ? exit_usage : exit_storage, kind_name(error.kind()), error.what()};
}

}  // namespace lamprey::client

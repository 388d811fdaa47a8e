#pragma once

#include "idl/client.pb.h"

#include <string>
#include <utility>

/// Replies that several requests have.
namespace lamprey::coordinator {

inline idl::Reply error_reply(const std::string& code, const std::string& message) {
  idl::Reply reply;
  reply.mutable_error()->set_code(code);
  reply.mutable_error()->add_messages(message);
  return reply;
}

inline idl::Reply audit_reply(idl::AuditStatus status) {
  idl::Reply reply;
  *reply.mutable_audit() = std::move(status);
  return reply;
}

}  // namespace lamprey::coordinator

#include "client/sweep_input.hpp"

#include "client/coordinator_connection.hpp"

#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

namespace lamprey::client {

SweepInput read_sweep(const std::string& path) {
  SweepInput sweep;
  sweep.path = path;
  sweep.file = experiment::read_sweep_file(path);
  std::ifstream text(path, std::ios::binary);
  sweep.source.assign(std::istreambuf_iterator<char>(text), {});
  sweep.id = experiment::sweep_id(sweep.file.specification);
  return sweep;
}

idl::Request submit_request(const SweepInput& sweep) {
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = sweep.file.specification;
  request.mutable_submit()->set_source(sweep.source);
  return request;
}

void require_accepted(const idl::Reply& reply, const SweepInput& sweep) {
  if (!reply.has_error() || reply.error().code() != "invalid_specification") {
    require_success(reply);
    return;
  }
  std::vector<experiment::Problem> problems;
  for (int i = 0; i < reply.error().messages_size(); ++i) {
    experiment::Problem problem{.field = {}, .message = reply.error().messages(i), .file = sweep.path};
    if (i < reply.error().fields_size()) problem.field = reply.error().fields(i);
    if (const auto place = sweep.file.positions.find(problem.field); place != sweep.file.positions.end()) {
      problem.line = place->second.line;
      problem.column = place->second.column;
    }
    problems.push_back(std::move(problem));
  }
  if (problems.empty()) require_success(reply);
  throw experiment::InvalidInput(std::move(problems));
}

}  // namespace lamprey::client

// Writes the first inputs of the fuzzers whose inputs are no text: fuzz_seeds FOLDER, which has the corpora.
#include "experiment/checkpoint.hpp"
#include "experiment/sweep.hpp"
#include "idl/client.pb.h"
#include "idl/recording.pb.h"
#include "messaging/fastdds/wire.hpp"
#include "tests/messaging/example_samples.hpp"

#include <fastdds/rtps/common/SerializedPayload.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace lamprey;

std::filesystem::path corpora;

void write(const std::string& fuzzer, const std::string& name, const std::string& octets) {
  const auto folder = corpora / (fuzzer + "_corpus");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary) << octets;
}

std::string text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// wire_fuzzer: the topic's number, then the payload.

template <class Sample>
void wire_seed(char topic, const std::string& name, const Sample& sample) {
  typename messaging::fastdds::Wire<Sample>::TypeSupport type;
  typename messaging::fastdds::Wire<Sample>::Type data;
  messaging::fastdds::to_wire(sample, data);
  eprosima::fastrtps::rtps::SerializedPayload_t payload(type.getSerializedSizeProvider(&data)());
  if (!type.serialize(&data, &payload)) throw std::runtime_error("cannot serialize " + name);
  write("wire_fuzzer", name, topic + std::string(payload.data, payload.data + payload.length));
}

template <class Sample>
void wire_seeds(char topic, const std::string& name) {
  wire_seed(topic, name + "_empty", Sample{});
  Sample filled;
  messaging::testing::Values values(static_cast<std::uint64_t>(topic));
  messaging::testing::fill(filled, values);
  wire_seed(topic, name, filled);
}

void wire_seeds() {
  using namespace messaging;
  wire_seeds<WorkerStatus>(0, "worker_status");
  wire_seeds<SweepSpecification>(1, "sweep_specification");
  wire_seeds<Lease>(2, "lease");
  wire_seeds<ResultBatch>(3, "result_batch");
  wire_seeds<ResultAcknowledgement>(4, "result_acknowledgement");
  wire_seeds<Checkpoint>(5, "checkpoint");
  wire_seeds<Request>(6, "request");
  wire_seeds<Reply>(7, "reply");
  wire_seeds<SweepProgress>(8, "sweep_progress");
  wire_seeds<RobotStatus>(9, "robot_status");
  wire_seeds<RobotRequest>(10, "robot_request");
  wire_seeds<RobotReply>(11, "robot_reply");
  wire_seeds<ServoCommand>(12, "servo_command");
  wire_seeds<ServoState>(13, "servo_state");
  wire_seeds<Traffic>(14, "traffic");
}

// checkpoint_fuzzer: the job's number, then the checkpoint. The sweep is the fuzzer's.

void checkpoint_seeds() {
  const experiment::SweepGrid grid(
      experiment::parse_sweep("name: fuzz\nseed: 1\nbase: {cycles: 40}\ngrids:\n"
                              "  - {mutation: [all, one], acceptance: [simple, annealing], steps: [uniform, "
                              "one_fifth_rule], posture: [reset, carry]}\n",
                              "")
          .specification);
  for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
    const auto job = grid.job(number);
    experiment::JobRun run(job);
    for (const std::uint32_t cycles : {1U, 12U, 20U}) {
      run.advance(cycles);
      if (run.finished()) break;
      const auto octets = experiment::write_checkpoint(run, job, 0.5);
      write("checkpoint_fuzzer", "job_" + std::to_string(number) + "_after_" + std::to_string(run.outcome().cycles),
            static_cast<char>(number) + std::string(octets.begin(), octets.end()));
    }
  }
}

// specification_fuzzer, request_fuzzer: from the sweep files of sweep_file_fuzzer that are valid.

std::string with_length(const idl::Request& request) {
  const std::string octets = request.SerializeAsString();
  return {static_cast<char>(octets.size() & 0xff) + std::string(1, static_cast<char>(octets.size() >> 8)) + octets};
}

idl::Request submit(const std::string& yaml) {
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = experiment::parse_sweep(yaml, "").specification;
  request.mutable_submit()->set_source(yaml);
  return request;
}

void specification_seeds() {
  // Short ones lead further than long ones.
  write("sweep_file_fuzzer", "short.yaml", "name: a\nseed: 1\ngrids: [{mutation: all}]\nreplicates: 2\n");
  for (const auto& entry : std::filesystem::directory_iterator(corpora / "sweep_file_fuzzer_corpus")) {
    try {
      const auto file = experiment::parse_sweep(text(entry.path()), "");
      write("specification_fuzzer", entry.path().stem().string(), file.specification.SerializeAsString());
    } catch (const experiment::InvalidInput&) {
      continue;  // there are seeds of those as well, made by the fuzzer
    }
  }
}

void request_seeds() {
  const auto first = submit("name: a\nseed: 1\nbase: {cycles: 6}\ngrids:\n  - {required_fuel: [25, 100]}\n");
  const auto second = submit("name: b\nseed: 1\nbase: {cycles: 9}\ngrids:\n  - {mutation: [all, one]}\n");
  std::map<std::string, idl::Request> about;
  about["status"].mutable_status();
  about["status_of"].mutable_status()->set_sweep("a");
  about["cancel"].mutable_cancel()->set_sweep("a");
  about["results"].mutable_results()->set_sweep("a");
  about["stored_job"].mutable_stored_job()->set_sweep("a");
  about["trace"].mutable_trace()->set_sweep("a");
  about["events"].mutable_events()->set_limit(3);
  about["metrics"].mutable_metrics();
  about["rename"].mutable_rename()->set_sweep("a");
  about["rename"].mutable_rename()->set_name("c");
  about["adjust"].mutable_adjust()->set_sweep("a");
  about["adjust"].mutable_adjust()->set_priority(-3);
  about["drain"].mutable_drain()->set_worker("host");
  about["audit"].mutable_audit()->set_sweep("a");
  about["audit"].mutable_audit()->set_share(0.5);
  about["audit_status"].mutable_audit_status()->set_audit("00112233445566778899aabbccddeeff");
  for (const auto action : {idl::ControlRequest::PAUSE, idl::ControlRequest::RESUME, idl::ControlRequest::RETRY,
                            idl::ControlRequest::ARCHIVE, idl::ControlRequest::DELETE}) {
    auto& request = about["control_" + idl::ControlRequest::Action_Name(action)];
    request.mutable_control()->set_sweep("a");
    request.mutable_control()->set_action(action);
  }
  for (const auto& [name, request] : about) {
    write("request_fuzzer", name, with_length(request));
    write("request_fuzzer", "submit_" + name, with_length(first) + with_length(request));
  }
  write("request_fuzzer", "submit_twice", with_length(first) + with_length(first));
  write("request_fuzzer", "submit_two", with_length(first) + with_length(second) + with_length(about["status"]));
  write("request_fuzzer", "cancel_and_delete",
        with_length(first) + with_length(about["cancel"]) + with_length(about["control_DELETE"]));
}

// reply_fuzzer

void reply_seeds() {
  std::map<std::string, idl::Reply> all;
  all["submit"].mutable_submit()->set_jobs(4);
  auto& status = *all["status"].mutable_status();
  status.add_sweeps()->set_name("a");
  status.mutable_sweeps(0)->mutable_counts()->set_jobs(4);
  auto& worker = *status.add_workers();
  worker.set_worker("0011223344556677");
  worker.set_threads(1);
  worker.set_jobs_done(5);
  worker.set_leases(2);
  all["cancel"].mutable_cancel();
  auto& results = *all["results"].mutable_results();
  results.add_columns("job");
  results.add_rows()->add_values("0");
  all["stored_job"].mutable_stored_job()->set_digest(std::string(64, 'a'));
  all["error"].mutable_error()->set_code("unknown_sweep");
  all["control"].mutable_control();
  all["drain"].mutable_drain();
  all["audit"].mutable_audit();
  all["metrics"].mutable_metrics();
  all["trace"].mutable_trace();
  all["events"].mutable_events()->add_events()->set_text("something happened");
  for (const auto& [name, reply] : all) write("reply_fuzzer", name, reply.SerializeAsString());
}

// result_fuzzer: octets that stand for small numbers; the fuzzer makes what is right of them.

void result_seeds() {
  for (int rows = 0; rows < 8; ++rows) {
    std::string octets("\x01\x00\x02\x05\x03\x00", 6);  // version, claims, job, seconds, waited, no reason
    for (int score = 0; score < 20; ++score) octets.push_back(static_cast<char>(20 + score));
    octets += {'\x06', static_cast<char>(rows), '\x01', '\x01'};  // cycles, accepted, successes, rate
    octets += {'\x00', static_cast<char>(rows), '\x01', '\x02', '\x03', '\x06'};
    for (int row = 0; row < rows; ++row) octets.push_back(static_cast<char>(row == 0 ? 0 : 1));
    octets += std::string(
        "\x01\x03"
        "abc"
        "\x00\x07",
        7);  // a measure
    write("result_fuzzer", "rows_" + std::to_string(rows), octets);
    write("result_fuzzer", "rows_" + std::to_string(rows) + "_in_pieces", octets + "\x01\x02\x03\x01\x02\x03\x04\x05");
  }
}

// trace_fuzzer

void trace_seeds() {
  write("trace_fuzzer", "empty", "[]");
  write("trace_fuzzer", "one", "[[0,50,15,59.8,124.8]]");
  write("trace_fuzzer", "three", "[[0,50,15,59.8,124.8],[3,-0,1e-300,-7.5,1e+22],[999,1,2,3,6]]");
  write("trace_fuzzer", "other_spellings", "[[0,5.0e1,15.00,59.8,1.248e2]]");
  write("trace_fuzzer", "white_space", "[[0, 50, 15, 59.8, 124.8]]");
  write("trace_fuzzer", "infinite", "[[0,inf,nan,1e999,124.8]]");
  write("trace_fuzzer", "short", "[[0,50,15,59.8]]");
  write("trace_fuzzer", "cut", "[[0,50,15,59.8,124.8],[3");
  write("trace_fuzzer", "large_cycle", "[[4294967296,50,15,59.8,124.8]]");
  write("trace_fuzzer", "measure", "[[\"recovery_cycles\",0,17]]");
  write("trace_fuzzer", "measures", "[[\"gait_reached\",0,1],[\"gait_reached\",1,2.5],[\"recovery_cycles\",0,17]]");
  write("trace_fuzzer", "measure_with_escape", "[[\"a\\\"b\",0,1]]");
}

// recording_fuzzer

/// Two evaluations of two time steps, the first of them tried twice.
void recording_seeds() {
  idl::RobotRecording recording;
  recording.set_robot("bench");
  recording.set_token(7);
  write("recording_fuzzer", "empty", recording.SerializeAsString());
  for (std::uint32_t number = 0; number < 3; ++number) {
    auto& evaluation = *recording.add_evaluations();
    evaluation.set_evaluation(number == 2 ? 1 : 0);
    evaluation.set_attempt(number == 1 ? 1 : 0);
    if (number == 0) evaluation.set_voided("a step is late");
    evaluation.set_measured(number == 2);
    for (int row = 0; row < 3; ++row) {
      for (int servo = 0; servo < 8; ++servo) {
        evaluation.add_commanded(1000 + 100 * row);
        evaluation.add_reported(1000 + 99 * row);
      }
      evaluation.add_feet_down(15);
    }
    write("recording_fuzzer", "tries_" + std::to_string(number + 1), recording.SerializeAsString());
  }
  write("recording_fuzzer", "numbers", "[1000,-25,0]");
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  corpora = arguments[1];
  wire_seeds();
  checkpoint_seeds();
  specification_seeds();
  request_seeds();
  reply_seeds();
  result_seeds();
  trace_seeds();
  recording_seeds();
}

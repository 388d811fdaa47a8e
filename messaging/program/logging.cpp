#include "messaging/program/logging.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <google/protobuf/stubs/logging.h>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>

namespace lamprey::messaging::program {
namespace {

/// ISO 8601, UTC, milliseconds.
std::string time_text(spdlog::log_clock::time_point time) {
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count() % 1000;
  const std::time_t seconds = spdlog::log_clock::to_time_t(time);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  std::snprintf(text.data() + length, text.size() - length, ".%03dZ", static_cast<int>(milliseconds));
  return text.data();
}

std::string_view view(spdlog::string_view_t text) {
  return {text.data(), text.size()};
}

/// As a JSON string: escaped and valid UTF-8.
std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Without the quotes, so that a message stays one readable line.
std::string on_one_line(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else if (c == '\r') {
      line += "\\r";
    } else {
      line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
  }
  return line;
}

class LineFormatter final : public spdlog::formatter {
 public:
  LineFormatter(bool json, std::string program) : json_(json), program_(std::move(program)) {}

  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& destination) override {
    const std::string level(view(spdlog::level::to_string_view(message.level)));
    const std::string line = json_ ? "{\"time\":\"" + time_text(message.time) + "\",\"level\":\"" + level +
                                         "\",\"program\":" + json_string(program_) +
                                         ",\"message\":" + json_string(view(message.payload)) + "}\n"
                                   : time_text(message.time) + " " + level + " " + program_ + ": " +
                                         on_one_line(view(message.payload)) + "\n";
    destination.append(line.data(), line.data() + line.size());
  }

  std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<LineFormatter>(json_, program_); }

 private:
  bool json_;
  std::string program_;
};

/// Protobuf would write its own lines between ours. What it has to say of a message from the network is the sender's
/// fault, and the reply or the count of malformed samples says it.
void log_of_protobuf(google::protobuf::LogLevel level, const char*, int, const std::string& message) {
  const bool fatal = level == google::protobuf::LOGLEVEL_FATAL;
  spdlog::log(fatal ? spdlog::level::critical : spdlog::level::debug, "protobuf: {}", message);
}

}  // namespace

void add_logging_options(CLI::App& app, LoggingOptions& options) {
  const std::string group = "Logs";
  app.add_option("--log-level", options.level, "least severe events to log: trace, debug, info, warn, error or off")
      ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
      ->type_name("LEVEL")
      ->capture_default_str()
      ->group(group);
  app.add_option("--log-format", options.format, "text, or json for one JSON object per line")
      ->check(CLI::IsMember({"text", "json"}))
      ->type_name("FORMAT")
      ->capture_default_str()
      ->group(group);
}

std::unique_ptr<spdlog::formatter> make_formatter(const std::string& format, const std::string& program) {
  return std::make_unique<LineFormatter>(format == "json", program);
}

void start_logging(const LoggingOptions& options, const std::string& program) {
  auto logger = std::make_shared<spdlog::logger>(program, std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_formatter(make_formatter(options.format, program));
  logger->set_level(spdlog::level::from_str(options.level));
  logger->flush_on(spdlog::level::trace);
  spdlog::set_default_logger(std::move(logger));
  google::protobuf::SetLogHandler(log_of_protobuf);
}

}  // namespace lamprey::messaging::program

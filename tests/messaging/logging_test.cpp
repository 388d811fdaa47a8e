#include "messaging/program/logging.hpp"

#include "idl/client.pb.h"

#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/details/log_msg.h>
#include <spdlog/spdlog.h>
#include <string>

namespace lamprey::messaging::program {
namespace {

std::string formatted(const std::string& format, const std::string& text) {
  const auto time = spdlog::log_clock::time_point(std::chrono::milliseconds(1'700'000'000'045));
  const spdlog::details::log_msg message(time, {}, "logger", spdlog::level::warn, text);
  spdlog::memory_buf_t buffer;
  make_formatter(format, "lamprey-worker")->format(message, buffer);
  return {buffer.data(), buffer.size()};
}

TEST(Logging, TextIsOneLineWhateverTheMessage) {
  EXPECT_EQ(formatted("text", "two\nlines\x1b[31m\r"),
            "2023-11-14T22:13:20.045Z warning lamprey-worker: two\\nlines?[31m\\r\n");
}

TEST(Logging, JsonLineParsesWhateverTheMessage) {
  const std::string line = formatted("json", "quote \" line\nand \xff octet");
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  const auto event = nlohmann::json::parse(line);
  EXPECT_EQ(event.at("time"), "2023-11-14T22:13:20.045Z");
  EXPECT_EQ(event.at("level"), "warning");
  EXPECT_EQ(event.at("program"), "lamprey-worker");
  EXPECT_THAT(event.at("message").get<std::string>(), ::testing::StartsWith("quote \" line\nand "));
}

TEST(Logging, ProtobufWritesNoLinesOfItsOwn) {
  // A client's request, forged: a name that is not UTF-8. Protobuf complains of it.
  const std::string forged = "\x1a\x03\x0a\x01\xff";
  const auto before = spdlog::default_logger();
  ::testing::internal::CaptureStderr();
  start_logging({.level = "debug", .format = "json"}, "lamprey-worker");
  idl::Request request;
  EXPECT_FALSE(request.ParseFromString(forged));
  spdlog::set_default_logger(before);
  const std::string line = ::testing::internal::GetCapturedStderr();
  const auto event = nlohmann::json::parse(line);
  EXPECT_EQ(event.at("level"), "debug");
  EXPECT_THAT(event.at("message").get<std::string>(), ::testing::StartsWith("protobuf: "));
}

TEST(Logging, UnknownLevelAndFormatAreRefused) {
  LoggingOptions options;
  CLI::App app("test", "test");
  add_logging_options(app, options);
  EXPECT_THROW(app.parse("--log-level loud", false), CLI::ParseError);
  EXPECT_THROW(app.parse("--log-format xml", false), CLI::ParseError);
  app.parse("--log-level debug --log-format json", false);
  EXPECT_EQ(options.level, "debug");
  EXPECT_EQ(options.format, "json");
}

}  // namespace
}  // namespace lamprey::messaging::program

#include "robot_bridge/state_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <sys/file.h>
#include <unistd.h>

namespace lamprey::robot_bridge {
namespace {

constexpr auto format = "lamprey-robot-state/1";

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int error) {
  throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(error));
}

StoredState parse(const std::filesystem::path& path, const std::string& text) {
  try {
    const auto json = nlohmann::json::parse(text);
    if (json.at("format") != format) throw std::runtime_error("its format is not " + std::string(format));
    return {.newest_token = json.at("newest_token").get<std::uint64_t>(),
            .stopped = json.at("stopped").get<bool>(),
            .stop_reason = json.at("stop_reason").get<std::string>()};
  } catch (const std::exception& error) {
    throw std::runtime_error(path.string() + ": is no robot's state: " + error.what() +
                             ". Look at it; if its tokens and emergency stop don't matter any more, remove it");
  }
}

/// Of what a write, a rename or a new file needs to outlive a power cut.
void flush(const std::filesystem::path& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC);
  if (file < 0) fail(path, "can't be opened", errno);
  const int result = ::fsync(file);
  const int error = errno;
  ::close(file);
  if (result != 0) fail(path, "can't be written to the disk", error);
}

}  // namespace

StateFile::StateFile(const std::filesystem::path& folder, const std::string& robot)
    : path_(folder / (robot + ".json")) {
  std::filesystem::create_directories(folder);
  const auto lock = folder / (robot + ".lock");
  lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) fail(lock, "can't be opened", errno);
  try {
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK)
        throw std::runtime_error("robot '" + robot + "' has a bridge already (" + lock.string() + " is locked)");
      fail(lock, "can't be locked", errno);
    }
    if (std::filesystem::exists(path_)) {
      std::ifstream file(path_, std::ios::binary);
      if (!file) fail(path_, "can't be read", errno);
      state_ = parse(path_, {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()});
    } else {
      store(state_);
    }
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

StateFile::~StateFile() {
  ::close(lock_);
}

void StateFile::store(const StoredState& state) {
  const nlohmann::json json{{"format", format},
                            {"newest_token", state.newest_token},
                            {"stopped", state.stopped},
                            {"stop_reason", state.stop_reason}};
  auto fresh = path_;
  fresh += ".new";
  {
    std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
    file << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
    file.flush();
    if (!file) fail(fresh, "can't be written", errno);
  }
  flush(fresh, O_RDONLY);
  std::filesystem::rename(fresh, path_);
  flush(path_.parent_path(), O_RDONLY | O_DIRECTORY);
  state_ = state;
}

void StateFile::latch(const std::string& reason) {
  state_.stopped = true;
  state_.stop_reason = reason;
  store(StoredState(state_));
}

std::filesystem::path default_state_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/') {
    return std::filesystem::path(state) / "lamprey/robots";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::filesystem::path(home) / ".local/state/lamprey/robots";
  }
  return "/var/lib/lamprey/robots";
}

}  // namespace lamprey::robot_bridge

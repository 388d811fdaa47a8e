// An ethernet switch that misbehaves on command: the network of the chaos test.
//
//   lamprey_chaos_relay SEED NAMESPACE…
//
// makes the TAP device `lan0` in each network namespace (ip netns) and carries frames between them, until its standard
// input ends. Each line there is a command, answered by one line:
//   faults NAMESPACE LOSS DUPLICATE REORDER DELAY JITTER  shares from 0 to 1 of the frames to and from it; milliseconds
//   cut NAMESPACE none|in|out|both                        which directions are interrupted, as its owner sees them
//   counters                                              JSON: what has happened to frames so far
// Delay and jitter keep frames in order; a reordered frame is held back while others overtake it.
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <iostream>
#include <linux/if_tun.h>
#include <map>
#include <net/if.h>
#include <optional>
#include <poll.h>
#include <queue>
#include <random>
#include <sched.h>
#include <span>
#include <sstream>
#include <string>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Frame = std::vector<std::uint8_t>;
using Address = std::array<std::uint8_t, 6>;

constexpr std::size_t longest_frame = 2048;
constexpr std::size_t frames_per_turn = 64;       // of one port, so that none starves the others
constexpr std::size_t frames_under_way = 50'000;  // beyond these, new ones are lost

struct Faults {
  double loss = 0;
  double duplicate = 0;
  double reorder = 0;
  double delay = 0;   // milliseconds
  double jitter = 0;  // milliseconds
};

struct Port {
  std::string name;
  int device = -1;
  Faults faults;
  bool cut_in = false;
  bool cut_out = false;
  std::map<std::size_t, Clock::time_point> latest;  // by receiver: no later frame may arrive before it
};

struct Counters {
  std::uint64_t carried = 0;
  std::uint64_t cut = 0;
  std::uint64_t lost = 0;
  std::uint64_t duplicated = 0;
  std::uint64_t reordered = 0;
  std::uint64_t delayed = 0;
  std::uint64_t overflowed = 0;
};

struct UnderWay {
  Clock::time_point due;
  std::uint64_t number = 0;
  std::size_t to = 0;
  Frame frame;
  bool operator>(const UnderWay& other) const { return std::pair(due, number) > std::pair(other.due, other.number); }
};

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// The TAP device lives as long as its descriptor.
int tap_in(const std::string& name) {
  const int space = ::open(("/run/netns/" + name).c_str(), O_RDONLY | O_CLOEXEC);
  if (space < 0) fail("network namespace " + name);
  if (::setns(space, CLONE_NEWNET) != 0) fail("setns " + name);
  ::close(space);
  const int device = ::open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (device < 0) fail("/dev/net/tun");
  ifreq request{};
  std::strncpy(request.ifr_name, "lan0", IFNAMSIZ - 1);
  request.ifr_flags = IFF_TAP | IFF_NO_PI;
  if (::ioctl(device, TUNSETIFF, &request) != 0) fail("TUNSETIFF in " + name);
  return device;
}

class Relay {
 public:
  Relay(std::uint64_t seed, std::span<char* const> names) : random_(seed) {
    for (const char* name : names) {
      ports_.emplace_back();
      ports_.back().name = name;
      ports_.back().device = tap_in(name);
    }
  }

  /// Until standard input ends.
  void run() {
    std::vector<pollfd> waits{{STDIN_FILENO, POLLIN, 0}};
    for (const auto& port : ports_) waits.push_back({port.device, POLLIN, 0});
    while (true) {
      const auto wait = time_to_wait();
      if (::ppoll(waits.data(), waits.size(), wait ? &*wait : nullptr, nullptr) < 0 && errno != EINTR) fail("poll");
      deliver_due();
      for (std::size_t i = 0; i < ports_.size(); ++i) {
        if ((waits[i + 1].revents & POLLIN) != 0) receive(i);
      }
      if (waits[0].revents != 0 && !read_commands()) return;
    }
  }

 private:
  std::optional<timespec> time_to_wait() const {
    if (under_way_.empty()) return std::nullopt;
    const auto wait = std::max(under_way_.top().due - Clock::now(), Clock::duration::zero());
    const auto seconds = std::chrono::floor<std::chrono::seconds>(wait);
    return timespec{seconds.count(), std::chrono::nanoseconds(wait - seconds).count()};
  }

  void receive(std::size_t from) {
    std::array<std::uint8_t, longest_frame> buffer;
    for (std::size_t i = 0; i < frames_per_turn; ++i) {
      const ssize_t size = ::read(ports_[from].device, buffer.data(), buffer.size());
      if (size < 14) return;  // nothing left, or a device that is down
      Address sender, receiver;
      std::copy_n(buffer.begin(), 6, receiver.begin());
      std::copy_n(buffer.begin() + 6, 6, sender.begin());
      place_of_[sender] = from;
      const Frame frame(buffer.begin(), buffer.begin() + size);
      const auto known = place_of_.find(receiver);
      const bool flood = (receiver[0] & 1U) != 0 || known == place_of_.end();
      for (std::size_t to = 0; to < ports_.size(); ++to) {
        if (to != from && (flood || known->second == to)) carry(from, to, frame);
      }
    }
  }

  void carry(std::size_t from, std::size_t to, const Frame& frame) {
    if (ports_[from].cut_out || ports_[to].cut_in) {
      ++counters_.cut;
      return;
    }
    const Faults& a = ports_[from].faults;
    const Faults& b = ports_[to].faults;
    if (happens(a.loss) || happens(b.loss)) {
      ++counters_.lost;
      return;
    }
    send(from, to, frame, a, b);
    if (happens(a.duplicate) || happens(b.duplicate)) {
      ++counters_.duplicated;
      send(from, to, frame, a, b);
    }
  }

  void send(std::size_t from, std::size_t to, const Frame& frame, const Faults& a, const Faults& b) {
    if (under_way_.size() >= frames_under_way) {
      ++counters_.overflowed;
      return;
    }
    const auto now = Clock::now();
    auto& latest = ports_[from].latest[to];
    const double delay = a.delay + b.delay + uniform(a.jitter) + uniform(b.jitter);
    auto due = now + milliseconds(delay);
    if (happens(a.reorder) || happens(b.reorder)) {
      ++counters_.reordered;
      due += milliseconds(1 + uniform(30));
    } else {
      due = std::max(due, latest);
      latest = due;
    }
    if (delay > 0) ++counters_.delayed;
    under_way_.push({due, ++number_, to, frame});
  }

  void deliver_due() {
    const auto now = Clock::now();
    while (!under_way_.empty() && under_way_.top().due <= now) {
      const auto& next = under_way_.top();
      // A full queue or a device that is down loses the frame, as a cable would.
      if (::write(ports_[next.to].device, next.frame.data(), next.frame.size()) > 0) ++counters_.carried;
      under_way_.pop();
    }
  }

  bool read_commands() {
    std::array<char, 4096> buffer;
    const ssize_t size = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (size <= 0) return false;
    input_.append(buffer.data(), static_cast<std::size_t>(size));
    for (auto end = input_.find('\n'); end != std::string::npos; end = input_.find('\n')) {
      std::cout << answer(input_.substr(0, end)) << std::endl;
      input_.erase(0, end + 1);
    }
    return true;
  }

  std::string answer(const std::string& line) {
    std::istringstream words(line);
    std::string command, name;
    words >> command;
    if (command == "counters") return counters();
    words >> name;
    for (auto& port : ports_) {
      if (port.name != name) continue;
      if (command == "faults" && set_faults(port, words)) return "ok";
      if (command == "cut" && set_cut(port, words)) return "ok";
    }
    return "not understood: " + line;
  }

  static bool set_faults(Port& port, std::istringstream& words) {
    Faults faults;
    if (!(words >> faults.loss >> faults.duplicate >> faults.reorder >> faults.delay >> faults.jitter)) return false;
    port.faults = faults;
    return true;
  }

  static bool set_cut(Port& port, std::istringstream& words) {
    std::string direction;
    words >> direction;
    if (direction != "none" && direction != "in" && direction != "out" && direction != "both") return false;
    port.cut_in = direction == "in" || direction == "both";
    port.cut_out = direction == "out" || direction == "both";
    return true;
  }

  std::string counters() const {
    std::ostringstream text;
    text << "{\"carried\": " << counters_.carried << ", \"cut\": " << counters_.cut << ", \"lost\": " << counters_.lost
         << ", \"duplicated\": " << counters_.duplicated << ", \"reordered\": " << counters_.reordered
         << ", \"delayed\": " << counters_.delayed << ", \"overflowed\": " << counters_.overflowed << "}";
    return text.str();
  }

  bool happens(double probability) {
    return probability > 0 && std::uniform_real_distribution<double>(0, 1)(random_) < probability;
  }
  double uniform(double below) { return below > 0 ? std::uniform_real_distribution<double>(0, below)(random_) : 0; }
  static Clock::duration milliseconds(double count) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(count));
  }

  std::mt19937_64 random_;
  std::vector<Port> ports_;
  std::map<Address, std::size_t> place_of_;
  std::priority_queue<UnderWay, std::vector<UnderWay>, std::greater<>> under_way_;
  std::uint64_t number_ = 0;
  Counters counters_;
  std::string input_;
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::cerr << "usage: lamprey_chaos_relay SEED NAMESPACE...\n";
    return 2;
  }
  try {
    Relay relay(std::stoull(arguments[1]), std::span<char* const>(arguments + 2, static_cast<std::size_t>(count - 2)));
    std::cout << "ready" << std::endl;
    relay.run();
  } catch (const std::exception& error) {
    std::cerr << "lamprey_chaos_relay: " << error.what() << '\n';
    return 1;
  }
}

#pragma once

#include "messaging/port.hpp"

#include <cstdint>
#include <list>
#include <memory>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace lamprey::coordinator {

/// One writer per receiver of a directed topic, made when first needed. Beyond `most`, the one that was longest not
/// used is closed: what comes from the network must not fill the memory with writers. Not thread-safe.
template <class Sample>
class DirectedWriters {
 public:
  DirectedWriters(messaging::Participant& participant, std::size_t most) : participant_(participant), most_(most) {}

  /// Whether it was written. A sample that was not is logged and forgotten: every directed message of ours is repeated
  /// by the protocol above when its effect does not show.
  bool write(std::uint64_t receiver, const Sample& sample) {
    try {
      const auto result = writer(receiver).write(sample);
      if (!result) spdlog::debug("a message to {:016x} was not written: {}", receiver, result.error);
      return static_cast<bool>(result);
    } catch (const std::runtime_error& error) {
      // DDS is out of something. Whoever asked for the writer must not end this program with it.
      spdlog::error("no writer for {:016x}: {}", receiver, error.what());
      return false;
    }
  }

  void close(std::uint64_t receiver) {
    const auto found = writers_.find(receiver);
    if (found == writers_.end()) return;
    used_.erase(found->second.position);
    writers_.erase(found);
  }

 private:
  struct Entry {
    std::unique_ptr<messaging::Writer<Sample>> writer;
    std::list<std::uint64_t>::iterator position;
  };

  messaging::Writer<Sample>& writer(std::uint64_t receiver) {
    const auto found = writers_.find(receiver);
    if (found != writers_.end()) {
      used_.splice(used_.begin(), used_, found->second.position);
      return *found->second.writer;
    }
    if (writers_.size() >= most_) close(used_.back());
    auto made = participant_.writer<Sample>(messaging::Partition::of(receiver));
    used_.push_front(receiver);
    return *writers_.emplace(receiver, Entry{std::move(made), used_.begin()}).first->second.writer;
  }

  messaging::Participant& participant_;
  std::size_t most_;
  std::list<std::uint64_t> used_;  ///< most recent first
  std::unordered_map<std::uint64_t, Entry> writers_;
};

}  // namespace lamprey::coordinator

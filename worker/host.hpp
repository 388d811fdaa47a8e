#pragma once

#include <string>

/// What a worker tells about where it computes. None of it changes an outcome; it is there to explain differences.
namespace lamprey::worker {

/// As the processor names itself ("Intel(R) Xeon(R) …"), or else the kind of machine ("aarch64").
std::string processor_name();

/// The widest vector instructions that this program was compiled for.
std::string instruction_set();

}  // namespace lamprey::worker

#pragma once

#include "messaging/program/exit_codes.hpp"

namespace lamprey::client {

using enum messaging::program::ExitCode;
using messaging::program::ExitCode;

}  // namespace lamprey::client

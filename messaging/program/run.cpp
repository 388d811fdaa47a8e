#include "messaging/program/run.hpp"

#include "messaging/port.hpp"
#include "messaging/program/exit_codes.hpp"

#include <exception>
#include <spdlog/spdlog.h>

namespace lamprey::messaging::program {

int run(CLI::App& app, int count, char** arguments, const LoggingOptions& logging, const std::function<int()>& serve) {
  try {
    app.parse(count, arguments);
    start_logging(logging, app.get_name());
    return serve();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  } catch (const JoinError& error) {
    spdlog::error("{}", error.what());
    return exit_unreachable;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return exit_failure;
  }
}

}  // namespace lamprey::messaging::program

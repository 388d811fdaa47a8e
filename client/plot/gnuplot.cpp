#include "client/plot/gnuplot.hpp"

#include "client/failure.hpp"
#include "client/plot/script.hpp"
#include "client/processes/child_process.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>
#include <unistd.h>

namespace lamprey::client::plot {

namespace {

constexpr std::chrono::milliseconds poll_interval{5};

std::optional<std::filesystem::path> find_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto file = std::filesystem::path(folder.empty() ? "." : folder) / program;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return std::nullopt;
}

std::string terminal(const Picture& picture, PictureFormat format) {
  const auto size = [&](int factor) {
    return std::to_string(picture.width * factor) + "," + std::to_string(picture.height * factor);
  };
  if (format == PictureFormat::svg)
    return "set terminal svg size " + size(1) + " dynamic noenhanced font 'Helvetica,13' background rgb 'white'\n";
  return "set terminal pngcairo size " + size(2) +
         " noenhanced font 'Sans,13' fontscale 1.6 linewidth 2 pointscale 1.6 background rgb 'white'\n";
}

/// A folder for one picture, gone with it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "lamprey-plot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), "cannot make a folder in " + name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace

PictureFormat format_of(const std::filesystem::path& file) {
  if (file.extension() == ".svg") return PictureFormat::svg;
  if (file.extension() == ".png") return PictureFormat::png;
  throw usage_failure("plot: '" + file.string() + "' must end in .svg or .png");
}

void draw(const Picture& picture, const std::filesystem::path& file, PictureFormat format,
          const std::function<bool()>& interrupted) {
  const auto program = find_on_path("gnuplot");
  if (!program) {
    throw Failure(exit_failure, "program_missing",
                  "gnuplot, which draws the pictures, is not on the PATH; Debian's package is gnuplot-nox");
  }
  const std::string script = terminal(picture, format) + "set output " + in_quotes(file.string()) + "\n" +
                             picture.script + "\nunset multiplot\nset output\n";
  std::error_code none_before;
  std::filesystem::remove(file, none_before);  // so that a picture that is there afterwards is this one
  processes::ChildProcess gnuplot(*program, {"-d", "-"}, script);
  std::vector<std::string> said;
  for (;;) {
    const auto ended = gnuplot.poll();
    for (auto& line : gnuplot.take_lines()) {
      if (!line.empty()) said.push_back(std::move(line));
    }
    if (ended) {
      std::error_code error;
      if (ended->code == 0 && ended->signal == 0 && std::filesystem::file_size(file, error) > 0 && !error) return;
      said.insert(said.begin(), "gnuplot " + ended->text() + " and wrote no " + file.string());
      throw Failure(exit_failure, "gnuplot", said);
    }
    if (interrupted()) throw Failure(exit_interrupted, "interrupted", std::string("interrupted"));
    std::this_thread::sleep_for(poll_interval);
  }
}

std::string svg_element(const Picture& picture, const std::function<bool()>& interrupted) {
  const ScratchFolder scratch;
  const auto file = scratch.file("picture.svg");
  draw(picture, file, PictureFormat::svg, interrupted);
  std::ifstream stream(file);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const auto begin = text.find("<svg");
  if (begin == std::string::npos)
    throw Failure(exit_failure, "gnuplot", std::string("gnuplot wrote something else than an SVG picture"));
  return text.substr(begin);
}

}  // namespace lamprey::client::plot

#pragma once

#include <filesystem>
#include <functional>
#include <string>

/// Pictures by gnuplot, which runs as a child process with a script on its standard input.
namespace lamprey::client::plot {

enum class PictureFormat : unsigned char { svg, png };

/// A script without its terminal, and how large its picture is.
struct Picture {
  std::string script;
  int width = 900;  ///< in the units of SVG; a PNG has twice as many pixels
  int height = 560;
};

/// By the ending of the name, .svg or .png; throws Failure (usage) for another.
PictureFormat format_of(const std::filesystem::path& file);

/// Writes the picture. Throws Failure: program_missing if gnuplot isn't on the PATH (with the name of its package),
/// gnuplot with what it said, interrupted.
void draw(const Picture& picture, const std::filesystem::path& file, PictureFormat format,
          const std::function<bool()>& interrupted);

/// The picture as an <svg> element, without the prologue of a file: for an HTML page.
std::string svg_element(const Picture& picture, const std::function<bool()>& interrupted);

}  // namespace lamprey::client::plot

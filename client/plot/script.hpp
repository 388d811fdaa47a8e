#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pieces of gnuplot scripts. Free functions; any thread.
namespace lamprey::client::plot {

/// Colours that all kinds of colour vision tell apart (Okabe and Ito 2008), darkest first where it matters in print.
namespace colour {
constexpr std::string_view blue = "#0072B2";
constexpr std::string_view vermilion = "#D55E00";
constexpr std::string_view green = "#009E73";
constexpr std::string_view orange = "#E69F00";
constexpr std::string_view sky = "#56B4E9";
constexpr std::string_view purple = "#CC79A7";
constexpr std::string_view black = "#222222";
constexpr std::string_view grey = "#8A939E";
}  // namespace colour

/// The colour of the series of that number; they come again after seven.
std::string_view colour_of(std::size_t number);

/// 'text' as gnuplot reads it back, whatever is in it.
std::string in_quotes(std::string_view text);

/// Six significant digits; NaN for what is not finite.
std::string number(double value);

/// "$name << EOD ... EOD\n" with a line per row.
std::string data_block(std::string_view name, const std::vector<std::vector<double>>& rows);

/// What all pictures have in common: encoding, thin grey borders, a light grid.
std::string common_style();

/// "set title ...", "set xlabel ...", "set ylabel ..."; the title may have several lines.
std::string labels(std::string_view title, std::string_view x, std::string_view y);

/// Starts a page of panels under a title, with a smaller line below it, which may be empty.
std::string multiplot(int rows, int columns, std::string_view title, std::string_view note);

/// "all, one and some": commands joined to one plot command, "plot a, \\\n b".
std::string plot_command(const std::vector<std::string>& items, std::string_view command = "plot");

}  // namespace lamprey::client::plot

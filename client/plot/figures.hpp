#pragma once

#include "client/plot/figure.hpp"

/// How each figure is made; figure_table.cpp has the rows.
namespace lamprey::client::plot {

Picture operator_bars(const Request& request, const Figure& figure);              ///< 8.3 to 8.5, 8.10
Picture disturbance_surfaces(const Request& request, const Figure& figure);       ///< 8.6 to 8.9
Picture fitness_by_network(const Request& request, const Figure& figure);         ///< 6.25, 6.30
Picture fitness_against_variation(const Request& request, const Figure& figure);  ///< 6.26, 6.31
Picture fitness_by_mutation_rate(const Request& request, const Figure& figure);   ///< 6.27
Picture gait_change_failures(const Request& request, const Figure& figure);       ///< 9.5, 9.6
Picture fitness_of_jobs(const Request& request, const Figure& figure);
Picture outputs_against_wanted(const Request& request, const Figure& figure);  ///< 7.17, 7.22
Picture network_output(const Request& request, const Figure& figure);          ///< 7.26 (b), appendix D
Picture leg_positions(const Request& request, const Figure& figure);           ///< 7.26 (c)
Picture side_view(const Request& request, const Figure& figure);               ///< 7.26 (d)
Picture view_in_space(const Request& request, const Figure& figure);           ///< 7.26 (e)

}  // namespace lamprey::client::plot

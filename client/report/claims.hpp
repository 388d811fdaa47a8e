#pragma once

#include "client/report/claim.hpp"

/// What each claim is assessed by, a file per chapter of the thesis; claim_table.cpp has the rows.
namespace lamprey::client::report {

std::vector<Part> assess_normal_against_uniform(const Evidence& evidence, const Reading& reading);    ///< 1
std::vector<Part> assess_annealing_against_simple(const Evidence& evidence, const Reading& reading);  ///< 2
std::vector<Part> assess_one_against_all(const Evidence& evidence, const Reading& reading);           ///< 3
std::vector<Part> assess_some(const Evidence& evidence, const Reading& reading);                      ///< 4
std::vector<Part> assess_one_fifth_rule(const Evidence& evidence, const Reading& reading);            ///< 5
std::vector<Part> assess_simple_surfaces(const Evidence& evidence, const Reading& reading);           ///< 6
std::vector<Part> assess_annealing_surfaces(const Evidence& evidence, const Reading& reading);        ///< 7
std::vector<Part> assess_biped_real_time(const Evidence& evidence, const Reading& reading);           ///< 8
std::vector<Part> assess_biped_population(const Evidence& evidence, const Reading& reading);          ///< 9
std::vector<Part> assess_wanted_output(const Evidence& evidence, const Reading& reading);             ///< 10
std::vector<Part> assess_gait_change(const Evidence& evidence, const Reading& reading);               ///< 11

}  // namespace lamprey::client::report

#pragma once

#include "client/json.hpp"
#include "client/output/console.hpp"
#include "client/report/findings.hpp"

#include <map>
#include <string>

/// The forms that findings take.
namespace lamprey::client::report {

void print_text(const output::Console& console, const Findings& findings);

/// The document lamprey/report/1 (docs/guides/findings.md).
Json as_json(const Findings& findings);

/// SVG pictures for the claims that have them: position in Findings::findings, then the pictures.
using Pictures = std::map<std::size_t, std::vector<std::string>>;

/// One file that needs no other: styles within, no scripts, the pictures inline.
std::string as_html(const Findings& findings, const Pictures& pictures);

}  // namespace lamprey::client::report

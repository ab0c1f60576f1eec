#pragma once

#include "reports/text/table.hpp"
#include "reports/text/text_table.hpp"
#include "reports/words/scene_reports.hpp"

#include <cstddef>
#include <string>

namespace ff::reports {

/// Whether all pairs are within the tolerance; if not, which ones are outside.
std::string form_factors_verdict(const FormFactorReport& report);

/// Methods with reasons, the matrix if small, row sums, and pairs that miss the tolerance, for the terminal.
std::string form_factors_text(const FormFactorReport& report, const TextStyle& style = {});

/// A row per face; with more than `most` faces, those with the largest powers, as a remark says.
Table heat_table(const HeatReport& report, std::size_t most);

/// The certainty: "Every power is within ..."
std::string heat_verdict(const HeatReport& report);

/// The power that goes to the surroundings, or the sum of powers in a closed scene.
std::string heat_balance(const HeatReport& report);

/// How many samples were taken where flows depend on them; empty where sampling did not depend on flows.
std::string heat_effort(const HeatReport& report);

/// A row for each face, the balance, and its certainty, for the terminal.
std::string heat_text(const HeatReport& report, const TextStyle& style = {});

}  // namespace ff::reports

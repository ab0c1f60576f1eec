#pragma once

#include "reports/text/text_table.hpp"
#include "reports/words/heat_words.hpp"

#include <string>

namespace ff::reports {

/// Groups, a row for each face if there is one case, balances, and how certain they are, for the terminal.
std::string heat_text(const HeatReport& report, const TextStyle& style = {});

}  // namespace ff::reports

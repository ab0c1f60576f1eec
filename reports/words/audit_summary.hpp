#pragma once

#include "studies/audit/audit.hpp"
#include "studies/published/published.hpp"

#include <string>

namespace ff::reports {

/// How many contradictions there are, in a sentence.
std::string audit_verdict(const studies::audit::Report& report);

/// The audit in a few lines for a terminal: the verdict, then one line per finding, with the line of the tables file
/// where its first figure stands.
std::string audit_summary(const studies::PublishedTables& tables, const studies::audit::Report& report);

}  // namespace ff::reports

#pragma once

#include "studies/audit.hpp"
#include "studies/published.hpp"

#include <string>

namespace ff::reports {

/// The audit as a document to read: verdict, findings, and what they rest on.
std::string audit_markdown(const studies::PublishedTables& tables, const studies::AuditReport& report);

/// The audit in a few lines for a terminal: the verdict and one line a finding, with the line of the tables file where
/// its first figure stands.
std::string audit_summary(const studies::PublishedTables& tables, const studies::AuditReport& report);

}  // namespace ff::reports

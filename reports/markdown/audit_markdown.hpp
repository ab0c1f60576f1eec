#pragma once

#include "studies/audit/audit.hpp"
#include "studies/published/published.hpp"

#include <string>

namespace ff::reports {

/// The audit as a document to read: verdict, findings, and what they rest on.
std::string audit_markdown(const studies::PublishedTables& tables, const studies::audit::Report& report);

}  // namespace ff::reports

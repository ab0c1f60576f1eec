#pragma once

#include <map>
#include <string>

namespace ff::reports {

/// context.json. Host, compiler, dates and timings: everything that may differ between equal runs.
std::string context_json(const std::map<std::string, std::string>& context);

}  // namespace ff::reports

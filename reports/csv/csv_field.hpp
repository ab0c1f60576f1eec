#pragma once

#include <string>
#include <string_view>

namespace ff::reports {

/// A cell of a CSV file; quoted where it has to be (RFC 4180).
std::string csv_field(std::string_view text);

}  // namespace ff::reports

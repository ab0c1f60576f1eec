#pragma once

#include <string>
#include <string_view>

namespace ff {

/// A user's text as messages quote it: the beginning, and "…" if it has more than 200 bytes.
std::string excerpt(std::string_view text);

}  // namespace ff

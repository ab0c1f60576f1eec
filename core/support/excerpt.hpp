#pragma once

#include <string>
#include <string_view>

namespace ff {

/// What a user wrote, as a message quotes it: the beginning, and "…" where there is more than 200 bytes.
std::string excerpt(std::string_view text);

}  // namespace ff

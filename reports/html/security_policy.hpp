#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ff::reports {

/// A content-security policy for a document that needs nothing but what it contains: these styles and scripts, known by
/// their SHA-256, run; nothing is loaded, nothing else runs, no text is evaluated as code.
std::string security_policy(std::span<const std::string_view> styles, std::span<const std::string_view> scripts);

}  // namespace ff::reports

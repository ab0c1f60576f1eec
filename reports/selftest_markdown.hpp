#pragma once

#include "studies/selftest/selftest.hpp"

#include <string>

namespace ff::reports {

/// The tables of docs/validation.md, in Markdown.
std::string selftest_markdown(const studies::Selftest& selftest);

}  // namespace ff::reports

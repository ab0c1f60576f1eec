#pragma once

#include "studies/radiosity/enclosure_study.hpp"

#include <string>

namespace ff::reports {

/// What `ffstudy enclosure` prints, in Markdown: exact factors, exact solutions, and the effect of rays on them.
std::string enclosure_text(const studies::EnclosureRequest& request, const studies::EnclosureResults& results);

}  // namespace ff::reports

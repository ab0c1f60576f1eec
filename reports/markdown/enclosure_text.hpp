#pragma once

#include "studies/radiosity/enclosure_study.hpp"

#include <string>

namespace ff::reports {

/// The output of `ffstudy enclosure`, in Markdown: exact factors, exact solutions, and the effect of rays on them.
std::string enclosure_text(const studies::radiosity::EnclosureRequest& request,
                           const studies::radiosity::EnclosureResults& results);

}  // namespace ff::reports

#pragma once

#include "reports/text/json_values.hpp"
#include "reports/words/heat_words.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ff::reports {

/// What `ffstudy heat` was asked, beside scene, request and cases.
struct HeatRequest {
    std::string materials;  ///< the text of the materials file
    double scale = 1;       ///< metres per unit of length of the scene
};

/// Records of heat.json and of the tables in CSV, with `low` and `high` of each quantity.
Json group_json(const studies::heat::GroupFlow& group);
Json flow_json(const std::string& name, const studies::heat::SolvedCase& solved, std::size_t face);

/// heat.json: the request, and for each case its balance, its certainty and its groups (docs/heat.md).
std::string heat_json(const HeatReport& report, const HeatRequest& request, const std::vector<std::string>& warnings);

}  // namespace ff::reports

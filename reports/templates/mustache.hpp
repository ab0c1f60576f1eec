#pragma once

#include "reports/templates/templates.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace ff::reports {

/// Fills a mustache template: `{{name}}` is escaped, `{{{name}}}` is not, `{{>table}}` is the template table.mustache.
/// Objects, arrays, strings and booleans of `view` have their meaning in mustache; numbers have to be texts already.
/// @param escape  applied by `{{name}}` to a text
/// @throws UserError where the template is malformed or missing
std::string fill_template(const Templates& templates, std::string_view name, const nlohmann::ordered_json& view,
                          std::string (*escape)(const std::string&));

/// Escapes text of an HTML document, inside and outside attributes.
std::string escape_html(const std::string& text);

}  // namespace ff::reports

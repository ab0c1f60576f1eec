#pragma once

#include <initializer_list>
#include <string_view>

namespace ff {

/// A parameter of a configuration, as its formula's documentation names it.
struct Parameter {
    std::string_view name;
    long double value = 0;
};

/// @throws UserError where a parameter is not a positive, finite number
void expect_positive(std::string_view configuration, std::initializer_list<Parameter> parameters);

/// @throws UserError "CONFIGURATION: PROBLEM" unless `holds`
void expect_valid(bool holds, std::string_view configuration, std::string_view problem);

}  // namespace ff

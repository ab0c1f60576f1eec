#pragma once

#include "app/command_line/parser.hpp"

#include "core/configurations/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// A kind of thing that `ffstudy list` shows; options name it in capitals: --sampler SAMPLER.
struct ListedKind {
    std::string_view name;    ///< "sampler"
    std::string_view plural;  ///< "samplers"
};

std::vector<ListedKind> listed_kinds();

/// "samplers, estimators, scenes", for help and messages.
std::string listed_kinds_in_words();

/// @param plural of a kind @throws UserError where there is no such kind
std::vector<Listed> listed(std::string_view plural);

/// Possible values of options with this type: names for "SAMPLER", all for "NAME", kinds for "KIND".
std::vector<Listed> listed_for_type(std::string_view type);

/// "patch, face", for help.
std::string names_in_words(std::string_view plural);

/// A form factor with its reliable digits.
std::string exact_digits(const Configuration& configuration);

}  // namespace ff::app

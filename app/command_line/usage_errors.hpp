#pragma once

#include "app/command_line/command_model.hpp"

#include <string>
#include <vector>

namespace ff::app {

/// Why a command line was not parsed.
struct UsageFault {
    enum class Kind {
        unexpected,        ///< a word that nothing takes
        not_converted,     ///< a value of the wrong type
        missing,           ///< something that is required
        number_of_values,  ///< too few or too many of an option
        other,
    };
    Kind kind = Kind::other;
    std::string message;            ///< the parser's
    std::vector<std::string> rest;  ///< words that were not taken
};

/// What is wrong with a command line, in the form of every other message: problem (why). Suggestion.
/// @param command  that was given; program.program itself where there is none
std::string usage_problem(const ProgramModel& program, const CommandModel& command, const UsageFault& fault);

/// Rejects values that the parser accepts but nobody means: empty ones, which would silently select the default, and
/// negative counts, which would wrap around. @throws UserError
void refuse_unmeant_values(const OptionModel& option, const std::vector<std::string>& values);

}  // namespace ff::app

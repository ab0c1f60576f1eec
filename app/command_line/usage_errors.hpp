#pragma once

#include "app/command_line/parser.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// Says what is wrong with a command line in the form of every other message: problem (why). Suggestion.
struct UsageProblems {
    const ProgramModel& program;
    const CommandModel* command;  ///< the command that was given; null where there is none

    /// Words that no option or argument takes.
    [[nodiscard]] std::string unexpected(const std::vector<std::string>& words) const;
    // Errors that the parser reports:
    [[nodiscard]] std::string not_converted(std::string_view message) const;  ///< a value of the wrong type
    [[nodiscard]] std::string missing(std::string_view message) const;        ///< something that is required
    [[nodiscard]] std::string number_of_values(std::string_view message) const;
    [[nodiscard]] std::string other(std::string_view message) const;

  private:
    [[nodiscard]] std::string where_help_is() const;
    [[nodiscard]] std::string unknown(std::string_view what, const std::string& word,
                                      const std::vector<std::string>& names) const;
};

/// Rejects values that the parser accepts but nobody means: empty ones, which would silently select the default, and
/// negative counts, which would wrap around. @throws UserError
void refuse_unmeant_values(const OptionModel& option, const std::vector<std::string>& values);

}  // namespace ff::app

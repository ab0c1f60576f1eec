#pragma once

#include <stdexcept>
#include <utility>

#include <fmt/core.h>

namespace ff {

/// A message, or a format with its values.
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
    template <class... Values>
    requires(sizeof...(Values) > 0) explicit Error(fmt::format_string<Values...> text, Values&&... values)
        : runtime_error(fmt::format(text, std::forward<Values>(values)...)) {}
};

/// Input that the user can correct: a file, an option, a size. Exit code 2. The message has the form "place: problem
/// (why it is a problem). Suggestion."
class UserError : public Error {
    using Error::Error;
};

/// A file or folder that cannot be read or written. Exit code 3.
class IoError : public Error {
    using Error::Error;
};

/// Work that was stopped before there was anything to keep of it. Exit code 130.
class InterruptedError : public Error {
    using Error::Error;
};

}  // namespace ff

#pragma once

#include <stdexcept>

namespace ff {

/// Input that the user can correct: a file, an option, a size. Exit code 2. The message has the form "place: problem
/// (why it is a problem). Suggestion."
class UserError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file or folder that cannot be read or written. Exit code 3.
class IoError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Work that was stopped before there was anything to keep of it. Exit code 130.
class InterruptedError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace ff

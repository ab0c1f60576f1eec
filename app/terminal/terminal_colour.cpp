#include "app/terminal/terminal_colour.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace ff::app {
namespace {

std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    return value == nullptr ? std::string_view() : value;
}

}  // namespace

reports::Colour colour_of_stdout() {
    const bool wanted = ::isatty(STDOUT_FILENO) == 1 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
    return wanted ? reports::Colour::ansi : reports::Colour::none;
}

}  // namespace ff::app

#include "app/terminal/terminal_style.hpp"

#include <sys/ioctl.h>
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

reports::TextStyle style_of_stdout() {
    reports::TextStyle style;
    const bool coloured = ::isatty(STDOUT_FILENO) == 1 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
    if (coloured) style.colour = reports::Colour::ansi;
    style.width = width_of(STDOUT_FILENO);
    return style;
}

std::size_t width_of(int descriptor) {
    winsize size{};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how ioctl is called
    const bool known = ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : reports::TextStyle().width;
}

}  // namespace ff::app

#include "app/terminal/output.hpp"

#include "core/support/words.hpp"
#include "reports/text/folding.hpp"
#include "studies/readers/printable.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace ff::app {
namespace {

bool verbose = false;

std::string_view variable(const char* name) {
    const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
    return value == nullptr ? std::string_view() : value;
}

}  // namespace

std::string for_message(std::string_view text) {
    constexpr std::size_t most = 2000;
    constexpr std::size_t end = 600;  // a suggestion comes last
    if (text.size() <= most) return studies::visible_text(text);
    const auto within_a_character = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
    };
    std::size_t first = most - end;
    std::size_t last = text.size() - end;
    while (first > 0 && within_a_character(first)) --first;
    while (last < text.size() && within_a_character(last)) ++last;
    return studies::visible_text(text.substr(0, first)) + " … " + studies::visible_text(text.substr(last));
}

void say_folded(std::string_view text) {
    const bool is_folded = ::isatty(STDERR_FILENO) == 1 && !text.starts_with('\r');  // which begins a progress bar
    std::fputs((is_folded ? reports::folded(text, width_of(STDERR_FILENO)) : std::string(text)).c_str(), stderr);
}

void be_verbose() {
    verbose = true;
}

bool is_verbose() {
    return verbose;
}

void print_verbatim(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() || errno == EPIPE) return;
    throw std::system_error(errno, std::generic_category(), "standard output");
}

void print_folded(std::string_view text) {
    print_verbatim(reports::folded(text, width_of(STDOUT_FILENO)));
}

bool flush_output() {
    return std::fflush(stdout) == 0 || errno == EPIPE;
}

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
    if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    const std::size_t columns = parse_bare_number<std::size_t>(variable("COLUMNS")).value_or(0);
    return columns > 0 ? columns : reports::TextStyle().width;
}

}  // namespace ff::app

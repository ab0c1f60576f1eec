#include "app/terminal/output.hpp"

#include "app/terminal/terminal_style.hpp"
#include "reports/text/folding.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace ff::app {

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

}  // namespace ff::app

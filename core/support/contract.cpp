#include "core/support/contract.hpp"

#include <cstdio>
#include <cstdlib>

namespace ff {

void contract_violation(const char* kind, const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: contract violation: %s %s\n", file, line, kind, condition);
    std::abort();
}

}  // namespace ff

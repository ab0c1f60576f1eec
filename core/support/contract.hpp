#pragma once

/// Contracts: a failed one is a bug in the program, never bad input. They are compiled out unless FF_CONTRACTS is 1
/// (the `dev` preset). Bad input is reported with `ff::UserError` (core/support/error.hpp), always.

namespace ff {

/// Prints the broken condition to stderr and aborts.
[[noreturn]] void contract_violation(const char* kind, const char* condition, const char* file, int line);

}  // namespace ff

#if FF_CONTRACTS
#define FF_EXPECT(condition) \
    ((condition) ? static_cast<void>(0) : ::ff::contract_violation("expects", #condition, __FILE__, __LINE__))
#define FF_ENSURE(condition) \
    ((condition) ? static_cast<void>(0) : ::ff::contract_violation("ensures", #condition, __FILE__, __LINE__))
#else
#define FF_EXPECT(condition) static_cast<void>(sizeof(static_cast<bool>(condition)))
#define FF_ENSURE(condition) static_cast<void>(sizeof(static_cast<bool>(condition)))
#endif

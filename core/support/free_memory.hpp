#pragma once

namespace ff {

/// Hands memory that is no longer used back to the system, where the library can do that. After much of it was freed in
/// small pieces, else it stays with the process.
void return_free_memory();

}  // namespace ff

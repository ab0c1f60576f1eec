#pragma once

namespace ff {

/// Returns unused memory to the system, where the library can do that. To be called after many small pieces were freed,
/// which otherwise stay with the process.
void return_free_memory();

}  // namespace ff

#include "samplers/directions/local_directions.hpp"

namespace ff::samplers {

Stream stream_of_place(const Stream& stream, std::uint64_t place) {
    const Words words = philox(stream, static_cast<std::uint32_t>(place), Purpose::engine);
    return {.key = {words[0], words[1]}, .trial = stream.trial, .source = stream.source, .target = stream.target};
}

}  // namespace ff::samplers

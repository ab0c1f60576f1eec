#include "samplers/nets/sobol_raw.hpp"

#include "samplers/nets/boost_sequence.hpp"

#include <boost/random/sobol.hpp>

namespace ff::samplers {

void SobolRaw::fill(const Stream& /*stream*/, PointIndex first, PointBlock& block) const {
    fill_from_engine<boost::random::sobol>(first, block);
}

}  // namespace ff::samplers

#include "samplers/nets/niederreiter.hpp"

#include "samplers/nets/boost_sequence.hpp"

#include <boost/random/niederreiter_base2.hpp>

namespace ff::samplers {

void Niederreiter::fill(const Stream& /*stream*/, PointIndex first, PointBlock& block) const {
    fill_from_engine<boost::random::niederreiter_base2>(first, block);
}

}  // namespace ff::samplers

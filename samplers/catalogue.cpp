#include "samplers/sampler.hpp"

#include "core/contract.hpp"

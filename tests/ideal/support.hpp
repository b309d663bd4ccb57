// What the tests of ideals share: random ideals, and short names for making and describing them.
#pragma once

#include "support/random_ideals.hpp"

namespace eliminant::ideal {

using testing::describe;
using testing::for_random_pairs;
using testing::ideal_of;
using testing::number;
using testing::Random;
using testing::random_ideal;
using testing::random_small;
using testing::variables;

} // namespace eliminant::ideal

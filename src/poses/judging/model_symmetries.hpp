#pragma once
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::poses {

/// Everything that maps a model to itself, the identity first: its discrete symmetries (and the identity), each
/// followed by every turn about one of its axes, in 315 steps. As bop_toolkit with max_sym_disc_step = 0.01: a point of
/// an object of diameter d goes round in at most pi d, and 315 = ceil(pi / 0.01), so a step takes it 0.01 d at most.
/// Older versions of the toolkit leave the unturned model out; here a perfect estimate has no error.
std::vector<Pose> symmetries_of(bop::ObjectModel const& model);

}  // namespace faster::poses

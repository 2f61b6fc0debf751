#pragma once
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// Lengths of a dataset that look as if they were in another unit than is read: each a line in the warnings.

/// Half of the true poses are nearer than a hand's breadth, or farther than a street is long. `place`: file and key, of
/// numbers that count `unit_m`, 1 or 0.001 metres.
void tell_of_translations(Dataset& dataset, std::string const& place, double unit_m);

/// A mesh [m] of which no models_info.json tells how large it is.
void tell_of_length(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings);

}  // namespace faster::bop

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

/// Compares a mesh [m] with what models_info.json says of it. Half or twice as large contradicts: throws InputError
/// that names both, the ratio, and what would mend it if it is that of another unit. What is off by more than a tenth
/// is another mesh, about other axes, or moved: a line in `warnings`. Nothing is said of what the file does not say.
void compare_with_info(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings);

}  // namespace faster::bop

#pragma once
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// Compares a mesh [m] with what models_info.json says of it. Half or twice as large contradicts: throws InputError
/// that names both, the ratio, and what would mend it if it is that of another unit. What is off by more than a tenth
/// is another mesh, about other axes, or moved: a line in `warnings`. Nothing is said of what the file does not say.
void compare_with_info(Mesh const& mesh, ObjectModel const& model, std::vector<std::string>& warnings);

}  // namespace faster::bop

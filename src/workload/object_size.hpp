#pragma once
#include <string>

#include "common/mesh.hpp"

namespace faster::workload {

/// The longest side of the box around a mesh [m].
double longest_side_m(Mesh const& mesh);

/// What is wrong with the size of the object of a mesh file, for people; empty if nothing is. A camera of 3 m range
/// sees objects that are hand-sized: one of 10 m is one of 1 cm at least whose file is in millimetres.
std::string size_warning(Mesh const& mesh, std::string const& file);

}  // namespace faster::workload

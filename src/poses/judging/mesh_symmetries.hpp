#pragma once
#include "faster/data/mesh.hpp"
#include "poses/bop/dataset.hpp"

namespace faster::poses {

/// A model with the turns that map its mesh nearly to itself, for an object of which no models_info.json says any: no
/// point of the surface comes to lie farther than 0.05 diameters from it. (BOP took 0.1 diameters, or 15 mm, and then
/// looked at every object.) Looked for about axes through the middle of the surface: its principal axes, x, y and z.
/// Any turn about an axis of which each 16th of a turn does; without such an axis, about each the most of 6 to 2 equal
/// steps that do; and half turns across the first axis found, every 7.5 degrees. With all that follow from them, at
/// most 60.
bop::ObjectModel with_symmetries_of_mesh(bop::ObjectModel model, Mesh const& mesh);

}  // namespace faster::poses

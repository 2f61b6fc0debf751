#pragma once
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

/// Meshes of the 21 YCB classes without any file: shapes made by code, as large as the scanned objects.
///
/// Object frame: origin at the centre of the bounding box, metres, axes as in the YCB scans (z up as the object lay on
/// the turntable). Where the scan stood askew the object is turned about z into its smallest box, its long side along
/// the axis nearest to the scan's: mustard_bottle, bleach_cleanser, potted_meat_can, mug and extra_large_clamp are long
/// in x; pudding_box, gelatin_box, banana, power_drill, scissors, large_marker, large_clamp and foam_brick in y.
///
/// Each mesh has about 1,200 triangles of similar size, like a simplified scan. It is one or several closed components
/// that face outwards; components (the handle of the mug) may run into each other. pitcher_base is open and hollow; its
/// scan wears a lid.
namespace faster::models {

/// Class names without the YCB number ("banana"), sorted.
std::vector<std::string> names();

bool contains(std::string const& name);

/// The mesh of a class, equal at every call. Throws InputError for a name that is not in names().
Mesh make(std::string const& name);

}  // namespace faster::models

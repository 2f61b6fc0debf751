#pragma once
#include "common/map_clearing.hpp"

namespace faster {

/// How the sweep gets at the four neighbours of a pixel; key `accelerator.inlier_unit.neighbour_access`.
enum class NeighbourAccess {
    direct,  ///< reads all five from the depth buffer: thesis A.3
    window,  ///< reads each pixel once, and keeps the last two rows in line buffers
};

/// The inlier unit's memory accesses; keys `accelerator.inlier_unit.*`. None of them changes a result.
struct InlierUnitConfig {
    NeighbourAccess neighbour_access = NeighbourAccess::direct;
    MapClearing clearing = MapClearing::loop;
    int sweep_lanes = 1;  ///< pixels of a row that an iteration of the loops behind the drawing takes, >= 1
};

}  // namespace faster

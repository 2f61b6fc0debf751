#pragma once
#include "faster/config/map_clearing.hpp"

namespace faster {

/// How the sweep gets at the four neighbours of a pixel; key `accelerator.inlier_unit.neighbour_access`.
enum class NeighbourAccess {
    direct,  ///< reads all five from the depth buffer: thesis A.3
    window,  ///< reads each pixel once, and keeps the last two rows in line buffers
};

/// How many loops take the fragments of a sample; key `accelerator.inlier_unit.fragment_loop`.
enum class FragmentLoop {
    per_triangle,  ///< one for each triangle, which drains before the next reciprocal is read: thesis A.3
    flattened,     ///< one over all commands: an iteration whose command is Triangle reads the reciprocal
};

/// Which pixels the loops behind the drawing go over; key `accelerator.inlier_unit.sweep_region`.
enum class SweepRegion {
    window,   ///< all of them: thesis A.2, A.3
    touched,  ///< the box of those that the sample's tokens can have changed
};

/// What the sweep makes of drawn pixels in front of which something was measured; key
/// `accelerator.inlier_unit.hidden`.
enum class HiddenPixels {
    ignored,  ///< they are pixels that do not agree: thesis A.3
    counted,  ///< counts them, and has the box of all others
};

/// The inlier unit's loops, memory accesses and counters; keys `accelerator.inlier_unit.*`. None of them changes a
/// counter that the thesis has.
struct InlierUnitConfig {
    NeighbourAccess neighbour_access = NeighbourAccess::direct;
    MapClearing clearing = MapClearing::loop;
    FragmentLoop fragment_loop = FragmentLoop::per_triangle;
    int buffers = 1;      ///< depth buffers, 1 or 2; 2: one is swept by a process of its own
    int sweep_lanes = 1;  ///< pixels of a row that an iteration of the loops behind the drawing takes, >= 1
    SweepRegion sweep_region = SweepRegion::window;
    HiddenPixels hidden = HiddenPixels::ignored;
};

inline bool counts_hidden(InlierUnitConfig const& unit) { return unit.hidden == HiddenPixels::counted; }

}  // namespace faster

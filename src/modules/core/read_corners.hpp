#pragma once
#include "channels/process_clock.hpp"
#include "faster/data/pixel_box.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// The two corners of a region, told a step each; `read` reads one. `site`: where deadlock reports say the process is.
template <class Read> Corners read_corners(ProcessClock& clock, Read read, SourceSite site = SourceSite::here()) {
    Corners corners;
    for (FragmentIndex* const corner : {&corners.first, &corners.last}) {
        clock.here(site);
        *corner = read();
        clock.advance(1);
    }
    return corners;
}

}  // namespace faster

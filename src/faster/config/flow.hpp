#pragma once

namespace faster {

/// How contours get into the score; key `accelerator.flow`.
enum class Flow {
    faster,     ///< while triangles are drawn: edge tokens become an edge map (the thesis's FASTER)
    fpga_grip,  ///< afterwards: eq. 2.2 on the finished depth buffer (the thesis's baseline FPGA_GRIP)
};

}  // namespace faster

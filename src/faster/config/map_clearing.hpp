#pragma once

namespace faster {

/// How a memory that every sample begins with afresh gets its first values; keys `accelerator.*.clearing`.
enum class MapClearing {
    loop,         ///< a loop of its own before the sample, a word per iteration: thesis A.2, A.3
    on_read_out,  ///< the loop that reads it out writes them behind itself, for the next sample
    wide,         ///< a loop like the first, but a word of every bank per iteration
};

}  // namespace faster

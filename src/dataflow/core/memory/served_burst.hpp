#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// When what happened to a burst (docs/memory-model.md).
struct ServedBurst {
    Cycles asked = 0;
    Cycles arrived = 0;        ///< at the controller
    Picoseconds begin_ps = 0;  ///< there
    Picoseconds end_ps = 0;    ///< granules it takes included
    Cycles first_beat = 0;     ///< of a read, at its port; of a write, its acknowledgement
    std::uint64_t beats = 0;
    std::size_t port = 0;
    bool is_write = false;  ///< takes no beats of the port

    /// The cycle after it is done.
    Cycles end() const { return first_beat + (is_write ? 1 : beats); }
};

}  // namespace dataflow::timing

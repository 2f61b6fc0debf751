#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/cycles.hpp"

namespace dataflow::recording {

/// Which part of a run is wanted. Without anything: all of it.
struct RecordingWindow {
    Cycles from = 0;
    std::optional<Cycles> to;  ///< the last cycle
    struct Samples {
        std::size_t first = 0;
        std::size_t last = 0;
    };
    /// Instead of cycles: from the begin of the first sample of these that a core scores to the end of its last.
    std::optional<Samples> samples;
    std::vector<std::size_t> cores;  ///< empty: all

    /// Of a core's samples those that are wanted.
    CoreShare wanted_of(CoreShare const& share) const {
        if (!samples)
            return share;
        std::size_t const first = std::max(share.first, samples->first);
        std::size_t const end = std::min(share.first + share.count, samples->last + 1);
        return {first, end > first ? end - first : 0};
    }
};

}  // namespace dataflow::recording

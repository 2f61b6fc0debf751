#pragma once
#include <optional>
#include <string>

#include "faster/machine.hpp"

namespace faster {

/// Names of the patterned keys; `field` is the last part, e.g. "depth".
inline std::string fifo_key_name(FifoId id, std::string const& field) {
    return std::string("accelerator.fifos.") + name_of(id) + '.' + field;
}

inline std::string loop_key_name(LoopId id, std::string const& field) {
    LoopName const& loop = loop_names[index_of(configured_as(id))];
    return std::string("accelerator.loops.") + name_of(loop.module) + '.' + loop.name + '.' + field;
}

inline std::string bram_key_name(BramId id, std::string const& field) {
    return std::string("accelerator.brams.") + name_of(id) + '.' + field;
}

/// The loop whose depth bounds the write latency of a FIFO (SPEC section 3); none for a FIFO that is not written in a
/// loop and for area_reciprocal, whose flushing pipeline is as deep as its write latency says.
inline std::optional<LoopId> loop_that_writes(FifoId id) {
    switch (id) {
        case FifoId::vertex:
            return LoopId::vertex;
        case FifoId::command:
        case FifoId::fragment_depth:
        case FifoId::fragment_index:
        case FifoId::edge_token:
            return LoopId::scan;
        case FifoId::edge_map:
            return LoopId::output;
        case FifoId::observed_depth:
        case FifoId::observed_edge:
            return LoopId::read;
        default:
            return std::nullopt;
    }
}

inline bool has_write_latency(FifoId id) { return id == FifoId::area_reciprocal || loop_that_writes(id).has_value(); }

}  // namespace faster

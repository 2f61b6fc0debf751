#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow::recording {

/// Something that a process did, as it is taken down. Its own cycles never go back.
struct Event {
    enum class Kind : std::uint8_t {
        enter,         ///< a loop; item: its number in the machine
        leave,         ///< the loop it is in
        iterate,       ///< `count` iterations begin, numbered from `value`, `stride` cycles apart
        at_iteration,  ///< number `value` began last, before anything was taken down
        stall,         ///< for the FIFO `item`, or memory, if there is no such FIFO, until cycle `value`
        resume,        ///< made from a stall: its end
        read,          ///< a token from FIFO `item`
        write,         ///< a token into FIFO `item`; `value` is its first field, further fields follow
        field,         ///< a further field of the token just written
        begin,         ///< of sample number `value`
        end,           ///< of sample number `value`
    };
    Cycles cycle = 0;
    std::int64_t value = 0;
    std::uint64_t count = 0;
    std::uint32_t stride = 0;
    Kind kind = Kind::read;
    std::uint32_t item = 0;
};

/// Its value is a cycle or a number, or of a token, which may be negative.
template <class Value = int> Event event_at(Cycles cycle, Event::Kind kind, std::uint32_t item = 0, Value value = 0) {
    Event event;
    event.cycle = cycle;
    event.kind = kind;
    event.item = item;
    event.value = static_cast<std::int64_t>(value);
    return event;
}

/// The fields of a token, in the order of its layout.
using TokenValues = std::vector<std::int64_t>;

}  // namespace dataflow::recording

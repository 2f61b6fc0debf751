#include "dataflow/core/time/fifo_timing.hpp"

#include <stdexcept>
#include <utility>

namespace dataflow::timing {

namespace {
std::uint64_t room_kept(FifoShape const& shape) {
    constexpr std::uint64_t kept_at_first = (1U << 10) - 1;
    return shape.is_unlimited() ? kept_at_first : FifoRules<CycleRing>::room_of(shape);
}
}  // namespace

FifoTiming::FifoTiming(FifoShape shape) : shape_(std::move(shape)), rules_(shape_, room_kept(shape_)) {
    if (is_unlimited()) {
        max_occupancy_ = shape_.capacity;
        rules_.free.be_endless(rules_.room);
    } else {
        rules_.free.begin_with(rules_.room);
    }
}

/// What is read has no writer whose room decides anything: the line of room tells when tokens were taken.
FifoTiming FifoTiming::of_memory(std::string name, bool writes) {
    FifoShape shape;
    shape.name = std::move(name);
    shape.capacity = FifoShape::unlimited;
    FifoTiming timing(shape);
    timing.is_stream_ = true;
    if (!writes)
        timing.rules_.free = CycleRing(room_kept(shape));
    return timing;
}

void FifoTiming::make_room() {
    rules_.readable.grow();
    rules_.free.grow();
    rules_.room = 2 * rules_.room + 1;
}

void FifoTiming::keep_more() {
    if (!is_unlimited())
        throw std::logic_error(name() + ": only an unlimited FIFO keeps more");
    make_room();
    rules_.free.be_endless(rules_.room - known_reads());
}

void FifoTiming::look_at_writes(std::uint64_t first) {
    for (std::uint64_t write = first; write != 0; ++write)
        max_occupancy_ = rules_.raised_by_write(max_occupancy_, written(write), known_writes() - write,
                                                [this, write](std::uint64_t i) { return rules_.free[write + i]; });
}

void FifoTiming::look_at_reads(std::uint64_t first) {
    for (std::uint64_t read = first; read != 0; ++read)
        max_occupancy_ = rules_.raised_by_read(
            max_occupancy_, rules_.free[known_writes() + read] - rules_.later_than_read, known_reads() - read,
            [this, read](std::uint64_t i) { return rules_.readable[read + i]; });
}

}  // namespace dataflow::timing

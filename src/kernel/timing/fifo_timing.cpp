#include "kernel/timing/fifo_timing.hpp"

#include <stdexcept>
#include <utility>

namespace faster::timing {

namespace {
std::uint64_t power_of_two_above(std::uint64_t value) {
    std::uint64_t power = 1;
    while (power <= value)
        power *= 2;
    return power;
}

std::uint64_t room_of(FifoShape const& shape) {
    constexpr std::uint64_t kept_at_first = (1U << 10) - 1;
    return shape.is_unlimited() ? kept_at_first : shape.capacity + shape.issue_latency;
}
}  // namespace

FifoTiming::FifoTiming(FifoShape shape)
    : shape_(std::move(shape)),
      room_(room_of(shape_)),
      index_mask_(power_of_two_above(room_) - 1),
      freed_at_(is_unlimited() ? index_mask_ + 1 : 0),
      max_occupancy_(is_unlimited() ? shape_.capacity : 0),
      readable_from_(index_mask_ + 1, 0),
      free_from_(freed_at_ + index_mask_ + 1, 0) {}

void FifoTiming::keep_more() {
    if (!is_unlimited())
        throw std::logic_error(name() + ": only an unlimited FIFO keeps more");
    std::vector<Cycles> const before = std::move(readable_from_);
    std::uint64_t const mask_before = index_mask_;
    room_ = 2 * room_ + 1;
    index_mask_ = room_;
    freed_at_ = index_mask_ + 1;
    readable_from_.assign(index_mask_ + 1, 0);
    free_from_.assign(freed_at_ + index_mask_ + 1, 0);
    for (std::uint64_t token = reads_; token != writes_; ++token)
        readable_from_[token & index_mask_] = before[token & mask_before];
}

}  // namespace faster::timing

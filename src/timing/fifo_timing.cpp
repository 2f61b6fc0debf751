#include "timing/fifo_timing.hpp"

#include <utility>

namespace faster::timing {

namespace {
std::uint64_t power_of_two_above(std::uint64_t value) {
    std::uint64_t power = 1;
    while (power <= value)
        power *= 2;
    return power;
}
}  // namespace

FifoTiming::FifoTiming(FifoShape shape)
    : shape_(std::move(shape)),
      room_(shape_.capacity + shape_.issue_latency),
      index_mask_(power_of_two_above(room_) - 1),
      readable_from_(index_mask_ + 1, 0),
      free_from_(index_mask_ + 1, 0) {}

}  // namespace faster::timing

#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "config/accelerator_config.hpp"
#include "recording/event_merge.hpp"
#include "timing/fifo_timing.hpp"

namespace faster::recording {

/// The tokens in one FIFO, as events put them in and take them out. A token of a flushing pipeline arrives
/// issue_latency cycles after it was written.
class FifoState {
  public:
    explicit FifoState(timing::FifoShape const& shape) : shape_(&shape) {}

    void write(TokenValues const& fields) { tokens_.push_back(fields); }
    void arrive() { ++arrived_; }
    /// Takes the oldest token out.
    TokenValues read() {
        TokenValues const token = tokens_.front();
        tokens_.pop_front();
        --arrived_;
        return token;
    }
    /// Tokens written and not read (SPEC section 3: at most the capacity).
    std::uint64_t occupancy() const { return std::min<std::uint64_t>(arrived_, shape_->capacity); }
    timing::FifoShape const& shape() const { return *shape_; }

  private:
    timing::FifoShape const* shape_;
    std::deque<TokenValues> tokens_;
    std::uint64_t arrived_ = 0;
};

}  // namespace faster::recording

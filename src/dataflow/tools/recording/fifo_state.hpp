#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/tools/recording/event.hpp"

namespace dataflow::recording {

/// The tokens in one FIFO, as events put them in and take them out. A token of a flushing pipeline arrives
/// issue_latency cycles after it was written.
class FifoState {
  public:
    explicit FifoState(timing::FifoShape const& shape) : shape_(&shape) {}

    void write(TokenValues const& fields) {
        fields_ = static_cast<std::ptrdiff_t>(fields.size());
        values_.insert(values_.end(), fields.begin(), fields.end());
    }
    void arrive() { ++arrived_; }
    /// Takes the oldest token out.
    void read(TokenValues& fields) {
        fields.assign(values_.begin(), values_.begin() + fields_);
        values_.erase(values_.begin(), values_.begin() + fields_);
        --arrived_;
    }
    /// Tokens written and not read (docs/timing-model.md#fifos: at most the capacity).
    std::uint64_t occupancy() const { return std::min<std::uint64_t>(arrived_, shape_->capacity); }
    timing::FifoShape const& shape() const { return *shape_; }

  private:
    timing::FifoShape const* shape_;
    std::ptrdiff_t fields_ = 0;        ///< of a token
    std::deque<std::int64_t> values_;  ///< field by field, token by token
    std::uint64_t arrived_ = 0;
};

}  // namespace dataflow::recording

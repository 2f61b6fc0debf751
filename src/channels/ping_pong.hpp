#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "channels/fifo_channel.hpp"
#include "channels/process_clock.hpp"

namespace dataflow {

/// Ping-pong buffers between two modules: FifoEnd::hands_over(). In each of its calls the writer puts what it has
/// filled a buffer with, whenever it likes, and the reader takes it. That takes no time: the reader's call begins when
/// the writer's is over, and the writer's waits for a buffer that is free.
///   errors  InputError for a call that fills, or empties, none or two
///
///     PingPong<int> rows_{"rows", ping_pong_timing("rows")};     in the core
///     core.ping_pong<int>("rows").put(std::move(words));         in its modules
template <class Word> class PingPong final : public FifoChannel {
  public:
    using FifoChannel::FifoChannel;

    void put(std::vector<Word> words) {
        writer_->require_own(*this, true);
        if (std::exchange(is_filled_, true))
            refuse(*writer_, " fills ", " twice in a call, expected put() once");
        while (buffers_.size() > most_ahead())
            writer_->wait_for_room(*this);
        buffers_.push_back(std::move(words));
        wake_reader();
    }
    std::vector<Word> take() {
        reader_->require_own(*this, false);
        if (std::exchange(is_emptied_, true))
            refuse(*reader_, " empties ", " twice in a call, expected take() once");
        while (buffers_.empty())
            reader_->wait_for_tokens(*this);
        std::vector<Word> words = std::move(buffers_.front());
        buffers_.pop_front();
        wake_writer();
        return words;
    }
    std::vector<TokenField> token_fields() const override { return {}; }

  private:
    void end_call(bool of_writer) override {
        if (of_writer && !std::exchange(is_filled_, false))
            refuse(*writer_, " ends a call without filling ", ", expected put() once");
        if (!of_writer && !std::exchange(is_emptied_, false))
            refuse(*reader_, " ends a call without emptying ", ", expected take() once");
    }
    [[noreturn]] void refuse(ProcessClock const& module, char const* does, char const* expected) const {
        throw InputError("module " + module.timing().name() + does + "the ping-pong buffer " + basename() + expected);
    }
    /// As many as the modelled buffers, or the host would add stalls of its own.
    std::size_t most_ahead() { return std::max<std::uint64_t>(64, timing().shape().capacity); }

    std::deque<std::vector<Word>> buffers_;
    bool is_filled_ = false, is_emptied_ = false;  ///< in the call at hand
};

}  // namespace dataflow

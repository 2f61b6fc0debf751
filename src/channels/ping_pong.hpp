#pragma once
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "channels/fifo_channel.hpp"
#include "channels/process_clock.hpp"

namespace dataflow {

/// Ping-pong buffers between two modules: FifoEnd::hands_over(). In each of its calls the writer puts what it has
/// filled a buffer with, whenever it likes, and the reader takes it. That takes no time: the reader's call begins when
/// the writer's is over, and the writer's waits for a buffer that is free.
///
///     PingPong<int> rows_{"rows", ping_pong_timing("rows")};     in the core
///     core.ping_pong<int>("rows").put(std::move(words));         in its modules
template <class Word> class PingPong final : public FifoChannel {
  public:
    using FifoChannel::FifoChannel;

    void put(std::vector<Word> words) {
        writer_->require_own(*this, true);
        while (buffers_.size() > most_ahead)
            writer_->wait_for_room(*this);
        buffers_.push_back(std::move(words));
        wake_reader();
    }
    std::vector<Word> take() {
        reader_->require_own(*this, false);
        while (buffers_.empty())
            reader_->wait_for_tokens(*this);
        std::vector<Word> words = std::move(buffers_.front());
        buffers_.pop_front();
        wake_writer();
        return words;
    }
    std::vector<TokenField> token_fields() const override { return {}; }

  private:
    static constexpr std::size_t most_ahead = 64;

    std::deque<std::vector<Word>> buffers_;
};

}  // namespace dataflow

#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace dataflow {

/// The tokens on their way through a channel, as the host holds them: contiguous for both sides, so that bursts are
/// plain array accesses. A token is `width` values side by side, one unless told otherwise; counts are of tokens. Knows
/// no time and no limit.
template <class Token> class TokenQueue {
  public:
    explicit TokenQueue(std::size_t width = 1) : width_(width) {}

    std::size_t width() const { return width_; }
    std::size_t size() const { return size_; }

    /// Room for `count` more tokens behind the last; valid until the next call, whatever is dropped meanwhile. append()
    /// makes them part of the queue.
    Token* room(std::size_t count) {
        if (head_ == tail_)
            head_ = tail_ = 0;
        if (tail_ + count * width_ > tokens_.size())
            make_room(count * width_);
        return tokens_.data() + tail_;
    }
    void append(std::size_t count) {
        tail_ += count * width_;
        size_ += count;
    }

    Token const* end() const { return tokens_.data() + tail_; }
    Token const* front() const { return tokens_.data() + head_; }
    void drop(std::size_t count) {
        head_ += count * width_;
        size_ -= count;
    }

  private:
    [[gnu::noinline]] void make_room(std::size_t values) {
        std::copy(tokens_.begin() + static_cast<std::ptrdiff_t>(head_),
                  tokens_.begin() + static_cast<std::ptrdiff_t>(tail_), tokens_.begin());
        tail_ -= head_;
        head_ = 0;
        if (tail_ + values > tokens_.size())
            tokens_.resize(std::max(tail_ + values, 2 * tokens_.size()));
    }

    std::size_t width_;
    std::vector<Token> tokens_;
    std::size_t size_ = 0;
    std::size_t head_ = 0;
    std::size_t tail_ = 0;
};

}  // namespace dataflow

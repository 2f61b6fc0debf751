#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace faster {

/// The tokens on their way through a channel, as the host holds them: contiguous for both sides, so that bursts are
/// plain array accesses. Knows no time and no limit.
template <class Token> class TokenQueue {
  public:
    std::size_t size() const { return tail_ - head_; }

    /// Room for `count` more tokens behind the last; valid until the next call, whatever is dropped meanwhile. append()
    /// makes them part of the queue.
    Token* room(std::size_t count) {
        if (head_ == tail_)
            head_ = tail_ = 0;
        if (tail_ + count > tokens_.size())
            make_room(count);
        return tokens_.data() + tail_;
    }
    void append(std::size_t count) { tail_ += count; }

    Token const* end() const { return tokens_.data() + tail_; }
    Token const* front() const { return tokens_.data() + head_; }
    void drop(std::size_t count) { head_ += count; }

  private:
    void make_room(std::size_t count) {
        std::copy(tokens_.begin() + static_cast<std::ptrdiff_t>(head_),
                  tokens_.begin() + static_cast<std::ptrdiff_t>(tail_), tokens_.begin());
        tail_ -= head_;
        head_ = 0;
        if (tail_ + count > tokens_.size())
            tokens_.resize(std::max(tail_ + count, 2 * tokens_.size()));
    }

    std::vector<Token> tokens_;
    std::size_t head_ = 0;
    std::size_t tail_ = 0;
};

}  // namespace faster

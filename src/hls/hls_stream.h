#pragma once
// hls::stream by the names of Vivado HLS and Vitis HLS, for functions that are written for these tools. Untimed it is a
// queue without end, as in C simulation; as a member of an HlsDesign it is a FIFO whose accesses get cycles.
#define FASTER_HLS_STREAM 1
#include <cstddef>
#include <deque>
#include <iostream>
#include <sstream>  // the tools' has it, and some rely on that
#include <string>
#include <utility>

#include "observer.hpp"
#include "token_traits.hpp"

namespace hls {

template <class Token, int depth_of_fifo = 0> class stream;  // NOLINT(readability-identifier-naming): as the tool has it

template <class Token> class stream<Token, 0> : public dataflow::untimed::StreamBase {
    using Traits = dataflow::untimed::TokenTraits<Token>;

  public:
    using value_type = Token;  // NOLINT(readability-identifier-naming): as containers have it

    explicit stream(std::string name = {}) : StreamBase(std::move(name)) {}

    /// From an empty stream that no design has: a warning, and a token of zeros, as in C simulation.
    Token read() {
        if (auto* const watching = watcher())
            watching->reads(*this);
        if (tokens_.empty()) {
            std::cerr << "WARNING: hls::stream '" << name() << "' is read while empty\n";
            return Token();
        }
        return take();
    }
    void read(Token& token) { token = read(); }
    void write(Token const& token) {
        tokens_.push_back(token);
        if (auto* const watching = watcher())
            watching->wrote(*this);
    }
    stream& operator>>(Token& token) {
        read(token);
        return *this;
    }
    stream& operator<<(Token const& token) {
        write(token);
        return *this;
    }

    bool read_nb(Token& token) {
        bool const is_there = finds({false, false}, !tokens_.empty());
        if (is_there)
            token = take();
        return is_there;
    }
    bool write_nb(Token const& token) {
        bool const is_room = finds({true, false, Traits::shown(token)}, true);
        if (is_room)
            tokens_.push_back(token);
        return is_room;
    }
    bool empty() const { return !finds({false, true}, !tokens_.empty()); }
    bool full() const { return !finds({true, true}, true); }
    std::size_t size() const {
        if (auto* const watching = watcher())
            watching->asks_size(*this);
        return tokens_.size();
    }
    /// What its type says, 2 where it says nothing; the untimed queue has no end.
    std::size_t capacity() const { return depth() > 0 ? depth() : 2; }

    bool has_token() const override { return !tokens_.empty(); }
    unsigned bits() const override { return Traits::bits(); }
    bool is_signed() const override { return Traits::is_signed(); }
    std::int64_t shown_last() const override { return Traits::shown(tokens_.back()); }

  private:
    Token take() {
        Token token = std::move(tokens_.front());
        tokens_.pop_front();
        return token;
    }
    bool finds(dataflow::untimed::Attempt const& attempt, bool untimed) const {
        auto* const watching = watcher();
        return watching != nullptr ? watching->attempts(*this, attempt) : untimed;
    }

    std::deque<Token> tokens_;
};

template <class Token, int depth_of_fifo> class stream : public stream<Token, 0> {
  public:
    explicit stream(std::string name = {}) : stream<Token, 0>(std::move(name)) { this->set_depth(depth_of_fifo); }
};

}  // namespace hls

#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "dataflow/base/token_field.hpp"

namespace dataflow::recording {

/// The tokens that went through a FIFO, as plain numbers, from the first that anybody still asks for.
class TokenTap {
  public:
    /// To be told of the FIFO's first token on.
    explicit TokenTap(std::vector<TokenField> layout) : layout_(std::move(layout)) {}

    std::vector<TokenField> const& layout() const { return layout_; }
    /// Where the fields of the next `count` tokens are to be put, token by token.
    std::int64_t* room(std::size_t count) {
        values_.resize(values_.size() + count * layout_.size());
        return values_.data() + values_.size() - count * layout_.size();
    }
    /// The fields of token `number`.
    std::int64_t const* token(std::uint64_t number) const {
        return values_.data() + (number - first_) * layout_.size();
    }
    /// No one will ask for tokens below `number` any more.
    void forget_before(std::uint64_t number) {
        if (number - first_ < forget_at_once)
            return;
        values_.erase(values_.begin(),
                      values_.begin() + static_cast<std::ptrdiff_t>((number - first_) * layout_.size()));
        first_ = number;
    }

  private:
    static constexpr std::uint64_t forget_at_once = 4096;  // tokens: moving the rest has a price

    std::vector<TokenField> layout_;
    std::uint64_t first_ = 0;
    std::vector<std::int64_t> values_;
};

}  // namespace dataflow::recording

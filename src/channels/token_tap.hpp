#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "common/token_fields.hpp"

namespace faster {

/// The tokens that went through a channel, as plain numbers, from the first that anybody still asks for.
class TokenTap {
  public:
    /// To be told of the channel's first token on.
    explicit TokenTap(std::vector<TokenField> layout) : layout_(std::move(layout)) {}

    std::vector<TokenField> const& layout() const { return layout_; }
    void record(std::int64_t const* values) { values_.insert(values_.end(), values, values + layout_.size()); }
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

}  // namespace faster

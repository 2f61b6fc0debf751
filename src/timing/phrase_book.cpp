#include "timing/phrase_book.hpp"

#include <algorithm>

namespace faster::timing {

PhraseBook::Number PhraseBook::number_of(Phrase const& phrase, Group const& group) {
    std::uint64_t hash = phrase.size();
    for (unsigned i = 0; i < phrase.size(); ++i) {
        hash = (hash ^ phrase.codes()[i]) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
    }
    auto const [first, last] = by_hash_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (entries_[known->second].size == phrase.size() &&
            std::equal(phrase.codes(), phrase.codes() + phrase.size(), codes(known->second)))
            return known->second;
    Entry entry{static_cast<std::uint32_t>(codes_.size()), phrase.size(), phrase.active(), 0, 0, 0};
    if (group.has_supplier())
        entry.due = static_cast<std::uint32_t>((phrase.due() >> (Group::lane_bits * (group.supplier() - 1))) &
                                               Group::lane_mask);
    codes_.insert(codes_.end(), phrase.codes(), phrase.codes() + phrase.size());
    entries_.push_back(entry);
    auto const number = static_cast<Number>(entries_.size() - 1);
    by_hash_.emplace(hash, number);
    return number;
}

void PhraseBook::set_pieces(Number number, std::vector<Number> const& pieces) {
    entries_[number].first_piece = static_cast<std::uint32_t>(pieces_.size());
    entries_[number].pieces = static_cast<std::uint32_t>(pieces.size());
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
}

}  // namespace faster::timing

#include "timing/phrase_book.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
/// Two codes at a time go into a product of 128 bits, with what came before.
std::uint64_t hash_of(Phrase const& phrase) {
    __extension__ using Wide = unsigned __int128;
    std::uint64_t hash = phrase.size();
    for (unsigned i = 0; i < phrase.size(); i += 2) {
        std::uint64_t const second = i + 1 < phrase.size() ? phrase.codes()[i + 1] : 0;
        Wide const product = Wide{phrase.codes()[i] ^ hash ^ 0x9E3779B97F4A7C15U} * (second ^ 0xD6E8FEB86659FD93U);
        hash = static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
    }
    return hash;
}
}  // namespace

PhraseBook::Number PhraseBook::number_of(Phrase const& phrase, Group const& group) {
    std::uint64_t const hash = hash_of(phrase);
    std::size_t const place = place_of(phrase, hash);
    if (places_[place].number != none)
        return places_[place].number;
    Entry entry{static_cast<std::uint32_t>(codes_.size()), phrase.size(), phrase.active(), 0, 0, 0};
    if (group.has_supplier())
        entry.due = static_cast<std::uint32_t>((phrase.due() >> (Group::lane_bits * (group.supplier() - 1))) &
                                               Group::lane_mask);
    codes_.insert(codes_.end(), phrase.codes(), phrase.codes() + phrase.size());
    entries_.push_back(entry);
    auto const number = static_cast<Number>(entries_.size() - 1);
    places_[place] = {hash, number};
    if (2 * entries_.size() > places_.size())
        grow();
    return number;
}

std::optional<PhraseBook::Number> PhraseBook::find(Phrase const& phrase) const {
    Number const number = places_[place_of(phrase, hash_of(phrase))].number;
    return number == none ? std::nullopt : std::optional<Number>(number);
}

/// Where it is, or has to be put.
std::size_t PhraseBook::place_of(Phrase const& phrase, std::uint64_t hash) const {
    std::size_t const mask = places_.size() - 1;
    std::size_t place = hash & mask;
    while (places_[place].number != none && !(places_[place].hash == hash && is(places_[place].number, phrase)))
        place = (place + 1) & mask;
    return place;
}

bool PhraseBook::is(Number number, Phrase const& phrase) const {
    Phrase::Code const* const known = codes(number);
    bool equal = entries_[number].size == phrase.size();
    for (unsigned i = 0; equal && i < phrase.size(); ++i)
        equal = known[i] == phrase.codes()[i];
    return equal;
}

void PhraseBook::grow() {
    std::vector<Place> old(2 * places_.size());
    old.swap(places_);
    for (Place const& known : old) {
        std::size_t place = known.hash & (places_.size() - 1);
        while (known.number != none && places_[place].number != none)
            place = (place + 1) & (places_.size() - 1);
        if (known.number != none)
            places_[place] = known;
    }
}

void PhraseBook::clear() {
    codes_.clear();
    entries_.clear();
    pieces_.clear();
    std::fill(places_.begin(), places_.end(), Place());
}

void PhraseBook::set_pieces(Number number, std::vector<Number> const& pieces) {
    entries_[number].first_piece = static_cast<std::uint32_t>(pieces_.size());
    entries_[number].pieces = static_cast<std::uint32_t>(pieces.size());
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
}

}  // namespace faster::timing

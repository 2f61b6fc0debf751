#include "dataflow/core/memory/memory_master.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/base/integer_bits.hpp"

namespace dataflow::timing {

MemoryMaster::MemoryMaster(ExternalMemory const& shape, MemoryStream& stream, Prefetch prefetch,
                           HandedOut const& handed_out)
    : shape_(shape),
      stream_(stream),
      prefetch_(shape.prefetches ? prefetch : Prefetch::none),
      handed_out_(handed_out),
      cutter_(shape),
      unused_slots_(shape.outstanding) {}

bool MemoryMaster::follow(HandedOut* handing_out) {
    std::uint64_t const delivered_before = delivered_;
    free_slots(handing_out);
    if (!has_burst_)
        take_up_next();
    if (has_burst_ && !ask_)
        find_ask();
    return delivered_ != delivered_before;
}

void MemoryMaster::take_up_next() {
    has_burst_ = cutter_.next();
    std::uint64_t const free_tokens = cutter_.take_free_tokens();
    if (!stream_.is_write())
        stream_.deliver_free(free_tokens);
    delivered_ += free_tokens;
}

bool MemoryMaster::knows_entry() const {
    switch (prefetch_) {
        case Prefetch::none:
            return stream_.knows_entry();
        case Prefetch::all:
            return true;
        case Prefetch::handed:
            return cutter_.sample() < handed_out_.size();
    }
    return false;
}

Cycles MemoryMaster::cycle_of_entry() {
    switch (prefetch_) {
        case Prefetch::none:
            return stream_.take_entry();
        case Prefetch::all:
            return 0;
        case Prefetch::handed:
            return handed_out_[cutter_.sample()];
    }
    return 0;
}

void MemoryMaster::find_ask() {
    // An entry without bursts has a cycle as well. Of what is written, each token has: all must be there.
    MemoryBurst const& burst = cutter_.burst();
    std::uint64_t const needed =
        stream_.is_write() ? delivered_ + burst.tokens + (burst.is_cut ? 1 : 0) : cutter_.entry_number();
    while (entries_ < needed) {
        if (!knows_entry())
            return;
        entry_cycle_ = cycle_of_entry();
        ++entries_;
    }
    if (unused_slots_ == 0 && free_from_.empty())
        return;
    Cycles const slot = unused_slots_ > 0 ? 0 : free_from_.front();
    ask_ = std::max({ask_from_, entry_cycle_, slot});
}

/// Of bursts that are done: a read once its last beat has come and the last token that ends in it has been taken. All
/// that has been taken either is of such bursts, or of one whose last token has not.
void MemoryMaster::free_slots(HandedOut* handing_out) {
    std::uint64_t const taken = stream_.is_write() ? 0 : stream_.taken();
    for (std::uint64_t i = 0; handing_out != nullptr && i < taken; ++i)
        handing_out->push_back(stream_.after_taking(i));
    for (; !served_.empty() && served_.front().last_token <= forgotten_ + taken; served_.pop_front()) {
        Served const& burst = served_.front();
        Cycles const after_taking = burst.last_token == 0 ? 0 : stream_.after_taking(burst.last_token - 1 - forgotten_);
        free_from_.push_back(std::max(after_taking, burst.after_last_beat));
    }
    stream_.forget_taken(taken);
    forgotten_ += taken;
}

/// From when on the first can be read.
Cycles MemoryMaster::deliver(MemoryBurst const& burst, Cycles first_beat) {
    auto const readable = [from = first_beat + 1, beat = bits_for(shape_.port_bytes - 1)](std::uint64_t last_byte) {
        return from + (last_byte >> beat);
    };
    auto const next = [readable, at = burst.first_last - burst.address, bytes = burst.token_bytes]() mutable {
        return readable(std::exchange(at, at + bytes));
    };
    stream_.deliver_each(burst.tokens - 1, next);
    stream_.deliver(1, readable(burst.last_byte_of(burst.tokens - 1) - burst.address));
    return readable(burst.last_byte_of(0) - burst.address);
}

Cycles MemoryMaster::served(Cycles cycle) {
    MemoryBurst const& burst = cutter_.burst();
    Cycles const asked = *ask_;
    ask_.reset();
    ask_from_ = asked + 1;
    unused_slots_ > 0 ? void(--unused_slots_) : free_from_.pop_front();
    figures_.beats += burst.beats;
    Cycles const done = stream_.is_write() ? cycle : cycle + burst.beats - 1;
    ++figures_.bursts;
    figures_.latencies.add(done - asked);
    Cycles first = never;
    if (stream_.is_write()) {
        free_from_.push_back(done + 1);
        delivered_ += burst.tokens;
    } else {
        if (burst.tokens > 0)
            first = deliver(burst, cycle);
        delivered_ += burst.tokens;
        if (burst.tokens == 0 && served_.empty())  // done, and nobody will be woken to see that
            free_from_.push_back(done + 1);
        else
            served_.push_back({burst.tokens > 0 ? delivered_ : 0, done + 1});
    }
    take_up_next();
    if (has_burst_)
        find_ask();
    return first;
}

}  // namespace dataflow::timing

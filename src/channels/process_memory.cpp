#include <cstdint>
#include <utility>

#include "channels/dataflow_core.hpp"
#include "channels/process_clock.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

// A process's end of the external memory.

namespace {
/// Of the memory: docs/memory-model.md.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 40U;
}  // namespace

timing::Ports ProcessClock::memory_port() const {
    return uses_memory() ? timing::Ports::of(timing_.stream_port()) : timing::no_ports;
}

void ProcessClock::tell_entry(timing::MemoryEntry entry) {
    std::uint64_t const tokens = entry.all_tokens();
    tokens_told_ += tokens;
    if (is_taken_by_loop())
        entries_told_.push_back(tokens);
    else
        tokens_at_hand_ += tokens;
    dataflow_core_.add_entry(timing_.index(), std::move(entry));
}

void ProcessClock::require_memory_port() const {
    if (!has_memory_port_)
        throw InputError("module " + timing_.name() + " accesses the memory, to which it has no port, expected " +
                         "fetches() or stores() in its describe()");
}

void ProcessClock::tell_ranges(std::vector<Range> const& ranges) {
    require_memory_port();
    if (!uses_memory())
        return;
    std::uint64_t const sample = dataflow_core_.begun(timing_.index()) - 1;
    bool const is_taken_by_steps = stream_->loop.empty() && !stream_->writes;
    std::vector<timing::MemoryBlock> blocks;
    for (Range const& range : ranges) {
        if (range.tokens == 0 || range.token_bytes == 0 || range.tokens > most_bytes / range.token_bytes ||
            range.address > most_bytes - range.tokens * range.token_bytes)
            throw InputError("module " + timing_.name() + " tells of " + std::to_string(range.tokens) + " tokens of " +
                             std::to_string(range.token_bytes) + " bytes at the address " +
                             std::to_string(range.address) + ", expected at least one of each, below " +
                             std::to_string(most_bytes));
        blocks.push_back({range.address, range.tokens * range.token_bytes, 0, range.token_bytes, range.tokens});
        for (std::uint64_t i = 0; is_taken_by_steps && i < range.tokens; ++i)
            tell_entry({sample, {{range.address + i * range.token_bytes, range.token_bytes, 0, range.token_bytes}}});
    }
    tells_ranges_ = true;
    if (is_taken_by_loop())
        blocks_told_.insert(blocks_told_.end(), blocks.begin(), blocks.end());
    else if (!is_taken_by_steps)
        tell_entry({sample, std::move(blocks)});
}

void ProcessClock::access_memory() {
    if (is_in_tokens_body_)
        refuse_in_tokens_body("memory");
    require_memory_port();
    if (!uses_memory())
        return;
    require_memory(timing_.stream_port());
    ++tokens_accessed_;
    access(memory_port());
}

/// As the stream's description says, and no more than is told.
void ProcessClock::require_memory(unsigned port) const {
    std::string const what = "module " + timing_.name() + " accesses the memory for " + stream_->name;
    std::string const loop = is_pipelining_ ? timing_.loops()[pipelined_].name : std::string();
    if (loop != stream_->loop)
        throw InputError(what + (loop.empty() ? " outside loops" : " in the loop " + loop) + ", expected it " +
                         (stream_->loop.empty() ? "outside loops, or taken_by() or given_by() in its describe()"
                                                : "in the loop " + stream_->loop));
    collected_.each([this](unsigned other) {
        if (!is_pipelining_ && !stream_->writes && !is_memory(other) && !timing_.writes(other))
            refuse_both(fifos_[other]->timing().name());
    });
    if (collected_.has(port))
        throw InputError(what + " twice in a step or an iteration of a loop, expected once");
    if (tokens_accessed_ == tokens_at_hand_)
        throw InputError(what + " more often than it has told of tokens, which are " + std::to_string(tokens_at_hand_) +
                         ", expected tell_ranges() before");
}

bool ProcessClock::is_taken_by_loop() const { return stream_ != nullptr && !stream_->writes && !stream_->loop.empty(); }

/// Each time that a loop is entered that takes tokens, it has an entry, which may have none.
void ProcessClock::enter_memory(unsigned loop) {
    if (!is_taken_by_loop() || !timing_.loops()[loop].uses_stream)
        return;
    if (entries_told_.empty())
        tell_entry({dataflow_core_.begun(timing_.index()) - 1, std::exchange(blocks_told_, {})});
    tokens_at_hand_ += entries_told_.front();
    entries_told_.pop_front();
}

void ProcessClock::end_calls() {
    std::uint64_t const told = tokens_told_ + timing::MemoryEntry{0, blocks_told_}.all_tokens();
    if (tells_ranges_ && tokens_accessed_ != told)
        throw InputError("module " + timing_.name() + " has told of " + std::to_string(told) +
                         " tokens of the memory for " + stream_->name + ", and accesses " +
                         std::to_string(tokens_accessed_) + ", expected all of them");
    timing_.tell_end(*log_);
    follow();
    is_away_ = true;
}

/// Its module would tell of the step when it has the FIFO's token, too late for the burst to be asked for in its turn.
void ProcessClock::refuse_both(std::string const& fifo) const {
    throw InputError("module " + timing_.name() + " takes " + stream_->name + " from the memory in a step that reads " +
                     fifo + ", expected a step for each");
}

}  // namespace dataflow

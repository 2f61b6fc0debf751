#include "support/memory_twin.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "faster/dataflow_names.hpp"
#include "support/ceil_div.hpp"

namespace faster::testing {
namespace {

constexpr std::uint64_t granule_bytes = 64;

std::uint64_t rounded(double value) { return static_cast<std::uint64_t>(std::llround(value)); }

bool is_power_of_two(std::uint64_t value) { return value != 0 && (value & (value - 1)) == 0; }

void demand(bool holds, char const* what) {
    if (!holds)
        throw std::invalid_argument(std::string("the memory twin wants ") + what);
}

/// Blocks of `size` bytes that [begin, end) touches.
std::uint64_t touched(std::uint64_t begin, std::uint64_t end, std::uint64_t size) {
    return (end - 1) / size - begin / size + 1;
}

struct Corner {
    std::int64_t row = 0;
    std::int64_t col = 0;
};

Corner window_corner(Stimulus const& stimulus, std::size_t sample) {
    SampleInput const& input = stimulus.samples.at(sample);
    return {input.centre_row - stimulus.window / 2, input.centre_col - stimulus.window / 2};
}

/// A row of tokens, pixel by pixel.
TwinRange row_range(TwinMemory const& memory, Stimulus const& stimulus, Corner const& window, std::int64_t row,
                    TwinRegion const& region, std::size_t lanes) {
    TwinRange range;
    std::int64_t const image_row = window.row + row;
    bool begun = false;
    for (std::size_t token = region.first_col / lanes; token * lanes < region.end_col; ++token) {
        std::uint64_t bytes = 0;
        for (std::size_t col = token * lanes; col < (token + 1) * lanes; ++col) {
            std::int64_t const image_col = window.col + static_cast<std::int64_t>(col);
            bool const in_window = col < static_cast<std::size_t>(stimulus.window);
            bool const in_image =
                image_row >= 0 && image_row < stimulus.height && image_col >= 0 && image_col < stimulus.width;
            if (!in_window || !in_image)
                continue;
            if (!begun)
                range.address =
                    memory.image_address + 2 * static_cast<std::uint64_t>(image_row * stimulus.width + image_col);
            begun = true;
            bytes += 2;
        }
        range.token_bytes.push_back(bytes);
    }
    return range;
}

/// Tokens of a beat each.
TwinRange beat_by_beat(TwinMemory const& memory, std::uint64_t address, std::uint64_t bytes) {
    TwinRange range{address, {}};
    for (std::uint64_t begin = address; begin < address + bytes;) {
        std::uint64_t const end = std::min(address + bytes, (begin / memory.port_bytes + 1) * memory.port_bytes);
        range.token_bytes.push_back(end - begin);
        begin = end;
    }
    return range;
}

/// Ports through which at least one copy of the observation is loaded.
std::set<std::size_t> ports_of_copies(TwinMemory const& memory, std::size_t cores) {
    std::set<std::size_t> ports;
    std::size_t const shared_by = cores_of_a_copy(memory, cores);
    for (std::size_t first_core = 0; first_core < cores; first_core += shared_by)
        ports.insert(first_core % memory.ports);
    return ports;
}

/// What a port brings to the chip.
TwinRanges loads_of_port(TwinMemory const& memory, Stimulus const& stimulus, std::size_t cores, std::size_t port) {
    std::uint64_t triangles = 0;
    for (SampleInput const& sample : stimulus.samples)
        triangles = std::max<std::uint64_t>(triangles, sample.triangle_count);
    TwinRanges ranges;
    if (memory.mesh_on_chip)
        ranges.push_back(beat_by_beat(memory, memory.mesh_address, 24 * triangles));
    if (memory.observation_on_chip && ports_of_copies(memory, cores).count(port) != 0) {
        std::uint64_t const pixels =
            static_cast<std::uint64_t>(stimulus.width) * static_cast<std::uint64_t>(stimulus.height);
        ranges.push_back(beat_by_beat(memory, memory.image_address, 2 * pixels));
    }
    return ranges;
}

}  // namespace

std::size_t cores_of_a_copy(TwinMemory const& memory, std::size_t cores) {
    return ceil_div(cores, memory.observation_copies);
}

TwinRanges header_ranges(TwinMemory const& memory, std::size_t sample) {
    return {{memory.header_address + 64 * sample, {64}}};
}

TwinRanges mesh_ranges(TwinMemory const& memory, std::size_t triangles) {
    return {{memory.mesh_address, std::vector<std::uint64_t>(3 * triangles, 8)}};
}

TwinRanges table_ranges(TwinMemory const& memory, Stimulus const& stimulus, std::size_t sample) {
    Corner const window = window_corner(stimulus, sample);
    auto const within = [](std::int64_t at, int size) { return std::clamp<std::int64_t>(at, 0, size); };
    TwinRanges ranges;
    for (std::int64_t const row :
         {within(window.row, stimulus.height), within(window.row + stimulus.window, stimulus.height)}) {
        for (std::int64_t const col :
             {within(window.col, stimulus.width), within(window.col + stimulus.window, stimulus.width)}) {
            ranges.push_back(
                {memory.table_address + 4 * static_cast<std::uint64_t>(row * (stimulus.width + 1) + col), {4}});
        }
    }
    return ranges;
}

TwinRanges row_ranges(TwinMemory const& memory, Stimulus const& stimulus, std::size_t sample, TwinRegion const& region,
                      std::size_t lanes) {
    Corner const window = window_corner(stimulus, sample);
    TwinRanges ranges;
    for (std::size_t row = region.first_row; row < region.end_row; ++row)
        ranges.push_back(row_range(memory, stimulus, window, static_cast<std::int64_t>(row), region, lanes));
    return ranges;
}

TwinRanges result_ranges(TwinMemory const& memory, std::size_t sample) {
    return {{memory.result_address + 32 * sample, {32}}};
}

void TwinMasterModel::add_entry(TwinRanges const& ranges) {
    entries_.emplace_back();
    for (TwinRange const& range : ranges) {
        std::size_t burst = bursts_.size();
        std::uint64_t end = range.address;
        for (std::uint64_t const bytes : range.token_bytes)
            end += bytes;
        cut(range.address, end);
        std::uint64_t at = range.address;
        std::uint64_t burst_begin = range.address;
        std::size_t const first_burst = burst;
        for (std::uint64_t const bytes : range.token_bytes) {
            Token token;
            if (bytes > 0) {
                note_token(first_burst, range.address, at, at + bytes);
                at += bytes;
                while ((at - 1) / memory_->burst_bytes != burst_begin / memory_->burst_bytes) {
                    burst_begin = (burst_begin / memory_->burst_bytes + 1) * memory_->burst_bytes;
                    ++burst;
                }
                token = {true, burst, (at - 1) / memory_->port_bytes - burst_begin / memory_->port_bytes};
                bursts_[burst].tokens_to_take += writes_ ? 0 : 1;
            }
            entries_.back().tokens.push_back(token);
            entries_.back().given.push_back(never);
        }
    }
}

/// The token to come lies in these bytes of a range.
void TwinMasterModel::note_token(std::size_t first_burst, std::uint64_t range_begin, std::uint64_t begin,
                                 std::uint64_t end) {
    std::uint64_t const first = range_begin / memory_->burst_bytes;
    for (std::uint64_t i = begin / memory_->burst_bytes; i <= (end - 1) / memory_->burst_bytes; ++i)
        bursts_[first_burst + i - first].last_token = entries_.back().tokens.size();
}

/// At every multiple of `burst_bytes`; each piece is widened to whole beats.
void TwinMasterModel::cut(std::uint64_t begin, std::uint64_t end) {
    while (begin < end) {
        std::uint64_t const next = std::min(end, (begin / memory_->burst_bytes + 1) * memory_->burst_bytes);
        std::uint64_t const wide_begin = begin / memory_->port_bytes * memory_->port_bytes;
        std::uint64_t const wide_end = ceil_div(next, memory_->port_bytes) * memory_->port_bytes;
        Burst burst;
        burst.entry = entries_.size() - 1;
        burst.beats = touched(wide_begin, wide_end, memory_->port_bytes);
        burst.granules = touched(wide_begin, wide_end, granule_bytes);
        bursts_.push_back(burst);
        begin = next;
    }
}

Cycles TwinMasterModel::token_legal_from(std::size_t entry, std::size_t token) const {
    Token const& wanted = entries_.at(entry).tokens.at(token);
    if (!wanted.is_fetched)
        return 0;
    Burst const& burst = bursts_[wanted.burst];
    return burst.asked == never ? never : burst.first_beat + wanted.beat + 1;
}

void TwinMasterModel::take(std::size_t entry, std::size_t token, Cycles cycle) {
    Token const& taken = entries_.at(entry).tokens.at(token);
    if (!taken.is_fetched)
        return;
    Burst& burst = bursts_[taken.burst];
    --burst.tokens_to_take;
    burst.last_taken = cycle;
}

Cycles TwinMasterModel::done(Burst const& burst) {
    bool const is_open = burst.asked == never || burst.tokens_to_take > 0;
    return is_open ? never : std::max(burst.answered, burst.last_taken);
}

Cycles TwinMasterModel::next_ask() const {
    if (next_ == bursts_.size())
        return never;
    Entry const& entry = entries_[bursts_[next_].entry];
    Cycles from = writes_ ? entry.given[bursts_[next_].last_token] : entry.begin;
    if (from == never)
        return never;
    if (next_ > 0)
        from = std::max(from, bursts_[next_ - 1].asked + 1);
    if (next_ >= memory_->outstanding) {
        Cycles const room = done(bursts_[next_ - memory_->outstanding]);
        return room == never ? never : std::max(from, room + 1);
    }
    return from;
}

TwinTraffic TwinMasterModel::traffic() const {
    TwinTraffic traffic;
    for (std::size_t k = 0; k < next_; ++k) {
        Burst const& burst = bursts_[k];
        ++traffic.bursts;
        traffic.bytes += burst.beats * memory_->port_bytes;
        traffic.granules += burst.granules;
        traffic.latency_sum += burst.answered - burst.asked;
        traffic.latency_max = std::max(traffic.latency_max, burst.answered - burst.asked);
        traffic.last_asked = burst.asked;
    }
    return traffic;
}

TwinMemoryModel::TwinMemoryModel(TwinMemory const& memory, double clock_mhz)
    : memory_(memory),
      period_ps_(rounded(1e6 / clock_mhz)),
      latency_ps_(rounded(1e3 * memory.read_latency_ns)),
      granule_ps_(rounded(64e3 / (memory.dram_gb_per_s * memory.dram_efficiency))),
      ports_(memory.ports) {
    demand(period_ps_ > 0, "a period of at least 1 ps");
    demand(memory.ports > 0 && memory.outstanding > 0 && memory.observation_copies > 0,
           "at least one port, burst and copy");
    demand(is_power_of_two(memory.port_bytes) && memory.port_bytes >= 4, "beats of a power of two bytes");
    demand(is_power_of_two(memory.burst_bytes) && memory.burst_bytes >= memory.port_bytes && memory.burst_bytes <= 4096,
           "bursts of a power of two bytes");
}

std::size_t TwinMemoryModel::add_master(std::size_t port, bool writes) {
    masters_.emplace_back(memory_, port, writes);
    return masters_.size() - 1;
}

/// Who asks in this cycle arrives before all that ask later, so what becomes of it is decided now.
void TwinMemoryModel::end_cycle(Cycles cycle) {
    for (TwinMasterModel& master : masters_) {
        Cycles const ask = master.next_ask();
        if (ask < cycle)
            throw std::logic_error("the memory twin has missed a request");
        if (ask == cycle)
            serve(master, cycle);
    }
}

void TwinMemoryModel::serve(TwinMasterModel& master, Cycles asked) {
    TwinMasterModel::Burst& burst = master.bursts_[master.next_++];
    std::uint64_t const arrival = (asked + memory_.request_cycles) * period_ps_;
    std::uint64_t const begin = std::max(arrival, controller_end_ps_);
    std::uint64_t const busy = burst.granules * granule_ps_;
    controller_end_ps_ = begin + busy;
    controller_ps_ += busy;
    Cycles const ready = ceil_div(begin + latency_ps_, period_ps_);
    burst.asked = asked;
    if (master.writes_) {
        burst.first_beat = ready;
        burst.answered = ready;
        return;
    }
    Port& port = ports_.at(master.port_);
    burst.first_beat = std::max(ready, port.free_from);
    burst.answered = burst.first_beat + burst.beats - 1;
    port.free_from = burst.answered + 1;
    port.beats += burst.beats;
}

bool TwinMemoryModel::is_idle() const {
    return std::all_of(masters_.begin(), masters_.end(),
                       [](TwinMasterModel const& master) { return master.next_ask() == TwinMasterModel::never; });
}

Cycles load_cycles(TwinMemory const& memory, double clock_mhz, Stimulus const& stimulus, std::size_t cores) {
    if (!memory.is_axi || stimulus.samples.empty())
        return 0;
    TwinMemoryModel model(memory, clock_mhz);
    std::size_t const loading = std::min<std::size_t>(memory.ports, cores);
    std::vector<std::size_t> next(loading, 0);  // token, by port
    for (std::size_t port = 0; port < loading; ++port) {
        TwinMasterModel& master = model.master(model.add_master(port, false));
        master.add_entry(loads_of_port(memory, stimulus, cores, port));
        master.begin_entry(0, 0);
    }
    Cycles end = 0;
    auto const all_taken = [&] {
        for (std::size_t port = 0; port < loading; ++port) {
            if (next[port] < model.master(port).tokens(0))
                return false;
        }
        return true;
    };
    for (Cycles cycle = 0; !all_taken(); ++cycle) {
        for (std::size_t port = 0; port < loading; ++port) {
            TwinMasterModel& master = model.master(port);
            while (next[port] < master.tokens(0) && master.token_legal_from(0, next[port]) <= cycle) {
                master.take(0, next[port]++, cycle);
                end = cycle + 1;
            }
        }
        model.end_cycle(cycle);
    }
    return end;
}

}  // namespace faster::testing

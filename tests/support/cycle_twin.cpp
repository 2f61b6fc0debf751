#include "support/cycle_twin.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <variant>

#include "faster/dataflow_names.hpp"
#include "support/ceil_div.hpp"
#include "support/memory_twin.hpp"
#include "support/plain_config.hpp"
#include "support/twin_function.hpp"
#include "support/twin_programs.hpp"

namespace faster::testing {
namespace {

constexpr Cycles never = std::numeric_limits<Cycles>::max();

/// A FIFO that remembers the cycle of every access. What it calls legal in a cycle follows from accesses of earlier
/// cycles alone (every rule has a `+ 1` or a `+ Lf`), so the order in which processes try does not matter.
class FifoModel {
  public:
    FifoModel(FifoConfig const& config, Cycles pipeline_stages) : pipeline_stages_(pipeline_stages) {
        bool const is_memory =
            config.kind == FifoKind::memory || (config.kind == FifoKind::automatic && !is_small(config));
        bool const has_register_besides = is_memory && config.rules != FifoGeneration::vitis_hls;
        capacity_ = has_register_besides ? config.depth + 1 : config.depth;
        read_latency_ = is_memory ? 2 : 1;
    }

    /// First cycle in which the next access is legal; `never` unless some other process moves first.
    Cycles legal_from(AccessKind kind) const {
        return kind == AccessKind::Write ? write_legal_from() : read_legal_from();
    }

    void access(AccessKind kind, Cycles cycle) {
        (kind == AccessKind::Write ? write_cycles_ : read_cycles_).push_back(cycle);
    }

    void count_stall(AccessKind kind) {
        ++(kind == AccessKind::Write ? stats_.full_stall_cycles : stats_.empty_stall_cycles);
    }

    /// Tokens on their way through the pipeline are not in the FIFO yet.
    void end_cycle(Cycles cycle) {
        while (arrived_ < write_cycles_.size() && write_cycles_[arrived_] + pipeline_stages_ <= cycle) {
            ++arrived_;
        }
        std::uint64_t const occupancy = std::min<std::uint64_t>(arrived_ - read_cycles_.size(), capacity_);
        stats_.max_occupancy = std::max(stats_.max_occupancy, occupancy);
    }

    std::vector<Cycles> const& read_cycles() const { return read_cycles_; }

    TwinFifo stats() const {
        TwinFifo stats = stats_;
        stats.writes = write_cycles_.size();
        stats.reads = read_cycles_.size();
        return stats;
    }

  private:
    /// docs/timing-model.md#fifos: what HLS makes a shift register of.
    static bool is_small(FifoConfig const& config) {
        return config.depth <= 2 || (config.rules != FifoGeneration::spec && config.depth * config.bits <= 1024);
    }

    Cycles write_legal_from() const {
        std::size_t const n = write_cycles_.size();
        std::size_t const slots = capacity_ + pipeline_stages_;
        if (n < slots) {
            return 0;
        }
        return n - slots < read_cycles_.size() ? read_cycles_[n - slots] + 1 : never;
    }

    Cycles read_legal_from() const {
        std::size_t const n = read_cycles_.size();
        return n < write_cycles_.size() ? write_cycles_[n] + pipeline_stages_ + read_latency_ : never;
    }

    std::uint64_t capacity_ = 0;
    Cycles read_latency_ = 0;
    Cycles const pipeline_stages_;  ///< between the write and the FIFO: area_reciprocal's Lw if it squeezes, else 0
    std::vector<Cycles> write_cycles_;
    std::vector<Cycles> read_cycles_;
    std::size_t arrived_ = 0;
    TwinFifo stats_;
};

using Fifos = std::vector<FifoModel>;  // [FifoId]

Fifos make_fifos(AcceleratorConfig const& config) {
    Fifos fifos;
    for (FifoId const id : fifo_ids) {
        FifoConfig const fifo = fifo_of(config, id);
        fifos.emplace_back(fifo, id == FifoId::area_reciprocal && fifo.squeezes ? fifo.write_latency : 0);
    }
    return fifos;
}

/// A word, seen from the pixel of the iteration.
using Word = TwinPixel;

constexpr Word own{0, 0};
constexpr Word above{-1, 0};
constexpr Word below{1, 0};

/// Words of one memory that an iteration touches in its worst branch; one that is read and written stands there twice.
struct BramUse {
    BramId bram;
    std::vector<Word> words;
};

/// What as many iterations side by side as there are lanes read or write together.
std::vector<Word> side_by_side(std::vector<Word> const& words, int lanes) {
    std::set<std::pair<int, int>> places;
    for (Word const& word : words) {
        for (int lane = 0; lane < lanes; ++lane) {
            places.insert({word.row, word.col + lane});
        }
    }
    std::vector<Word> together;
    for (auto const& [row, col] : places) {
        together.push_back({row, col});
    }
    return together;
}

/// Reads and writes of the worst branch, counted from the thesis's pseudo code.
std::vector<BramUse> token_uses(AcceleratorConfig const& config) {
    switch (config.edge_map.algorithm) {
        case EdgeMapAlgorithm::threshold:
        case EdgeMapAlgorithm::transition:
            return {{BramId::edge_map, {own, own}}};
        case EdgeMapAlgorithm::bounded:
            return {{BramId::edge_map, {own, below, below, above, above}}};
        case EdgeMapAlgorithm::dual_map:
            break;
        case EdgeMapAlgorithm::dual_map_4_1_2:
            return {{BramId::edge_map, {below, above}}, {BramId::object_map, {own, below, above}}};
        case EdgeMapAlgorithm::inner_border:
            return {{BramId::object_map, side_by_side({own}, config.rasterizer.lanes)}};
    }
    return {{BramId::edge_map, {below, above}}, {BramId::object_map, {below, above}}};
}

bool has_one_map(EdgeMapAlgorithm algorithm) {
    return algorithm == EdgeMapAlgorithm::threshold || algorithm == EdgeMapAlgorithm::transition ||
           algorithm == EdgeMapAlgorithm::bounded;
}

void append(std::vector<Word>& words, std::vector<Word> const& more) {
    words.insert(words.end(), more.begin(), more.end());
}

/// The words cleared behind a sweep that reads neighbours are those of the token above to the left.
std::vector<Word> sweep_words(AcceleratorConfig const& config) {
    bool const once = config.flow == Flow::fpga_grip || config.edge_map.algorithm == EdgeMapAlgorithm::inner_border ||
                      config.inlier_unit.neighbour_access == NeighbourAccess::window;
    std::vector<Word> words =
        side_by_side(once ? std::vector<Word>{own} : std::vector<Word>{own, below, above, {0, 1}, {0, -1}},
                     config.inlier_unit.sweep_lanes);
    if (config.inlier_unit.clearing == MapClearing::on_read_out) {
        append(words,
               side_by_side({once ? own : Word{-1, -config.inlier_unit.sweep_lanes}}, config.inlier_unit.sweep_lanes));
    }
    return words;
}

/// Every lane's pixel, read and written.
std::vector<Word> fragment_words(AcceleratorConfig const& config) {
    std::vector<Word> words = side_by_side({own}, config.rasterizer.lanes);
    append(words, std::vector<Word>(words));
    return words;
}

/// All neighbours and the judged word; or one new word, and the judged one half a neighbourhood behind.
std::vector<Word> extract_words(EdgeExtractionConfig const& config) {
    int const reach = config.neighbourhood / 2;
    if (config.neighbour_access == NeighbourAccess::window) {
        return {own, {-reach, -reach}};
    }
    std::vector<Word> words{own};
    for (int row = -reach; row <= reach; ++row) {
        for (int col = -reach; col <= reach; ++col) {
            words.push_back({row, col});
        }
    }
    return words;
}

std::vector<BramUse> output_uses(AcceleratorConfig const& config) {
    EdgeMapConfig const& edge_map = config.edge_map;
    bool const clears = edge_map.clearing == MapClearing::on_read_out;
    std::vector<Word> const once = side_by_side({own}, config.inlier_unit.sweep_lanes);
    std::vector<Word> sent = once;
    if (clears) {
        append(sent, once);
    }
    if (edge_map.algorithm == EdgeMapAlgorithm::inner_border)
        return {{BramId::object_map, sent}};
    std::vector<BramUse> uses{{BramId::edge_map, sent}};
    if (clears && !has_one_map(edge_map.algorithm))
        uses.push_back({BramId::object_map, once});
    return uses;
}

/// A copy on the chip is read by all its cores in the same iteration.
std::vector<BramUse> read_uses(AcceleratorConfig const& config, TwinMemory const& memory) {
    if (!memory.is_axi || !memory.observation_on_chip)
        return {};
    std::vector<Word> words;
    for (std::size_t core = 0; core < cores_of_a_copy(memory, config.cores); ++core)
        append(words, side_by_side({own}, config.inlier_unit.sweep_lanes));
    return {{BramId::observation, words}};
}

std::vector<BramUse> bram_uses(LoopId loop, AcceleratorConfig const& config, TwinMemory const& memory) {
    EdgeMapAlgorithm const algorithm = config.edge_map.algorithm;
    bool const is_inner = algorithm == EdgeMapAlgorithm::inner_border;
    if (loop == LoopId::edge_clear) {
        if (is_inner)
            return {{BramId::object_map, {own}}};
        if (has_one_map(algorithm))
            return {{BramId::edge_map, {own}}};
        return {{BramId::edge_map, {own}}, {BramId::object_map, {own}}};
    }
    if (loop == LoopId::token)
        return token_uses(config);
    if (loop == LoopId::output || loop == LoopId::buffered_output)
        return output_uses(config);
    if (loop == LoopId::read)
        return read_uses(config, memory);
    if (loop == LoopId::depth_clear)
        return {{BramId::depth_buffer, {own}}};
    if (loop == LoopId::fragment)
        return {{BramId::depth_buffer, fragment_words(config)}};
    if (loop == LoopId::sweep || loop == LoopId::buffered_sweep)
        return {{BramId::depth_buffer, sweep_words(config)}};
    if (loop == LoopId::extract || loop == LoopId::buffered_extract)
        return {{BramId::depth_buffer, extract_words(config.edge_extraction)}};
    return {};
}

/// The square root and the divider are stages of their own.
Cycles depth_of(AcceleratorConfig const& config, LoopId id) {
    EdgeExtractionConfig const& units = config.edge_extraction;
    bool const extracts = id == LoopId::extract || id == LoopId::buffered_extract;
    return loop_of(config, id).depth + (extracts ? units.square_root_latency + units.divider_latency : 0);
}

/// How many stretches of the dimension have banks of their own.
int banks_of(PartitionConfig const& partition, std::uint64_t dimension) {
    bool const is_spared = partition.dimension != 0 && partition.dimension != dimension;
    return partition.type != PartitionType::none && !is_spared ? static_cast<int>(partition.factor) : 1;
}

/// The bank along one dimension of a coordinate >= 0.
int bank_along(int at, PartitionType type, int banks, int side) {
    if (banks == 1) {
        return 0;
    }
    return type == PartitionType::cyclic ? at % banks : at / ((side + banks - 1) / banks);
}

/// Tries every place of the pixel, in a plane so large that no word is at its border.
std::uint64_t most_in_a_bank(std::vector<Word> const& words, PartitionConfig const& partition, int side) {
    int const rows = banks_of(partition, 1);
    int const cols = banks_of(partition, 2);
    std::uint64_t most = 0;
    for (int row = side; row < 2 * side + 1; ++row) {
        for (int col = side; col < 2 * side + 1; ++col) {
            std::map<std::pair<int, int>, std::uint64_t> counts;
            for (Word const& word : words) {
                std::pair<int, int> const bank{bank_along(row + word.row, partition.type, rows, side),
                                               bank_along(col + word.col, partition.type, cols, side)};
                most = std::max(most, ++counts[bank]);
            }
            if (rows == 1 && cols == 1) {
                return most;
            }
        }
    }
    return most;
}

/// What docs/timing-model.md says of one loop before anything runs.
struct LoopRules {
    Cycles ii = 1;
    Cycles port_conflicts_per_iteration = 0;
    Cycles recurrence_per_iteration = 0;
    std::string limited_by;
};

LoopRules rules_of(AcceleratorConfig const& config, LoopId id, TwinMemory const& memory) {
    LoopConfig const loop = loop_of(config, id);
    Cycles ports_ii = 0;
    double largest_quotient = 0;
    std::string tightest;
    for (BramUse const& use : bram_uses(id, config, memory)) {
        BramConfig const bram = bram_of(config, use.bram);
        std::uint64_t const accesses = most_in_a_bank(use.words, bram.partition, config.window);
        ports_ii = std::max(ports_ii, ceil_div(accesses, bram.ports));
        double const quotient = static_cast<double>(accesses) / static_cast<double>(bram.ports);
        if (quotient > largest_quotient) {
            largest_quotient = quotient;
            tightest = name_of(use.bram);
        }
    }
    LoopRules rules;
    // Thesis 5.4: one map, read after it was written; a write takes two cycles.
    bool const reads_what_it_wrote = id == LoopId::token && has_one_map(config.edge_map.algorithm);
    Cycles const recurrence_ii = std::max<Cycles>(loop.recurrence_ii, reads_what_it_wrote ? 2 : 1);
    Cycles const without_ports = std::max(loop.ii, recurrence_ii);
    rules.ii = std::max(without_ports, ports_ii);
    rules.port_conflicts_per_iteration = ports_ii > without_ports ? ports_ii - without_ports : 0;
    rules.recurrence_per_iteration = recurrence_ii > loop.ii ? recurrence_ii - loop.ii : 0;
    if (ports_ii > without_ports) {
        rules.limited_by = tightest;
    } else if (recurrence_ii > loop.ii) {
        rules.limited_by = "recurrence";
    }
    return rules;
}

std::array<TwinLoop, loop_count> make_loops(AcceleratorConfig const& config, TwinMemory const& memory) {
    std::array<TwinLoop, loop_count> loops;
    for (LoopId const id : loop_ids) {
        LoopRules const rules = rules_of(config, id, memory);
        loops[index_of(id)].ii = rules.ii;
        loops[index_of(id)].limited_by = rules.limited_by;
    }
    return loops;
}

/// Where in the pipelines of loops tokens leave, and where those end: what is asked for in every cycle.
struct Stages {
    explicit Stages(AcceleratorConfig const& config) {
        for (FifoId const id : fifo_ids)
            write_latency[index_of(id)] = fifo_of(config, id).write_latency;
        for (LoopId const id : loop_ids)
            depth[index_of(id)] = depth_of(config, id);
    }

    std::array<Cycles, fifo_count> write_latency{};
    std::array<Cycles, loop_count> depth{};
};

/// A core's masters: when their entries begin, and when tokens are there.
class CoreMemory {
  public:
    CoreMemory(TwinMemory const& memory, AcceleratorConfig const& config, TwinMemoryModel& model, std::size_t core)
        : memory_(memory), config_(config), model_(model), first_master_(core * master_count) {
        for (std::size_t master = 0; master < master_count; ++master)
            model.add_master(core % memory.ports, static_cast<TwinMaster>(master) == TwinMaster::result);
    }

    void add_sample(TwinSamplePrograms const& sample) {
        for (TwinProgram const& program : sample.programs) {
            for (TwinState const& state : program) {
                if (state.master)
                    add_entry(*state.master, state.ranges);
            }
        }
        ++samples_;
    }

    /// A process has come to the step or loop of this entry.
    void arrive(TwinMaster id, std::size_t entry, Cycles cycle) {
        if (!works_ahead(id))
            master(id).begin_entry(entry, cycle);
    }

    /// SampleDispatcher has handed out a sample: its addresses are known from the next cycle on.
    void hand_out(std::size_t sample, Cycles cycle) {
        for (Ahead const& ahead : ahead_) {
            if (ahead.sample == sample)
                master(ahead.master).begin_entry(ahead.entry, cycle + 1);
        }
    }

    Cycles token_legal_from(TwinMaster id, std::size_t entry, std::size_t token) const {
        return model_.master(number(id)).token_legal_from(entry, token);
    }

    void take(TwinMaster id, std::size_t entry, std::size_t token, Cycles cycle) {
        master(id).take(entry, token, cycle);
    }

    std::array<TwinTraffic, master_count> traffic() const {
        std::array<TwinTraffic, master_count> traffic;
        for (std::size_t i = 0; i < master_count; ++i)
            traffic[i] = model_.master(first_master_ + i).traffic();
        return traffic;
    }

  private:
    /// An entry of a master that does not wait for its process.
    struct Ahead {
        TwinMaster master;
        std::size_t entry;
        std::size_t sample;
    };

    std::size_t number(TwinMaster id) const { return first_master_ + static_cast<std::size_t>(id); }
    TwinMasterModel& master(TwinMaster id) { return model_.master(number(id)); }

    bool works_ahead(TwinMaster id) const {
        bool const knows_late =
            id == TwinMaster::observation && config_.inlier_unit.sweep_region == SweepRegion::touched;
        return memory_.prefetch && id != TwinMaster::result && !knows_late;
    }

    void add_entry(TwinMaster id, TwinRanges const& ranges) {
        std::size_t const entry = master(id).entries();
        master(id).add_entry(ranges);
        if (works_ahead(id) && id == TwinMaster::header)
            master(id).begin_entry(entry, 0);
        else if (works_ahead(id))
            ahead_.push_back({id, entry, samples_});
    }

    TwinMemory const& memory_;
    AcceleratorConfig const& config_;
    TwinMemoryModel& model_;
    std::size_t first_master_;
    std::size_t samples_ = 0;
    std::vector<Ahead> ahead_;
};

/// One process: where it is in its program, and since when.
class ProcessModel {
  public:
    ProcessModel(AcceleratorConfig const& config, TwinProgram program, Fifos& fifos,
                 std::array<TwinLoop, loop_count>& loops, TwinMemory const& memory, CoreMemory& core_memory)
        : config_(config),
          stages_(config),
          program_(std::move(program)),
          fifos_(fifos),
          loops_(loops),
          memory_(memory),
          core_memory_(core_memory) {}

    bool is_finished() const { return state_ == program_.size(); }

    /// Does what it can do in this cycle.
    ///
    /// A step that cannot happen now charges this cycle to the first of its accesses, in program order, that is not
    /// legal now. That is the rule of docs/timing-model.md#fifos: access j moves T from the latest of the step's
    /// arrival and e_1..e_(j-1) to its own earliest legal cycle e_j, if that is later, and is charged the cycles
    /// between. So a cycle c belongs to the j with e_i <= c for all i < j and e_j > c: all accesses before j are legal
    /// at c (once legal, an access of this process stays so: nobody else can take its token or its place), and j is
    /// not.
    void run_cycle(Cycles cycle) {
        while (!is_finished() && local_time_ <= cycle) {
            arrive();
            if (must_wait()) {
                ++bubbles_;
                ++loops_[index_of(*program_[state_].loop)].recurrence_cycles;
                local_time_ = cycle + 1;
                return;
            }
            std::optional<std::size_t> const token = current_token();
            if (token && core_memory_.token_legal_from(*master(), entry_, *token) > cycle) {
                ++stats_.memory_stall;
                return;
            }
            std::vector<TwinAccess> const accesses = current_accesses();
            for (TwinAccess const& access : accesses) {
                if (fifo(access).legal_from(access.kind) > cycle) {
                    fifo(access).count_stall(access.kind);
                    ++(access.kind == AccessKind::Write ? stats_.full_stall : stats_.empty_stall);
                    (access.kind == AccessKind::Write ? stats_.full_stalls : stats_.empty_stalls).push_back(cycle);
                    return;
                }
            }
            for (TwinAccess const& access : accesses) {
                fifo(access).access(access.kind, cycle);
            }
            if (token)
                core_memory_.take(*master(), entry_, *token, cycle);
            finish_step(cycle);
        }
    }

    /// Whether its current step can never happen unless another process moves first.
    bool is_stuck() const {
        if (is_finished()) {
            return false;
        }
        std::vector<TwinAccess> const accesses = current_accesses();
        return std::any_of(accesses.begin(), accesses.end(),
                           [this](TwinAccess const& access) { return fifo(access).legal_from(access.kind) == never; });
    }

    /// When it reached its current step.
    Cycles local_time() const { return local_time_; }

    TwinProcess stats() const {
        TwinProcess stats = stats_;
        stats.end_cycle = local_time_;
        return stats;
    }

  private:
    FifoModel& fifo(TwinAccess const& access) const { return fifos_[index_of(access.fifo)]; }

    std::optional<TwinMaster> const& master() const { return program_[state_].master; }
    bool reads_memory() const { return master() && *master() != TwinMaster::result; }

    /// Tells the master when a step or loop is come to.
    void arrive() {
        if (reads_memory() && !has_arrived_)
            core_memory_.arrive(*master(), entry_, local_time_);
        has_arrived_ = true;
    }

    /// Token that the step at hand takes from memory.
    std::optional<std::size_t> current_token() const {
        TwinState const& state = program_[state_];
        if (!reads_memory())
            return {};
        if (!state.loop)
            return 0;
        Cycles const ii = loops_[index_of(*state.loop)].ii;
        bool const begins_iteration = loop_step_ % ii == 0 && loop_step_ / ii < state.iterations.size();
        return begins_iteration ? std::optional<std::size_t>(loop_step_ / ii) : std::nullopt;
    }

    /// A process has one master at most, so its entries are those of its states.
    void next_state() {
        if (master()) {
            ++entry_;
        }
        has_arrived_ = false;
        ++state_;
    }

    /// Steps of a loop: p = 0 .. (n - 1) * II + L - 1.
    Cycles last_loop_step(TwinState const& state) const {
        return (state.iterations.size() - 1) * loops_[index_of(*state.loop)].ii + stages_.depth[index_of(*state.loop)] -
               1;
    }

    std::vector<TwinAccess> current_accesses() const {
        TwinState const& state = program_[state_];
        if (!state.loop) {
            return state.accesses;
        }
        Cycles const ii = loops_[index_of(*state.loop)].ii;
        std::vector<TwinAccess> accesses;
        for (std::size_t k = 0; k < state.accesses.size(); ++k) {
            TwinAccess const& access = state.accesses[k];
            Cycles const stage = access.kind == AccessKind::Write ? stages_.write_latency[index_of(access.fifo)] : 0;
            if (loop_step_ < stage || (loop_step_ - stage) % ii != 0) {
                continue;
            }
            Cycles const iteration = (loop_step_ - stage) / ii;
            if (iteration < state.iterations.size() && ((state.iterations[iteration] >> k) & 1U) != 0) {
                accesses.push_back(access);
            }
        }
        return accesses;
    }

    /// Whether the iteration about to begin would read a word in a step in which one before it has yet to write it, or
    /// does. So it begins a step later, which is one more for those in the pipeline.
    bool must_wait() const {
        TwinState const& state = program_[state_];
        std::vector<TwinTouch> const* const touches = touches_of_beginning();
        return touches != nullptr && std::any_of(touches->begin(), touches->end(), [&](TwinTouch const& touch) {
                   DependenceConfig const dependence = dependence_of(config_, *state.loop, touch.bram);
                   Cycles const read_step = loop_step_ + bubbles_ + dependence.read_stage;
                   return dependence.waits &&
                          std::any_of(writes_.begin(), writes_.end(), [&](WriteToCome const& write) {
                              return write.bram == touch.bram && write.pixel.row == touch.pixel.row &&
                                     write.pixel.col == touch.pixel.col && write.step >= read_step;
                          });
               });
    }

    /// Null if the step at hand begins no iteration that touches anything.
    std::vector<TwinTouch> const* touches_of_beginning() const {
        TwinState const& state = program_[state_];
        if (!state.loop || state.touches.empty()) {
            return nullptr;
        }
        Cycles const ii = loops_[index_of(*state.loop)].ii;
        bool const begins = loop_step_ % ii == 0 && loop_step_ / ii < state.touches.size();
        return begins ? &state.touches[loop_step_ / ii] : nullptr;
    }

    void note_writes(TwinState const& state) {
        std::vector<TwinTouch> const* const touches = touches_of_beginning();
        for (std::size_t i = 0; touches != nullptr && i < touches->size(); ++i) {
            TwinTouch const& touch = (*touches)[i];
            if (touch.writes) {
                Cycles const stage = dependence_of(config_, *state.loop, touch.bram).write_stage;
                writes_.push_back({touch.bram, touch.pixel, loop_step_ + bubbles_ + stage});
            }
        }
    }

    /// First cycle of the step at hand, if it is the first of an iteration that waits for a triangle to be set up.
    Cycles setup_done() const {
        TwinState const& state = program_[state_];
        if (next_setup_ == state.setups.size() ||
            loop_step_ != state.setups[next_setup_].awaits * loops_[index_of(*state.loop)].ii) {
            return 0;
        }
        return setup_began_[next_setup_] + state.setup_cycles;
    }

    /// The II cycles of an iteration that reads a triangle's last vertex end with the step at hand.
    void note_setups(TwinState const& state) {
        Cycles const ii = loops_[index_of(*state.loop)].ii;
        if (next_setup_ < state.setups.size() && loop_step_ == state.setups[next_setup_].awaits * ii) {
            ++next_setup_;
        }
        std::size_t const begun = setup_began_.size();
        if (begun < state.setups.size() && loop_step_ + 1 == (state.setups[begun].since + 1) * ii) {
            setup_began_.push_back(local_time_);
        }
    }

    void finish_step(Cycles cycle) {
        TwinState const& state = program_[state_];
        if (!state.loop) {
            local_time_ = cycle + state.advance;
            if (master() == TwinMaster::header)
                core_memory_.hand_out(entry_, cycle);
            if (master() == TwinMaster::result)
                core_memory_.arrive(TwinMaster::result, entry_, local_time_);
            next_state();
            return;
        }
        if (loop_step_ == 0) {
            count_loop_entry(*state.loop, state.iterations.size());
        }
        local_time_ = cycle + 1;
        note_setups(state);
        note_writes(state);
        if (loop_step_ == last_loop_step(state)) {
            loop_step_ = 0;
            next_setup_ = 0;
            setup_began_.clear();
            bubbles_ = 0;
            writes_.clear();
            next_state();
        } else {
            ++loop_step_;
            local_time_ = std::max(local_time_, setup_done());
        }
    }

    void count_loop_entry(LoopId id, std::uint64_t iterations) {
        LoopRules const rules = rules_of(config_, id, memory_);
        TwinLoop& loop = loops_[index_of(id)];
        ++loop.entries;
        loop.iterations += iterations;
        loop.port_conflict_cycles += iterations * rules.port_conflicts_per_iteration;
        loop.recurrence_cycles += iterations * rules.recurrence_per_iteration;
    }

    AcceleratorConfig const& config_;
    Stages const stages_;
    TwinProgram const program_;
    Fifos& fifos_;
    std::array<TwinLoop, loop_count>& loops_;
    TwinMemory const& memory_;
    CoreMemory& core_memory_;
    std::size_t state_ = 0;
    std::size_t entry_ = 0;  ///< of the master, if the state has one
    bool has_arrived_ = false;
    Cycles loop_step_ = 0;  ///< p, inside a loop
    std::size_t next_setup_ = 0;
    std::vector<Cycles> setup_began_;  ///< of the loop's setups so far
    struct WriteToCome {
        BramId bram;
        TwinPixel pixel;
        Cycles step;  ///< of the pipeline, bubbles among them
    };
    std::vector<WriteToCome> writes_;  ///< of the loop so far
    Cycles bubbles_ = 0;               ///< steps of the loop in which no iteration began because of them
    Cycles local_time_ = 0;            ///< T
    TwinProcess stats_;
};

/// AreaReciprocal as a shift register of Lw stages, which moves as a whole in each cycle or not at all.
class FlushingModel {
  public:
    FlushingModel(AcceleratorConfig const& config, TwinProgram const& program, Fifos& fifos)
        : stages_(fifo_of(config, FifoId::area_reciprocal).write_latency),
          interval_(reciprocal_interval(config)),
          area_(fifos[index_of(FifoId::area)]),
          reciprocal_(fifos[index_of(FifoId::area_reciprocal)]) {
        for (TwinState const& state : program) {
            if (state.accesses.front().kind == AccessKind::Read) {
                areas_.push_back(false);
            } else {
                areas_.back() = true;
            }
        }
    }

    bool is_finished() const { return next_ == areas_.size() && busy_steps_ == 0 && !holds_results(); }

    void run_cycle(Cycles cycle) {
        if (is_finished()) {
            return;
        }
        if (stages_.back() && reciprocal_.legal_from(AccessKind::Write) > cycle) {
            reciprocal_.count_stall(AccessKind::Write);
            ++stats_.full_stall;
            stats_.full_stalls.push_back(cycle);
            is_frozen_ = true;
            return;
        }
        if (stages_.back()) {
            reciprocal_.access(AccessKind::Write, cycle);
            end_ = is_frozen_ ? cycle : end_;
        }
        is_frozen_ = false;
        stages_.pop_back();
        stages_.push_front(read(cycle));
    }

    bool is_stuck() const {
        if (stages_.back()) {
            return reciprocal_.legal_from(AccessKind::Write) == never;
        }
        return !is_finished() && busy_steps_ == 0 && !holds_results() && area_.legal_from(AccessKind::Read) == never;
    }

    Cycles local_time() const { return local_time_; }

    TwinProcess stats() const {
        TwinProcess stats = stats_;
        stats.end_cycle = std::max(local_time_, end_);
        return stats;
    }

  private:
    bool holds_results() const { return std::find(stages_.begin(), stages_.end(), true) != stages_.end(); }

    /// Whether there is something to divide by: not in a bubble, nor of a triangle that is not drawn.
    bool read(Cycles cycle) {
        if (busy_steps_ > 0) {
            --busy_steps_;
            local_time_ = cycle + 1;
            return false;
        }
        if (next_ == areas_.size()) {
            return false;
        }
        if (area_.legal_from(AccessKind::Read) > cycle) {
            area_.count_stall(AccessKind::Read);
            ++stats_.empty_stall;
            stats_.empty_stalls.push_back(cycle);
            return false;
        }
        area_.access(AccessKind::Read, cycle);
        busy_steps_ = areas_[next_] ? interval_ - 1 : 0;
        local_time_ = cycle + 1;
        return areas_[next_++];
    }

    std::deque<bool> stages_;
    Cycles const interval_;
    Cycles busy_steps_ = 0;  ///< with the last area, in which no other is taken in
    FifoModel& area_;
    FifoModel& reciprocal_;
    std::vector<bool> areas_;  ///< by triangle: is drawn
    std::size_t next_ = 0;
    bool is_frozen_ = false;
    Cycles end_ = 0;         ///< of the last time it stood still
    Cycles local_time_ = 0;  ///< behind the last area
    TwinProcess stats_;
};

/// A process of either sort.
class AnyProcess {
  public:
    explicit AnyProcess(ProcessModel process) : model_(std::move(process)) {}
    explicit AnyProcess(FlushingModel process) : model_(std::move(process)) {}

    bool is_finished() const {
        return std::visit([](auto const& process) { return process.is_finished(); }, model_);
    }
    void run_cycle(Cycles cycle) {
        std::visit([cycle](auto& process) { process.run_cycle(cycle); }, model_);
    }
    bool is_stuck() const {
        return std::visit([](auto const& process) { return process.is_stuck(); }, model_);
    }
    Cycles local_time() const {
        return std::visit([](auto const& process) { return process.local_time(); }, model_);
    }
    TwinProcess stats() const {
        return std::visit([](auto const& process) { return process.stats(); }, model_);
    }

  private:
    std::variant<ProcessModel, FlushingModel> model_;
};

/// Writes of loops must leave the pipeline before its end, else the steps above would lose them.
void check_write_latency(AcceleratorConfig const& config, LoopId loop, FifoId fifo) {
    if (fifo_of(config, fifo).write_latency >= loop_of(config, loop).depth) {
        throw std::invalid_argument(std::string("write latency of ") + name_of(fifo) +
                                    " is beyond the end of its loop");
    }
}

void check(AcceleratorConfig const& config, Stimulus const& stimulus) {
    if (stimulus.is_posed()) {
        throw std::invalid_argument("the cycle twin has no vertex transform: give it triangles");
    }
    if (config.cores == 0) {
        throw std::invalid_argument("the cycle twin needs at least one core");
    }
    check_write_latency(config, LoopId::vertex, FifoId::vertex);
    for (FifoId const fifo : {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index, FifoId::edge_token}) {
        check_write_latency(config, LoopId::scan, fifo);
    }
    check_write_latency(config, LoopId::output, FifoId::edge_map);
    check_write_latency(config, LoopId::read, FifoId::observed_depth);
    check_write_latency(config, LoopId::read, FifoId::observed_edge);
}

struct SampleRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

SampleRange samples_of_core(std::size_t samples, std::size_t cores, std::size_t core) {
    std::size_t const per_core = ceil_div(samples, cores);
    return SampleRange{std::min(samples, core * per_core), std::min(samples, (core + 1) * per_core)};
}

/// One core: its FIFOs and processes.
class CoreModel {
  public:
    CoreModel(AcceleratorConfig const& config, Stimulus const& stimulus, SampleRange const& range,
              TwinMemory const& memory, CoreMemory core_memory, TwinResult& result)
        : range_(range),
          core_memory_(std::move(core_memory)),
          fifos_(make_fifos(config)),
          loops_(make_loops(config, memory)) {
        std::array<TwinProgram, module_count> programs;
        for (std::size_t sample = range.begin; sample < range.end; ++sample) {
            TwinSamplePrograms of_sample = programs_of_sample(config, stimulus, sample, memory);
            result.samples[sample].counters = of_sample.counters;
            core_memory_.add_sample(of_sample);
            for (std::size_t i = 0; i < module_count; ++i) {
                for (TwinState& state : of_sample.programs[i]) {
                    programs[i].push_back(std::move(state));
                }
            }
        }
        FifoConfig const reciprocal = fifo_of(config, FifoId::area_reciprocal);
        processes_.reserve(module_count);
        for (std::size_t i = 0; i < module_count; ++i) {
            bool const flushes =
                i == index_of(ModuleId::area_reciprocal) && !reciprocal.squeezes && reciprocal.write_latency > 0;
            if (flushes) {
                processes_.emplace_back(FlushingModel(config, programs[i], fifos_));
            } else {
                processes_.emplace_back(
                    ProcessModel(config, std::move(programs[i]), fifos_, loops_, memory, core_memory_));
            }
        }
    }
    CoreModel(CoreModel const&) = delete;  // its processes refer to its FIFOs
    CoreModel& operator=(CoreModel const&) = delete;
    CoreModel(CoreModel&&) = delete;
    CoreModel& operator=(CoreModel&&) = delete;
    ~CoreModel() = default;

    void run_cycle(Cycles cycle) {
        for (AnyProcess& process : processes_) {
            process.run_cycle(cycle);
        }
        for (FifoModel& fifo : fifos_) {
            fifo.end_cycle(cycle);
        }
    }

    bool is_finished() const {
        return std::all_of(processes_.begin(), processes_.end(),
                           [](AnyProcess const& process) { return process.is_finished(); });
    }

    /// All unfinished processes wait for one another: a process that only lets time pass, or waits for a token that
    /// is already under way, is not stuck.
    bool is_at_rest() const {
        return std::all_of(processes_.begin(), processes_.end(),
                           [](AnyProcess const& process) { return process.is_finished() || process.is_stuck(); });
    }

    /// A process that is at rest may still come to a loop, whose first bursts are asked for.
    bool is_still(Cycles cycle) const {
        return std::all_of(processes_.begin(), processes_.end(), [cycle](AnyProcess const& process) {
            return process.is_finished() || process.local_time() <= cycle;
        });
    }

    void collect(TwinResult& result) const {
        if (!is_finished()) {
            result.deadlock = true;
            for (AnyProcess const& process : processes_) {
                if (!process.is_finished()) {
                    result.deadlock_cycle = std::max(result.deadlock_cycle, process.local_time());
                }
            }
        }
        std::vector<Cycles> const& starts = fifos_[index_of(FifoId::sample_raster)].read_cycles();
        std::vector<Cycles> const& ends = fifos_[index_of(FifoId::result)].read_cycles();
        for (std::size_t i = 0; i < starts.size(); ++i) {
            result.samples[range_.begin + i].start_cycle = starts[i];
        }
        for (std::size_t i = 0; i < ends.size(); ++i) {
            result.samples[range_.begin + i].end_cycle = ends[i];
            result.total_cycles = std::max(result.total_cycles, ends[i] + 1);
        }
        result.loops.push_back(loops_);
        auto& fifo_table = result.fifos.emplace_back();
        for (std::size_t i = 0; i < fifo_count; ++i) {
            fifo_table[i] = fifos_[i].stats();
        }
        auto& process_table = result.processes.emplace_back();
        for (std::size_t i = 0; i < module_count; ++i) {
            process_table[i] = processes_[i].stats();
        }
    }

    std::array<TwinTraffic, master_count> traffic() const { return core_memory_.traffic(); }

  private:
    SampleRange const range_;
    CoreMemory core_memory_;
    Fifos fifos_;
    std::array<TwinLoop, loop_count> loops_;
    std::vector<AnyProcess> processes_;
};

using Cores = std::deque<CoreModel>;

/// Lets cycles 0, 1, 2, ... pass for these cores until nothing moves any more, outside the chip included.
void run_together(Cores& cores, TwinMemoryModel& memory) {
    auto const finished = [](CoreModel const& core) { return core.is_finished(); };
    auto const at_rest = [](CoreModel const& core) { return core.is_finished() || core.is_at_rest(); };
    for (Cycles cycle = 0; !std::all_of(cores.begin(), cores.end(), finished) || !memory.is_idle(); ++cycle) {
        for (CoreModel& core : cores) {
            core.run_cycle(cycle);
        }
        memory.end_cycle(cycle);
        auto const still = [cycle](CoreModel const& core) { return core.is_still(cycle); };
        if (memory.is_idle() && std::all_of(cores.begin(), cores.end(), at_rest) &&
            std::all_of(cores.begin(), cores.end(), still)) {
            break;
        }
    }
}

/// Cores first .. end - 1 in cycles of their own.
void run_cores(AcceleratorConfig const& config, Stimulus const& stimulus, TwinMemory const& memory, std::size_t first,
               std::size_t end, TwinResult& result) {
    TwinMemoryModel model(memory, config.clock_mhz);
    Cores cores;
    for (std::size_t core = first; core < end; ++core) {
        cores.emplace_back(config, stimulus, samples_of_core(stimulus.samples.size(), config.cores, core), memory,
                           CoreMemory(memory, config, model, core - first), result);
    }
    run_together(cores, model);
    for (CoreModel const& core : cores) {
        core.collect(result);
        if (memory.is_axi) {
            result.traffic.push_back(core.traffic());
        }
    }
    for (std::size_t port = 0; memory.is_axi && port < memory.ports; ++port) {
        result.port_beats.push_back(model.port_beats(port));
    }
    result.controller_ps += model.controller_ps();
}

}  // namespace

TwinResult run_twin(AcceleratorConfig const& config, Stimulus const& stimulus) {
    return run_twin(config, stimulus, memory_of(config));
}

TwinResult run_twin(AcceleratorConfig const& config, Stimulus const& stimulus, TwinMemory const& memory) {
    check(config, stimulus);
    TwinResult result;
    result.samples.resize(stimulus.samples.size());
    // Cores that share no memory share nothing.
    std::size_t const together = memory.is_axi ? config.cores : 1;
    for (std::size_t core = 0; core < config.cores; core += together) {
        run_cores(config, stimulus, memory, core, core + together, result);
    }
    result.load_cycles = load_cycles(memory, config.clock_mhz, stimulus, config.cores);
    result.total_cycles += result.load_cycles;
    return result;
}

}  // namespace faster::testing

#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/base/device/resources.hpp"
#include "dataflow/base/source_site.hpp"
#include "dataflow/core/machine/access_pattern.hpp"
#include "dataflow/core/memory/external_memory.hpp"

namespace dataflow {

/// Whether a part is there, and which configuration key decides that.
struct Condition {
    bool holds = true;
    std::string key;
};
using Conditions = std::vector<Condition>;

/// One end of a FIFO in a module: it reads it, or writes it. What the tokens are, the writing end says.
struct FifoEnd {
    std::string fifo;
    bool writes = false;
    Conditions conditions;
    std::string tokens;                   ///< "pixels from the reader to the filter", for the documentation
    unsigned bits = 0;                    ///< of a token, in wires
    std::uint64_t depth = 2;              ///< default of the FIFO, in tokens: of the writing end
    std::optional<Cycles> write_latency;  ///< default stage of the writing loop in which a token leaves
    std::optional<Cycles> read_stage;     ///< default stage of the reading loop in which a token is taken
    std::string loop;                     ///< the loop whose depth bounds the write latency or read stage; or empty
    bool may_keep_tokens = false;         ///< at the end of a run, unread: of the writing end
    bool makes_attempts = false;          ///< may access it without waiting
    bool flushes = false;                 ///< behind a flushing pipeline of its module, see timing::FlushingPipeline
    std::string latency_meaning;          ///< of such a pipeline, one sentence for the documentation
    std::uint64_t buffer_words = 0;       ///< of a ping-pong buffer, which it is then: see hands_over()
    enum class When { within_call, region_begins, call_begins, call_ends } when = When::within_call;  ///< with_calls()
    std::string sized_as;  ///< FIFO whose depth it has; otherwise, as hand-over, one

    FifoEnd& carries(std::string text) { return tokens = std::move(text), *this; }
    FifoEnd& of_bits(std::uint64_t wires) { return bits = static_cast<unsigned>(wires), *this; }
    FifoEnd& of_depth(std::uint64_t tokens_deep) { return depth = tokens_deep, *this; }
    FifoEnd& leaves(std::string its_loop, Cycles stage) {
        return loop = std::move(its_loop), write_latency = stage, *this;
    }
    /// Read by a loop that may take it in a later step than an iteration's first. Such a loop says it of all FIFOs that
    /// it reads, or names the others by also_reads().
    FifoEnd& taken(std::string its_loop, Cycles stage) { return loop = std::move(its_loop), read_stage = stage, *this; }
    /// Leaves a pipeline of so many stages that drains by itself, whatever its module reads. Such a module reads one
    /// FIFO, in a step of its own, then writes what that step yields, if anything, then lets a cycle pass; that again
    /// and again.
    FifoEnd& flushes_after(Cycles stages, std::string meaning) {
        return flushes = true, write_latency = stages, latency_meaning = std::move(meaning), *this;
    }
    /// Not a FIFO but a ping-pong buffer of so many words of block RAM, which its writer fills in one call, and its
    /// reader empties in one. The key `depth` says how many such buffers there are. Channel: PingPong.
    FifoEnd& hands_over(std::uint64_t words) { return buffer_words = words, *this; }
    /// Tokens may be left in the FIFO at the end of a run, which warns of them; otherwise they are an error.
    FifoEnd& keeps_tokens() { return may_keep_tokens = true, *this; }
    /// Accessed by read_nb() or write_nb(), or asked by empty() or full(), besides read() and write(). A loop that does
    /// so names all FIFOs that it accesses, by leaves(), taken(), writes_to() or also_reads().
    FifoEnd& non_blocking() { return makes_attempts = true, *this; }
    FifoEnd& only_if(Condition condition) { return conditions.push_back(std::move(condition)), *this; }
};

/// A module's end of the external memory, a master: what it reads there, or writes.
struct StreamDescription {
    std::string name;      ///< of the master, e.g. "vertex"
    bool writes = false;   ///< by steps that nobody waits for
    std::string loop;      ///< each iteration of which takes a token, or gives one; empty: steps do
    std::string contents;  ///< "rows of the table", for the documentation
    Conditions conditions;
    timing::Prefetch prefetch = timing::Prefetch::none;
    bool is_header = false;

    StreamDescription& brings(std::string text) { return contents = std::move(text), *this; }
    StreamDescription& taken_by(std::string its_loop) { return loop = std::move(its_loop), *this; }
    /// An iteration gives its token in the loop's last stage.
    StreamDescription& given_by(std::string its_loop) { return taken_by(std::move(its_loop)); }
    StreamDescription& prefetches(timing::Prefetch what) { return prefetch = what, *this; }
    /// Its tokens are headers of samples, which tell others what to fetch.
    StreamDescription& headers() { return is_header = true, *this; }
    StreamDescription& only_if(Condition condition) { return conditions.push_back(std::move(condition)), *this; }
};

/// What one iteration of a loop asks of one memory in its worst branch.
struct MemoryAccess {
    std::string memory;
    AccessPattern pattern;
};

/// In which stages of a loop an iteration reads and writes a memory, and how many words of it at most. A configuration
/// may do without reads or writes: none, then. The module has to tell the words (ProcessClock::write_distances).
struct MemoryStages {
    std::string memory;
    Cycles read = 0;
    Cycles write = 0;
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
};

struct LoopDescription {
    std::string name;  ///< within its module
    Conditions conditions;
    std::string task;        ///< "visits one pixel per iteration", for the documentation
    Cycles depth = 1;        ///< default number of pipeline stages
    Cycles extra_depth = 0;  ///< stages that other keys add
    bool is_pipelined = true, is_rewinding = false;
    Cycles entry_states = 0, exit_states = 0;  ///< default cycles before the first iteration, and behind the last
    Cycles interval = 1;                       ///< default initiation interval asked for
    Cycles recurrence = 1;                     ///< initiation interval that the design's own dependences demand
    std::vector<MemoryAccess> accesses;
    std::vector<MemoryStages> memory_stages;  ///< of memories whose dependences between iterations are looked after
    std::vector<std::string> writes;  ///< FIFOs that iterations write, but for those that say so: FifoEnd::leaves()
    std::vector<std::string> reads;   ///< FIFOs that iterations read, of a loop that writes as well; likewise: taken()
    std::string timed_by;             ///< "MODULE.LOOP" whose keys time it; empty: keys of its own

    LoopDescription& does(std::string text) { return task = std::move(text), *this; }
    LoopDescription& of_depth(Cycles stages, Cycles more = 0) { return depth = stages, extra_depth = more, *this; }
    /// Not pipelined: an iteration takes so many states, of a cycle each, and is over when the next one begins. There
    /// is a state before the first iteration and one behind the last. States are numbered from 0 on, like stages.
    LoopDescription& of_states(Cycles states) {
        return is_pipelined = false, depth = states, enters_in(1).leaves_in(1);
    }
    LoopDescription& enters_in(Cycles states) { return entry_states = states, *this; }
    LoopDescription& leaves_in(Cycles states) { return exit_states = states, *this; }
    /// All of its process; the next call's iterations follow at once, and the pipeline drains when there is none.
    LoopDescription& rewinds() { return is_rewinding = true, *this; }
    LoopDescription& of_ii(Cycles cycles) { return interval = cycles, *this; }
    LoopDescription& recurs_every(Cycles cycles) { return recurrence = cycles, *this; }
    LoopDescription& accesses_memory(std::string memory, AccessPattern pattern) {
        return accesses.push_back({std::move(memory), std::move(pattern)}), *this;
    }
    LoopDescription& in_stages(MemoryStages stages) { return memory_stages.push_back(std::move(stages)), *this; }
    LoopDescription& writes_to(std::vector<std::string> fifos) { return writes = std::move(fifos), *this; }
    LoopDescription& also_reads(std::vector<std::string> fifos) { return reads = std::move(fifos), *this; }
    LoopDescription& with_keys_of(std::string loop) { return timed_by = std::move(loop), *this; }
    LoopDescription& only_if(Condition condition) { return conditions.push_back(std::move(condition)), *this; }
};

/// A block RAM of `rows` x `cols` words, row by row.
struct MemoryDescription {
    std::string name;
    Conditions conditions;
    std::string contents;  ///< "edge bits of the window", for the documentation
    std::string partition_source = "HLS array_partition";
    std::uint64_t rows = 1;
    std::uint64_t cols = 1;
    std::uint64_t bits = 1;     ///< of a word; 0: there is no such memory
    std::uint64_t buffers = 1;  ///< how often all of it is there
    std::string size_key;       ///< configuration key that is both, rows and cols; or empty
    bool is_loaded = false;     ///< with data from outside, before an iteration begins; listed behind all others
    std::uint64_t copies = 0;   ///< of it, which all cores share; 0: each core has its own
    std::string reader;         ///< module that reads it out, if not the one that describes it

    MemoryDescription& holds(std::string text) { return contents = std::move(text), *this; }
    MemoryDescription& of_words(std::uint64_t its_rows, std::uint64_t its_cols, std::uint64_t word_bits) {
        return rows = its_rows, cols = its_cols, bits = word_bits, *this;
    }
    MemoryDescription& sized_by(std::string key) { return size_key = std::move(key), *this; }
    MemoryDescription& in_buffers(std::uint64_t number) { return buffers = number, *this; }
    MemoryDescription& loaded_before() { return is_loaded = true, *this; }
    MemoryDescription& shared_in_copies(std::uint64_t number) { return copies = number, *this; }
    MemoryDescription& read_out_by(std::string module) { return reader = std::move(module), *this; }
    MemoryDescription& only_if(Condition condition) { return conditions.push_back(std::move(condition)), *this; }
};

/// A memory without ports to count: rows kept beside a block RAM. It only takes room.
struct LineBuffer {
    std::string name;
    std::uint64_t words = 0;
    std::uint64_t bits = 0;
};

/// Work that a module does between loops, or beside them, and that takes a time of its own.
struct SetupDescription {
    Cycles depth = 1;              ///< default number of cycles
    Cycles extra = 0;              ///< cycles that other keys add
    std::string meaning;           ///< one sentence, for the documentation
    std::string activity;          ///< "preparing rows", for reports
    std::string before_loop;       ///< the loop before whose keys its key stands
    std::string one_per_token_of;  ///< FIFO with a write for every setup; empty: the process counts what it waits for
};

/// A whole number that decides what a module does, and not only when: a variant. The module reads it by its name,
/// ProcessClock::number().
struct NumberDescription {
    std::string name;     ///< within its module
    std::string meaning;  ///< one sentence, for the documentation
    std::string unit;
    std::uint64_t value = 1;  ///< default
    std::uint64_t least = 1;
    std::uint64_t most = 1'000'000;

    NumberDescription& means(std::string text) { return meaning = std::move(text), *this; }
    NumberDescription& in(std::string its_unit) { return unit = std::move(its_unit), *this; }
    NumberDescription& is(std::uint64_t by_default) { return value = by_default, *this; }
    NumberDescription& within(std::uint64_t its_least, std::uint64_t its_most) {
        return least = its_least, most = its_most, *this;
    }
};

/// One module: what there is of it besides its function. A module makes it of its configuration, in one function beside
/// its process, and names everything that any configuration can have, with the conditions under which it is there.
/// Ends stand in the program order of a step.
class ModuleDescription {
  public:
    /// `site`: the line of the source where the module is described.
    explicit ModuleDescription(std::string module, SourceSite site = SourceSite::here())
        : name(std::move(module)), described_at(site) {}

    FifoEnd& reads_from(std::string fifo) { return add_end(std::move(fifo), false); }
    FifoEnd& writes_to(std::string fifo) { return add_end(std::move(fifo), true); }
    /// At most one of a module is there: read from the external memory, or written to it.
    StreamDescription& fetches(std::string master) { return add_stream(std::move(master), false); }
    StreamDescription& stores(std::string master) { return add_stream(std::move(master), true); }
    LoopDescription& loop(std::string its_name) {
        loops.emplace_back().name = std::move(its_name);
        return loops.back();
    }
    NumberDescription& number(std::string its_name) {
        numbers.emplace_back().name = std::move(its_name);
        return numbers.back();
    }
    MemoryDescription& memory(std::string its_name) {
        memories.emplace_back().name = std::move(its_name);
        return memories.back();
    }
    void line_buffer(LineBuffer buffer) { line_buffers.push_back(std::move(buffer)); }
    void only_if(Condition condition) { conditions.push_back(std::move(condition)); }

    std::string name;
    SourceSite described_at;
    Conditions conditions;
    std::vector<FifoEnd> ends;
    std::vector<StreamDescription> streams;
    std::vector<LoopDescription> loops;
    std::vector<NumberDescription> numbers;
    std::vector<MemoryDescription> memories;
    std::vector<LineBuffer> line_buffers;
    std::optional<SetupDescription> setup;
    bool stamps_look_back = false;  ///< a stamp notes the last cycle that has passed, not the one to come

  private:
    FifoEnd& add_end(std::string fifo, bool writes) {
        ends.emplace_back().fifo = std::move(fifo);
        ends.back().writes = writes;
        return ends.back();
    }
    StreamDescription& add_stream(std::string master, bool writes) {
        streams.emplace_back().name = std::move(master);
        streams.back().writes = writes;
        return streams.back();
    }
};

struct Machine;
/// What a core of a machine takes of the device.
using TellResources = std::function<ToldResources(Machine const&)>;

/// A core: its modules, and the FIFOs that join them, in the order of their rows in tables.
struct CoreDescription {
    struct Pace {
        std::string driver;  ///< module that sets the pace; empty: none does
        struct Follower {
            std::string module;
            std::string anchor;  ///< FIFO between it and the driver
        };
        std::vector<Follower> followers;
    };

    std::vector<ModuleDescription> modules;
    std::vector<std::string> fifos;
    std::string begins;  ///< module whose stamps begin samples
    std::string ends;    ///< module whose stamps end them
    /// The run is over with the last sample, whatever modules do after that: what they prepare for samples that do not
    /// come. Otherwise all that they do counts.
    bool is_over_with_last_sample = false;
    bool has_calls = false;  ///< its modules tell when a call of theirs, which is a sample, begins: with_calls()
    std::string cores_are = "cores";  ///< what reports call cores
    std::string remark;               ///< what reports say of the machine besides, e.g. "window 200 x 200 px"
    Pace pace;                        ///< about speed of simulation only, see timing::Lead
    TellResources resources;          ///< none: FIFOs and memories are counted, modules are not
};

}  // namespace dataflow

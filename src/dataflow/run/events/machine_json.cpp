#include "dataflow/run/events/machine_json.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

namespace dataflow::events {

namespace {

using Entries = replay::RecordedMemory::Entries;
using timing::MemoryBlock;

constexpr std::uint64_t most = std::uint64_t{1} << 42;         // of any number, so that none overflows
constexpr std::uint64_t most_tokens = std::uint64_t{1} << 28;  // of a block, so that their cycles can be kept

/// Visits the fields of a block in the order in which they are written.
template <class Block, class Visit> void each_field(Block& block, Visit visit) {
    for (auto* const field : {&block.address, &block.bytes, &block.lead, &block.token_bytes, &block.tokens, &block.rows,
                              &block.first_row, &block.fetched_rows, &block.pitch})
        visit(*field);
}

Json block_json(MemoryBlock const& block) {
    Json fields = Json::array();
    each_field(block, [&fields](std::uint64_t field) { fields.push_back(field); });
    return fields;
}

Json entries_json(Entries const& entries) {
    Json all = Json::array();
    for (timing::MemoryEntry const& entry : entries) {
        Json blocks = Json::array();
        for (MemoryBlock const& block : entry.blocks)
            blocks.push_back(block_json(block));
        all.push_back(std::move(blocks));
    }
    return all;
}

void require(bool holds) {
    if (!holds)
        throw std::invalid_argument("what was fetched from memory cannot be");
}

/// What is fetched of a row is of its tokens, and the rows are there.
bool makes_sense(MemoryBlock const& block) {
    bool const has_tokens = block.token_bytes > 0 && block.tokens <= most / block.token_bytes &&
                            block.tokens <= most_tokens / (block.rows + 1);
    return has_tokens && block.lead <= block.tokens * block.token_bytes &&
           block.bytes <= block.tokens * block.token_bytes - block.lead && block.first_row <= block.rows &&
           block.fetched_rows <= block.rows - block.first_row && block.pitch <= most / (block.rows + 1);
}

MemoryBlock read_block(Json const& json) {
    MemoryBlock block;
    std::size_t i = 0;
    each_field(block, [&](std::uint64_t& field) {
        field = json.at(i++).get<std::uint64_t>();
        require(field < most);
    });
    require(i == json.size() && makes_sense(block));
    return block;
}

Entries read_entries(Json const& json) {
    Entries entries;
    for (Json const& blocks : json) {
        entries.emplace_back();
        for (Json const& block : blocks)
            entries.back().blocks.push_back(read_block(block));
    }
    return entries;
}

Json site_json(SourceSite const& site) { return {site.file, site.line}; }

Json ports_json(timing::ProcessTiming const& process) {
    Json ports = Json::array();
    for (unsigned i = 0; i < process.port_count(); ++i)
        ports.push_back({{process.fifo(i).is_memory() ? "memory" : "fifo", process.fifo(i).name()},
                         {"access", process.writes(i) ? "write" : "read"},
                         {"source", site_json(process.port_site(i))}});
    return ports;
}

Json loops_json(timing::ProcessTiming const& process) {
    Json loops = Json::array();
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        Json writes = Json::array(), reads = Json::array();
        for (timing::LoopWrite const& write : process.loops()[i].writes)
            writes.push_back(write.port);
        for (timing::LoopRead const& read : process.loops()[i].reads)
            reads.push_back(read.port);
        loops.push_back({{"loop", process.loops()[i].name},
                         {"writes", std::move(writes)},
                         {"source", site_json(process.loop_site(i))}});
        if (!reads.empty())
            loops.back()["reads"] = std::move(reads);
    }
    return loops;
}

/// Builds a run's blueprint.
class MachineReader {
  public:
    MachineReader(Machine const& machine, replay::RecordedRun& run) : machine_(machine), run_(run) {
        run_.blueprint = std::make_unique<timing::CoreTiming>();
        for (MachineFifo const& fifo : machine_.fifos) {
            timing::FifoShape shape;
            shape.name = fifo.name;
            run_.blueprint->add_fifo(shape);
        }
        for (std::size_t const i : streams_of(machine_))
            run_.blueprint->add_stream(machine_.streams[i].name, machine_.streams[i].enters_by());
    }

    void read_process(Json const& json) {
        timing::ProcessTiming& process = run_.blueprint->add_process(json.at("process").get<std::string>());
        if (process.index() >= machine_.processes.size() || process.name() != machine_.processes[process.index()].name)
            throw std::invalid_argument("process " + process.name() + " out of order");
        for (Json const& port : json.at("ports"))
            read_port(port, process);
        for (Json const& loop : json.at("loops"))
            read_loop(loop, process);
    }

  private:
    void read_port(Json const& json, timing::ProcessTiming& process) {
        if (json.contains("memory")) {
            read_stream(json, process);
            return;
        }
        std::size_t const number = number_of_fifo(json.at("fifo").get<std::string>());
        MachineFifo const& described = machine_.fifos[number];
        bool const writes = json.at("access") == "write";
        if ((writes ? described.writer : described.reader) != process.index() ||
            !taken_[writes ? 1 : 0].insert(number).second)
            throw std::invalid_argument("process " + process.name() + " is at no such end of " + described.name);
        timing::FifoTiming& fifo = run_.blueprint->fifo(number);
        unsigned const port = writes ? process.add_writes(fifo) : process.add_reads(fifo);
        process.note_site(port, read_site(json.at("source")));
    }

    void read_stream(Json const& json, timing::ProcessTiming& process) {
        std::vector<std::size_t> const streams = streams_of(machine_);
        for (std::size_t i = 0; i < streams.size() && process.stream() == nullptr; ++i)
            if (machine_.streams[streams[i]].process == process.index() &&
                machine_.streams[streams[i]].name == json.at("memory"))
                process.note_site(process.add_stream(run_.blueprint->stream(i)), read_site(json.at("source")));
        if (process.stream() == nullptr)
            throw std::invalid_argument("process " + process.name() + " has no such end of the memory");
    }

    /// Whether iterations of the loop take tokens from memory.
    bool uses_memory(std::string const& loop, timing::ProcessTiming const& process) const {
        return process.stream() != nullptr &&
               std::any_of(machine_.streams.begin(), machine_.streams.end(), [&](MachineStream const& stream) {
                   return stream.is_present && !stream.writes && stream.process == process.index() &&
                          stream.loop == loop;
               });
    }

    void read_loop(Json const& json, timing::ProcessTiming& process) {
        timing::LoopShape shape;
        shape.name = json.at("loop").get<std::string>();
        auto const described = std::find_if(machine_.loops.begin(), machine_.loops.end(), [&](MachineLoop const& loop) {
            return shape.name == loop.name && loop.process == process.index();
        });
        if (described == machine_.loops.end())
            throw std::invalid_argument("unknown loop " + shape.name);
        shape.interlock_spans = described->shape().interlock_spans;
        shape.makes_attempts = described->makes_attempts;
        for (Json const& write : json.at("writes")) {
            auto const port = write.get<unsigned>();
            if (port >= process.port_count() || !process.writes(port))
                throw std::invalid_argument("loop " + shape.name + " writes no such port");
            shape.writes.push_back({port, 0});
        }
        for (Json const& read : json.value("reads", Json::array())) {
            auto const port = read.get<unsigned>();
            if (port >= process.port_count() || process.writes(port))
                throw std::invalid_argument("loop " + shape.name + " reads no such port");
            shape.reads.push_back({port, 0});
        }
        shape.uses_memory = uses_memory(shape.name, process);
        unsigned const loop = process.add_loop(shape);
        process.note_loop_site(loop, read_site(json.at("source")));
    }

    std::size_t number_of_fifo(std::string const& name) const {
        for (std::size_t i = 0; i < machine_.fifos.size(); ++i)
            if (machine_.fifos[i].name == name)
                return i;
        throw std::invalid_argument("unknown part " + name);
    }

    SourceSite read_site(Json const& json) {
        run_.source_files.push_back(json.at(0).get<std::string>());
        return {run_.source_files.back().c_str(), json.at(1).get<unsigned>()};
    }

    Machine const& machine_;
    replay::RecordedRun& run_;
    std::array<std::set<std::size_t>, 2> taken_;  ///< FIFOs that are read, that are written
};

}  // namespace

Json memory_json(replay::RecordedMemory const& memory) {
    Json json{{"entries", Json::array()}, {"loaded", Json::array()}};
    for (std::vector<Entries> const& masters : memory.entries) {
        Json sample = Json::array();
        for (Entries const& entries : masters)
            sample.push_back(entries_json(entries));
        json["entries"].push_back(std::move(sample));
    }
    for (timing::LoadedRange const& range : memory.loaded)
        json["loaded"].push_back({range.address, range.bytes, range.copies});
    return json;
}

void read_memory(Json const& index, Machine const& machine, std::size_t samples, replay::RecordedRun& run) {
    if (!machine.external_memory)
        return;
    Json const& json = index.at("memory");
    replay::RecordedMemory& memory = run.memory.emplace();
    memory.lead = machine.lead;
    for (Json const& sample : json.at("entries")) {
        memory.entries.emplace_back();
        for (Json const& entries : sample)
            memory.entries.back().push_back(read_entries(entries));
        require(memory.entries.back().size() == streams_of(machine).size());
    }
    for (Json const& range : json.at("loaded")) {
        memory.loaded.push_back(
            {range.at(0).get<std::uint64_t>(), range.at(1).get<std::uint64_t>(), range.at(2).get<std::uint64_t>()});
        require(memory.loaded.back().address < most && memory.loaded.back().bytes < most);
    }
    require(memory.entries.size() == samples);
}

Json machine_json(timing::CoreTiming const& blueprint) {
    Json processes = Json::array();
    for (timing::ProcessTiming const& process : blueprint.processes())
        processes.push_back(
            {{"process", process.name()}, {"ports", ports_json(process)}, {"loops", loops_json(process)}});
    return processes;
}

void read_machine(Json const& json, Machine const& machine, replay::RecordedRun& run) {
    MachineReader reader(machine, run);
    for (Json const& process : json)
        reader.read_process(process);
    if (run.blueprint->processes().size() != machine.process_places())
        throw std::invalid_argument("missing processes");
    auto const has_stream = [](timing::ProcessTiming const& process) { return process.stream() != nullptr; };
    std::deque<timing::ProcessTiming> const& processes = run.blueprint->processes();
    if (static_cast<std::size_t>(std::count_if(processes.begin(), processes.end(), has_stream)) !=
        streams_of(machine).size())
        throw std::invalid_argument("missing ends of the memory");
}

}  // namespace dataflow::events

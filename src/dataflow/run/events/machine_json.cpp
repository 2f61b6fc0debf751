#include "dataflow/run/events/machine_json.hpp"

#include <memory>
#include <stdexcept>

#include "dataflow/core/machine/build_core.hpp"

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
        ports.push_back({{process.fifo(i).is_stream() ? "memory" : "fifo", process.fifo(i).name()},
                         {"access", process.writes(i) ? "write" : "read"},
                         {"source", site_json(process.port_site(i))}});
    return ports;
}

Json numbers_of(timing::Ports ports, timing::ProcessTiming const& process) {
    Json numbers = Json::array();
    for (unsigned port = 0; port < process.port_count(); ++port)
        if (ports.has(port))
            numbers.push_back(port);
    return numbers;
}

Json loops_json(timing::ProcessTiming const& process) {
    Json loops = Json::array();
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        Json writes = Json::array(), reads = Json::array();
        for (timing::LoopAccess const& write : process.loops()[i].writes)
            writes.push_back(write.port);
        for (timing::LoopAccess const& read : process.loops()[i].reads)
            reads.push_back(read.port);
        loops.push_back({{"loop", process.loops()[i].name},
                         {"writes", std::move(writes)},
                         {"source", site_json(process.loop_site(i))}});
        if (!reads.empty())
            loops.back()["reads"] = std::move(reads);
        timing::LoopNotes const& told = process.notes(i);
        for (auto const& [name, ports] : {std::pair("first_reads", told.first), std::pair("ends", told.ends)})
            if (!ports.is_empty())
                loops.back()[name] = numbers_of(ports, process);
    }
    return loops;
}

Json process_json(timing::ProcessTiming const& process) {
    return {{"process", process.name()}, {"ports", ports_json(process)}, {"loops", loops_json(process)}};
}

/// Compares what a file says of a process's ports and loops with the machine's, and takes what only its source tells.
class SourceReader {
  public:
    explicit SourceReader(replay::RecordedRun& run) : run_(run) {}

    void read(Json const& json, timing::ProcessTiming& process) {
        if (without_source(json) != without_source(process_json(process)))
            throw std::invalid_argument("process " + process.name() + " has other ports or loops");
        for (unsigned port = 0; port < process.port_count(); ++port)
            process.note_site(port, read_site(json.at("ports").at(port).at("source")));
        for (unsigned loop = 0; loop < process.loops().size(); ++loop)
            read_loop(json.at("loops").at(loop), loop, process);
    }

  private:
    static Json without_source(Json process) {
        for (char const* const parts : {"ports", "loops"})
            for (Json& part : process.at(parts))
                for (char const* const told : {"source", "first_reads", "ends"})
                    part.erase(told);
        return process;
    }

    void read_loop(Json const& json, unsigned loop, timing::ProcessTiming& process) {
        process.note_loop_site(loop, read_site(json.at("source")));
        process.notes(loop).first = read_ports(json, "first_reads", process);
        process.notes(loop).ends = read_ports(json, "ends", process);
    }

    static timing::Ports read_ports(Json const& json, char const* name, timing::ProcessTiming const& process) {
        timing::Ports ports;
        for (Json const& port : json.value(name, Json::array())) {
            auto const number = port.get<std::size_t>();
            if (number >= process.port_count())
                throw std::invalid_argument("process " + process.name() + " has other ports");
            ports = ports | timing::Ports::of(static_cast<unsigned>(number));
        }
        return ports;
    }

    SourceSite read_site(Json const& json) {
        run_.source_files.push_back(json.at(0).get<std::string>());
        return {run_.source_files.back().c_str(), json.at(1).get<unsigned>()};
    }

    replay::RecordedRun& run_;
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
        processes.push_back(process_json(process));
    return processes;
}

void read_machine(Json const& json, Machine const& machine, replay::RecordedRun& run) {
    run.blueprint = std::make_unique<timing::CoreTiming>();
    build_core(*run.blueprint, machine);
    run.lead = machine.lead;
    if (json.size() != run.blueprint->processes().size())
        throw std::invalid_argument("it has other processes");
    SourceReader source(run);
    for (std::size_t process = 0; process < json.size(); ++process)
        source.read(json.at(process), run.blueprint->process(process));
}

}  // namespace dataflow::events

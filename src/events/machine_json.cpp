#include "events/machine_json.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "config/machine.hpp"

namespace faster::events {

namespace {

Json site_json(SourceSite const& site) { return {site.file, site.line}; }

Json ports_json(timing::ProcessTiming const& process) {
    Json ports = Json::array();
    for (unsigned i = 0; i < process.port_count(); ++i)
        ports.push_back({{"fifo", process.fifo(i).name()},
                         {"access", process.writes(i) ? "write" : "read"},
                         {"source", site_json(process.port_site(i))}});
    return ports;
}

Json loops_json(timing::ProcessTiming const& process) {
    Json loops = Json::array();
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        Json writes = Json::array();
        for (timing::LoopWrite const& write : process.loops()[i].writes)
            writes.push_back(write.port);
        loops.push_back({{"loop", process.loops()[i].name},
                         {"writes", std::move(writes)},
                         {"source", site_json(process.loop_site(i))}});
        if (!process.loops()[i].reads.empty())
            loops.back()["reads"] = process.loops()[i].reads;
    }
    return loops;
}

template <std::size_t N> std::size_t number_of(std::string const& name, std::array<char const*, N> const& names) {
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw std::invalid_argument("unknown part " + name);
    return static_cast<std::size_t>(found - names.begin());
}

/// Builds a run's blueprint.
class MachineReader {
  public:
    MachineReader(Parts const& parts, retiming::RecordedRun& run) : parts_(parts), run_(run) {
        run_.blueprint = std::make_unique<timing::CoreTiming>();
        for (char const* name : fifo_names) {
            timing::FifoShape shape;
            shape.name = name;
            run_.blueprint->add_fifo(shape);
        }
    }

    void read_process(Json const& json) {
        timing::ProcessTiming& process = run_.blueprint->add_process(json.at("process").get<std::string>());
        if (process.index() >= module_count || process.name() != module_names[process.index()])
            throw std::invalid_argument("process " + process.name() + " out of order");
        for (Json const& port : json.at("ports"))
            read_port(port, process);
        for (Json const& loop : json.at("loops"))
            read_loop(loop, process);
    }

  private:
    void read_port(Json const& json, timing::ProcessTiming& process) {
        std::size_t const number = number_of(json.at("fifo").get<std::string>(), fifo_names);
        bool const writes = json.at("access") == "write";
        FifoEnds const ends = ends_of(parts_, static_cast<FifoId>(number));
        if (index_of(writes ? ends.writer : ends.reader) != process.index() ||
            !taken_[writes ? 1 : 0].insert(number).second)
            throw std::invalid_argument("process " + process.name() + " is at no such end of " + fifo_names[number]);
        timing::FifoTiming& fifo = run_.blueprint->fifo(number);
        unsigned const port = writes ? process.add_writes(fifo) : process.add_reads(fifo);
        process.note_site(port, read_site(json.at("source")));
    }

    void read_loop(Json const& json, timing::ProcessTiming& process) {
        timing::LoopShape shape;
        shape.name = json.at("loop").get<std::string>();
        auto const is_known = [&](LoopName const& loop) {
            return shape.name == loop.name && index_of(loop.module) == process.index();
        };
        if (std::none_of(loop_names.begin(), loop_names.end(), is_known))
            throw std::invalid_argument("unknown loop " + shape.name);
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
            shape.reads.push_back(port);
        }
        unsigned const loop = process.add_loop(shape);
        process.note_loop_site(loop, read_site(json.at("source")));
    }

    SourceSite read_site(Json const& json) {
        run_.source_files.push_back(json.at(0).get<std::string>());
        return {run_.source_files.back().c_str(), json.at(1).get<unsigned>()};
    }

    Parts parts_;
    retiming::RecordedRun& run_;
    std::array<std::set<std::size_t>, 2> taken_;  ///< FIFOs that are read, that are written
};

}  // namespace

Json machine_json(timing::CoreTiming const& blueprint) {
    Json processes = Json::array();
    for (timing::ProcessTiming const& process : blueprint.processes())
        processes.push_back(
            {{"process", process.name()}, {"ports", ports_json(process)}, {"loops", loops_json(process)}});
    return processes;
}

void read_machine(Json const& machine, Parts const& parts, retiming::RecordedRun& run) {
    MachineReader reader(parts, run);
    for (Json const& process : machine)
        reader.read_process(process);
    if (run.blueprint->processes().size() != process_places(parts))
        throw std::invalid_argument("missing processes");
}

}  // namespace faster::events

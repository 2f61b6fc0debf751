#include "dataflow/tools/schedule/scheduled_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/run/config/key_names.hpp"

namespace dataflow::schedule {

namespace {

using Found = std::vector<ReportLoop const*>;

class Scheduler {
  public:
    Scheduler(Machine const& machine, SynthesisReport const& report, NameMap const& names)
        : machine_(machine), report_(report), names_(names) {
        require_known();
    }

    Schedule schedule() {
        for (std::size_t const number : loops_of(machine_))
            if (ReportLoop const* const loop = counterpart(number)) {
                used_.insert(loop);
                add(number, *loop);
            }
        for (ReportFifo const& fifo : report_.fifos)
            add(fifo);
        for (ReportLoop const& loop : report_.loops)
            if (used_.count(&loop) == 0 && !loop.is_around_others)
                result_.without.push_back(loop.full_name() + " of the report: no loop of the design");
        return std::move(result_);
    }

  private:
    void require_known() const {
        std::vector<std::string> loops;
        std::vector<std::string> reported;
        std::vector<std::string> fifos;
        for (std::size_t const number : loops_of(machine_))
            loops.push_back(machine_.loop_name(number));
        for (ReportLoop const& loop : report_.loops)
            reported.push_back(loop.full_name());
        for (std::size_t const number : fifos_of(machine_))
            fifos.push_back(machine_.fifos[number].name);
        auto const require = [](std::string const& name, std::string const& what, auto const& known) {
            if (std::find(known.begin(), known.end(), name) == known.end())
                throw InputError("--map: " + name + " is not there, expected a " + what + did_you_mean(name, known));
        };
        for (auto const& [ours, theirs] : names_.loops) {
            require(ours, "loop of the design", loops);
            require(theirs, "loop of the report", reported);
        }
        for (auto const& [ours, theirs] : names_.fifos)
            require(ours, "FIFO of the design", fifos);
    }

    static bool is_of(ReportLoop const& loop, std::string const& module) {
        return loop.module == module || loop.module.rfind(module + "_", 0) == 0;
    }

    ReportLoop const* counterpart(std::size_t number) {
        MachineLoop const& loop = machine_.loops[number];
        MachineProcess const& process = machine_.processes[loop.process];
        auto const mapped = names_.loops.find(machine_.loop_name(number));
        Found same_name;
        Found of_module;
        for (ReportLoop const& one : report_.loops) {
            if (mapped != names_.loops.end() && one.full_name() == mapped->second)
                return &one;
            if (!is_of(one, process.name) || one.is_around_others)
                continue;
            of_module.push_back(&one);
            if (one.name == loop.name)
                same_name.push_back(&one);
        }
        if (same_name.size() == 1)
            return same_name.front();
        if (same_name.empty() && of_module.size() == 1 && process.loops.size() == 1)
            return of_module.front();
        result_.without.push_back(machine_.loop_name(number) +
                                  (same_name.empty() ? " of the design: no loop of the report"
                                                     : " of the design: several loops of the report") +
                                  ", expected a line in --map");
        return nullptr;
    }

    void set(std::string key, std::uint64_t assumed, std::uint64_t scheduled, std::string source) {
        result_.keys.push_back({std::move(key), assumed, scheduled, std::move(source)});
    }

    void add(std::size_t number, ReportLoop const& of_report) {
        MachineLoop const& loop = machine_.loops[number];
        bool const is_pipelined = of_report.ii.has_value();
        std::optional<std::uint64_t> const length = is_pipelined ? of_report.depth : of_report.iteration_latency;
        if (!length || *length == 0 || (is_pipelined && (*of_report.ii == 0 || !loop.is_pipelined))) {
            result_.without.push_back(of_report.full_name() + " of the report: " +
                                      (is_pipelined && !loop.is_pipelined ? "pipelined, which the design's is not"
                                                                          : "no interval or depth that it knows"));
            return;
        }
        auto const key = [&](char const* field) { return loop_key_name(loop.timed_by, field); };
        if (!loop.is_pipelined) {
            set(key("states"), loop.depth, *length, of_report.full_name() + " IterationLatency");
        } else {
            char const* const source = is_pipelined ? " PipelineII" : " IterationLatency, not pipelined";
            set(key("ii"), loop.interval.target, is_pipelined ? *of_report.ii : *length,
                of_report.full_name() + source);
            set(key("depth"), loop.depth, *length, of_report.full_name() + (is_pipelined ? " PipelineDepth" : source));
        }
        add_stages(loop, *length);
    }

    void add_stages(MachineLoop const& loop, std::uint64_t length) {
        for (std::size_t const number : loop.writes) {
            MachineFifo const& fifo = machine_.fifos[number];
            bool const was_last = fifo.write_latency + 1 == loop.depth;
            if (was_last || fifo.write_latency >= length)
                set(fifo_key_name(fifo.name, "write_latency"), fifo.write_latency, length - 1,
                    "assumed: the last stage");
        }
        for (std::size_t const number : loop.reads) {
            MachineFifo const& fifo = machine_.fifos[number];
            if (fifo.read_stage >= length)
                set(fifo_key_name(fifo.name, "read_stage"), fifo.read_stage, length - 1, "assumed: the last stage");
        }
    }

    void add(ReportFifo const& of_report) {
        for (std::size_t const number : fifos_of(machine_)) {
            MachineFifo const& fifo = machine_.fifos[number];
            auto const mapped = names_.fifos.find(fifo.name);
            if (of_report.depth > 0 && of_report.name == (mapped == names_.fifos.end() ? fifo.name : mapped->second)) {
                set(fifo_key_name(fifo.name, "depth"), fifo.depth, of_report.depth, of_report.name);
                return;
            }
        }
        result_.without.push_back(of_report.name + " of the report: no FIFO of the design");
    }

    Machine const& machine_;
    SynthesisReport const& report_;
    NameMap const& names_;
    std::set<ReportLoop const*> used_;
    Schedule result_;
};

std::map<std::string, std::string> pairs_of(std::string const& file, YAML::Node const& map,
                                            std::string const& section) {
    std::map<std::string, std::string> pairs;
    if (!map.IsMap())
        throw InputError(
            fmt::format("{}:{}: {} is no map, expected NAME: NAME OF THE REPORT", file, map.Mark().line + 1, section));
    for (auto const& pair : map) {
        if (!pair.first.IsScalar() || !pair.second.IsScalar())
            throw InputError(fmt::format("{}:{}: {} has something other than names, expected NAME: NAME OF THE REPORT",
                                         file, pair.first.Mark().line + 1, section));
        pairs[pair.first.Scalar()] = pair.second.Scalar();
    }
    return pairs;
}

}  // namespace

NameMap read_name_map(std::string const& file) {
    NameMap names;
    YAML::Node const root = load_document(file, "a map of names", {"loops", "fifos"});
    if (root.IsNull())
        return names;
    if (!root.IsMap())
        throw InputError(file + ": no map, expected loops: and fifos:");
    for (auto const& section : root) {
        std::string const name = section.first.IsScalar() ? section.first.Scalar() : "";
        if (name != "loops" && name != "fifos")
            throw InputError(
                fmt::format("{}:{}: section {}, expected loops or fifos", file, section.first.Mark().line + 1, name));
        (name == "loops" ? names.loops : names.fifos) = pairs_of(file, section.second, name);
    }
    return names;
}

Schedule schedule_of(Machine const& machine, SynthesisReport const& report, NameMap const& names) {
    return Scheduler(machine, report, names).schedule();
}

}  // namespace dataflow::schedule

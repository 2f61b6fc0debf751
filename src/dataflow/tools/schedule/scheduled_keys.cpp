#include "dataflow/tools/schedule/scheduled_keys.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/key_ranges.hpp"

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
        for (std::size_t const number : fifos_of(machine_)) {
            add_stage(number, true);
            add_stage(number, false);
        }
        for (ReportFifo const& fifo : report_.fifos)
            add(fifo);
        for (ReportLoop const& loop : report_.loops)
            if (used_.count(&loop) == 0 && !loop.is_around_others)
                leave(loop.full_name() + " of the report: no loop of the design");
        return std::move(result_);
    }

  private:
    void require_known() const {
        std::vector<std::string> loops;
        std::vector<std::string> reported;
        std::vector<std::string> fifos;
        std::vector<std::string> reported_fifos;
        for (std::size_t const number : loops_of(machine_))
            loops.push_back(machine_.loop_name(number));
        for (ReportLoop const& loop : report_.loops)
            reported.push_back(loop.full_name());
        for (std::size_t const number : fifos_of(machine_))
            fifos.push_back(machine_.fifos[number].name);
        for (ReportFifo const& fifo : report_.fifos)
            reported_fifos.push_back(fifo.name);
        auto const require = [this](char const* section, std::string const& name, std::string const& what,
                                    auto const& known) {
            if (std::find(known.begin(), known.end(), name) == known.end())
                throw InputError(fmt::format("{}: {}: {} is not there, expected a {}{}", names_.file, section, name,
                                             what, did_you_mean(name, known)));
        };
        for (auto const& [ours, theirs] : names_.loops) {
            require("loops", ours, "loop of the design", loops);
            require("loops", theirs, "loop of the report", reported);
            if (std::count(reported.begin(), reported.end(), theirs) > 1)
                throw InputError(
                    fmt::format("{}: loops: {} is several loops of the report, expected one", names_.file, theirs));
        }
        for (auto const& [ours, theirs] : names_.fifos) {
            require("fifos", ours, "FIFO of the design", fifos);
            require("fifos", theirs, "FIFO of the report", reported_fifos);
        }
    }

    /// The process with the longest name that the module's is, or begins with.
    bool is_of(ReportLoop const& loop, std::string const& process) const {
        auto const fits = [&loop](std::string const& name) {
            return loop.module == name || loop.module.rfind(name + "_", 0) == 0;
        };
        return fits(process) &&
               std::none_of(machine_.processes.begin(), machine_.processes.end(), [&](MachineProcess const& other) {
                   return other.name.size() > process.size() && fits(other.name);
               });
    }
    bool is_mapped(ReportLoop const& loop) const {
        return std::any_of(names_.loops.begin(), names_.loops.end(),
                           [&loop](auto const& pair) { return pair.second == loop.full_name(); });
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
            if (!is_of(one, process.name) || one.is_around_others || is_mapped(one))
                continue;
            of_module.push_back(&one);
            if (one.name == loop.name)
                same_name.push_back(&one);
        }
        if (same_name.size() == 1)
            return same_name.front();
        bool const is_only = same_name.empty() && process.loops.size() == 1;
        if (is_only && of_module.size() == 1)
            return of_module.front();
        bool const are_several = same_name.size() > 1 || (is_only && of_module.size() > 1);
        bool const are_alike = same_name.size() > 1 && std::all_of(same_name.begin(), same_name.end(), [&](auto* one) {
                                   return one->full_name() == same_name.front()->full_name();
                               });
        leave(machine_.loop_name(number) + " of the design: " +
              (are_alike     ? "several loops of the report with one name and other figures, expected one"
               : are_several ? "several loops of the report, expected a line in --map"
                             : "no loop of the report, expected a line in --map"));
        return nullptr;
    }

    void leave(std::string line) { result_.without.push_back(std::move(line)); }
    void set(std::string key, std::uint64_t assumed, std::uint64_t scheduled, std::string source) {
        result_.keys.push_back({std::move(key), assumed, scheduled, std::move(source)});
    }
    static void require_in(IntegerRange const& range, std::uint64_t value, std::string const& place,
                           std::string const& what) {
        if (!accepts(range, static_cast<std::int64_t>(value)))
            throw InputError(fmt::format("{}: {} = {}, expected {} to {}", place, what, value, range.min, range.max));
    }

    /// What the report knows of it: of an interval and a depth, one may be missing.
    void add(std::size_t number, ReportLoop const& of_report) {
        MachineLoop const& loop = machine_.loops[number];
        auto const known = [](std::optional<std::uint64_t> const& figure) { return figure.value_or(0) > 0; };
        bool const is_pipelined = of_report.ii || (of_report.depth && !of_report.iteration_latency);
        std::optional<std::uint64_t> const& ii = is_pipelined ? of_report.ii : of_report.iteration_latency;
        std::optional<std::uint64_t> const& length = is_pipelined ? of_report.depth : of_report.iteration_latency;
        if (is_pipelined && !loop.is_pipelined)
            return leave(of_report.full_name() + " of the report: pipelined, which the design's is not");
        if (!known(ii) || !known(length))
            leave(of_report.full_name() + " of the report: no " +
                  (known(ii)       ? "depth"
                   : known(length) ? "interval"
                                   : "interval or depth") +
                  " that it knows");
        if (!known(ii) && !known(length))
            return;
        char const* const ii_source = is_pipelined ? "PipelineII" : "IterationLatency";
        char const* const source = is_pipelined ? "PipelineDepth" : "IterationLatency";
        std::string const remark = loop.is_pipelined && !is_pipelined ? ", not pipelined" : "";
        auto const set_field = [&](char const* field, Cycles assumed, std::optional<std::uint64_t> const& value,
                                   char const* element) {
            if (!known(value))
                return assumed;
            require_in(cycles_range, *value, of_report.place, element + (" of " + of_report.full_name()));
            set(loop_key_name(loop.timed_by, field), assumed, *value, of_report.full_name() + " " + element + remark);
            return static_cast<Cycles>(*value);
        };
        if (loop.is_pipelined) {
            Cycles const now_ii = set_field("ii", loop.interval.target, ii, ii_source);
            scheduled_[number] = {now_ii, set_field("depth", loop.depth, length, source)};
        } else {
            Cycles const states = set_field("states", loop.depth, length, source);
            scheduled_[number] = {states, states};
        }
    }

    /// A write that was in the last stage stays there, a stage beyond it becomes the last.
    void add_stage(std::size_t number, bool writes) {
        MachineFifo const& fifo = machine_.fifos[number];
        std::optional<Cycles> before;
        std::optional<Cycles> after;
        bool is_scheduled = false;
        for (std::size_t const i : loops_of(machine_)) {
            MachineLoop const& loop = machine_.loops[i];
            std::vector<std::size_t> const& fifos = writes ? loop.writes : loop.reads;
            if (std::find(fifos.begin(), fifos.end(), number) == fifos.end())
                continue;
            Lengths const assumed{loop.interval.target, loop.depth};
            auto const found = scheduled_.find(i);
            is_scheduled = is_scheduled || found != scheduled_.end();
            bool const is_early = writes && loop.is_pipelined && !loop.reads.empty() && attempts_to_write(number);
            auto const last = [is_early](Lengths const& of) {
                return (is_early ? std::min(of.ii, of.depth) : of.depth) - 1;
            };
            before = std::min(before.value_or(last(assumed)), last(assumed));
            Lengths const& now = found != scheduled_.end() ? found->second : assumed;
            after = std::min(after.value_or(last(now)), last(now));
        }
        Cycles const stage = writes ? fifo.write_latency : fifo.read_stage;
        if (is_scheduled && ((writes && stage == *before) || stage > *after))
            set(fifo_key_name(fifo.name, writes ? "write_latency" : "read_stage"), stage, *after,
                "assumed: the last stage");
    }
    /// What its loop reads before has to wait for what it finds (docs/hls.md#accesses-that-do-not-wait).
    bool attempts_to_write(std::size_t fifo) const {
        std::vector<MachineEnd> const& ends = machine_.processes[machine_.fifos[fifo].writer].ends;
        return std::any_of(ends.begin(), ends.end(), [fifo](MachineEnd const& end) {
            return end.fifo == fifo && end.writes && end.makes_attempts;
        });
    }

    void add(ReportFifo const& of_report) {
        MachineFifo const* const fifo = counterpart(of_report);
        if (fifo == nullptr)
            return leave(of_report.name + " of the report: no FIFO of the design");
        if (std::count_if(report_.fifos.begin(), report_.fifos.end(),
                          [&](ReportFifo const& other) { return other.name == of_report.name; }) > 1)
            return leave(fmt::format("{} of the report, of depth {}: another FIFO of the report has its name",
                                     of_report.name, of_report.depth));
        if (of_report.depth == 0)
            return leave(of_report.name + " of the report: no depth that it knows");
        require_in(fifo_depth_range, of_report.depth, of_report.place, "DEPTH of " + of_report.name);
        set(fifo_key_name(fifo->name, "depth"), fifo->depth, of_report.depth, of_report.name);
    }
    MachineFifo const* counterpart(ReportFifo const& of_report) const {
        for (std::size_t const number : fifos_of(machine_)) {
            MachineFifo const& fifo = machine_.fifos[number];
            auto const mapped = names_.fifos.find(fifo.name);
            if (of_report.name == (mapped == names_.fifos.end() ? fifo.name : mapped->second))
                return &fifo;
        }
        return nullptr;
    }

    struct Lengths {
        Cycles ii = 1;
        Cycles depth = 1;
    };

    Machine const& machine_;
    SynthesisReport const& report_;
    NameMap const& names_;
    std::set<ReportLoop const*> used_;
    std::map<std::size_t, Lengths> scheduled_;  ///< by loop of the design
    Schedule result_;
};

[[noreturn]] void fail_twice(std::string const& file, YAML::Node const& key, std::string const& name) {
    throw InputError(fmt::format("{}:{}: {}: stands twice, expected once", file, key.Mark().line + 1, name));
}

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
        if (!pairs.emplace(pair.first.Scalar(), pair.second.Scalar()).second)
            fail_twice(file, pair.first, section + "." + pair.first.Scalar());
    }
    return pairs;
}

}  // namespace

NameMap read_name_map(std::string const& file) {
    NameMap names;
    names.file = file;
    YAML::Node const root = load_document(file, "a map of names", {"loops", "fifos"});
    if (root.IsNull())
        return names;
    if (!root.IsMap())
        throw InputError(file + ": no map, expected loops: and fifos:");
    std::set<std::string> seen;
    for (auto const& section : root) {
        std::string const name = section.first.IsScalar() ? section.first.Scalar() : "";
        if (name != "loops" && name != "fifos")
            throw InputError(
                fmt::format("{}:{}: section {}, expected loops or fifos", file, section.first.Mark().line + 1, name));
        if (!seen.insert(name).second)
            fail_twice(file, section.first, name);
        (name == "loops" ? names.loops : names.fifos) = pairs_of(file, section.second, name);
    }
    return names;
}

Schedule schedule_of(Machine const& machine, SynthesisReport const& report, NameMap const& names) {
    return Scheduler(machine, report, names).schedule();
}

}  // namespace dataflow::schedule

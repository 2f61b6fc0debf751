#include "dataflow/run/config/design_check.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/key_ranges.hpp"

namespace dataflow {

namespace {

using Names = std::vector<std::string>;

bool has(Names const& names, std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Names of one kind of part, each of which may be used once. Another kind may have them, too.
class NamedOnce {
  public:
    NamedOnce(std::string where, std::string kind) : where_(std::move(where)), kind_(std::move(kind)) {}
    void add(std::string const& name) {
        if (!is_word(name))
            throw InputError(where_ + " one of the " + kind_ + " has the name \"" + name +
                             "\", expected a word, such as row_buffer, which keys and tables can have");
        if (has(names_, name))
            throw InputError(where_ + " two " + kind_ + " have the name " + name +
                             ", expected another name for one of them");
        names_.push_back(name);
    }

  private:
    std::string where_;
    std::string kind_;
    Names names_;
};

class DesignCheck {
  public:
    explicit DesignCheck(CoreDescription const& core) : core_(core) {
        for (ModuleDescription const& module : core.modules)
            for (MemoryDescription const& memory : module.memories)
                memories_.push_back(memory.name);
    }

    void check() const {
        check_names();
        check_core_ends();
        for (ModuleDescription const& module : core_.modules) {
            for (FifoEnd const& end : module.ends)
                check_end(module, end);
            for (NumberDescription const& number : module.numbers)
                check_range("the number " + number.name + " of module " + module.name, number.value,
                            {static_cast<std::int64_t>(number.least), static_cast<std::int64_t>(number.most)});
            for (LoopDescription const& loop : module.loops)
                check_loop(module, loop);
        }
        for (std::string const& fifo : core_.fifos)
            for (bool const writes : {true, false})
                check_ends(fifo, writes);
        check_pace();
    }

  private:
    void check_names() const {
        NamedOnce modules("in the design", "modules");
        NamedOnce fifos("in the design", "FIFOs");
        NamedOnce memories("in the design", "memories");
        for (std::string const& fifo : core_.fifos)
            fifos.add(fifo);
        for (ModuleDescription const& module : core_.modules) {
            if (!hold(module.conditions))
                continue;
            modules.add(module.name);
            NamedOnce loops("in module " + module.name, "loops");
            for (MemoryDescription const& memory : module.memories)
                if (hold(memory.conditions))
                    memories.add(memory.name);
            for (LoopDescription const& loop : module.loops)
                if (hold(loop.conditions))
                    loops.add(loop.name);
            if (module.setup)
                loops.add("setup");  // has keys like a loop's
        }
    }

    void check_end(ModuleDescription const& module, FifoEnd const& end) const {
        if (!has(core_.fifos, end.fifo))
            throw InputError(
                "module " + module.name + (end.writes ? " writes" : " reads") + " the FIFO " + end.fifo +
                (is_written(end.fifo)
                     ? ", which the core's description does not list, expected it among its fifos"
                     : ", which nobody writes, expected another module's writes_to(\"" + end.fifo + "\")") +
                did_you_mean(end.fifo, core_.fifos));
        if (end.writes)
            check_range("the depth of the FIFO " + end.fifo, end.depth,
                        end.buffer_words > 0 ? buffers_range : fifo_depth_range);
        check_stage_of(module, end);
        if (!end.loop.empty())
            keyed_loop(module, end.loop);
        if (end.makes_attempts)
            check_attempts(module, end);
        if (is_buffer(end.fifo) && (!end.loop.empty() || end.makes_attempts))
            throw InputError("module " + module.name + (end.writes ? " writes" : " reads") + " the ping-pong buffer " +
                             end.fifo + (end.makes_attempts ? " without waiting" : " in a loop") +
                             ", expected that it changes hands as a whole, between calls");
    }

    bool is_written(std::string const& fifo) const {
        return std::any_of(core_.modules.begin(), core_.modules.end(),
                           [&](ModuleDescription const& module) { return accesses(module, fifo, true); });
    }

    static void check_stage_of(ModuleDescription const& module, FifoEnd const& end) {
        if (std::optional<Cycles> const stage = end.writes ? end.write_latency : end.read_stage)
            check_range("the stage in which module " + module.name + (end.writes ? " writes" : " reads") +
                            " the FIFO " + end.fifo,
                        *stage, stages_range);
    }

    bool is_buffer(std::string const& fifo) const {
        for (ModuleDescription const& module : core_.modules)
            for (FifoEnd const& end : module.ends)
                if (end.fifo == fifo && end.buffer_words > 0)
                    return true;
        return false;
    }

    /// Neither is timed in the order of cycles.
    void check_attempts(ModuleDescription const& module, FifoEnd const& end) const {
        std::string const what = "module " + module.name + " accesses the FIFO " + end.fifo + " without waiting, ";
        if (!core_.pace.driver.empty())
            throw InputError(what + "in a design with a pace, expected a CoreDescription without pace");
        for (ModuleDescription const& other : core_.modules)
            for (FifoEnd const& its : other.ends)
                if (its.fifo == end.fifo && its.flushes)
                    throw InputError(what + "behind a pipeline that drains by itself, expected read() and write()");
    }

    void check_core_ends() const {
        for (auto const& [what, name] : {std::pair("begins", core_.begins), {"ends", core_.ends}})
            if (Names const names = module_names(); !has(names, name))
                throw InputError(std::string("the core ") + what + " with a module " + name +
                                 ", which there is not, expected one of the design" + did_you_mean(name, names));
    }
    Names module_names() const {
        Names names;
        names.reserve(core_.modules.size());
        for (ModuleDescription const& module : core_.modules)
            names.push_back(module.name);
        return names;
    }

    /// Defaults are within what their keys may say.
    static void check_range(std::string const& what, std::uint64_t value, IntegerRange const& range) {
        if (value < static_cast<std::uint64_t>(range.min) || value > static_cast<std::uint64_t>(range.max))
            throw InputError(what + " is " + std::to_string(value) + ", expected " + std::to_string(range.min) +
                             " to " + std::to_string(range.max));
    }
    static void check_defaults(std::string const& name, LoopDescription const& loop) {
        check_range("the initiation interval of loop " + name, loop.interval, cycles_range);
        check_range("the recurrence of loop " + name, loop.recurrence, cycles_range);
        check_range(std::string(loop.is_pipelined ? "the pipeline depth" : "the number of states") + " of loop " + name,
                    loop.depth, cycles_range);
        check_range("what other keys add to the depth of loop " + name, loop.extra_depth, stages_range);
        check_range("the states before loop " + name, loop.entry_states, stages_range);
        check_range("the states behind loop " + name, loop.exit_states, stages_range);
        if (loop.is_rewinding && !loop.is_pipelined)
            throw InputError("loop " + name +
                             " rewinds and is not pipelined, expected of_depth() instead of of_states()");
    }

    /// What the other's keys do not say is the same, or nothing of this loop could be changed as they say.
    void check_timed_by(std::string const& name, LoopDescription const& loop) const {
        LoopDescription const* other = nullptr;
        Names names;
        for (ModuleDescription const& module : core_.modules)
            for (LoopDescription const& one : module.loops) {
                names.push_back(module.name + "." + one.name);
                if (names.back() == loop.timed_by && one.timed_by.empty())
                    other = &one;
            }
        if (other == nullptr)
            throw InputError("loop " + name + " has the keys of " + loop.timed_by +
                             ", expected a loop of the design that has keys of its own" +
                             did_you_mean(loop.timed_by, names));
        if (other->depth != loop.depth || other->interval != loop.interval || other->is_pipelined != loop.is_pipelined)
            throw InputError("loop " + name + " has the keys of " + loop.timed_by +
                             " and another depth or initiation interval, expected those of " + loop.timed_by);
    }

    void check_loop(ModuleDescription const& module, LoopDescription const& loop) const {
        std::string const name = module.name + "." + loop.name;
        check_defaults(name, loop);
        if (!loop.timed_by.empty())
            check_timed_by(name, loop);
        for (MemoryAccess const& access : loop.accesses)
            if (!has(memories_, access.memory))
                throw InputError("loop " + module.name + "." + loop.name + " accesses the memory " + access.memory +
                                 ", which no module describes, expected memory(\"" + access.memory + "\")" +
                                 did_you_mean(access.memory, memories_));
        for (bool const writes : {true, false})
            for (std::string const& fifo : writes ? loop.writes : loop.reads)
                if (!accesses(module, fifo, writes))
                    throw InputError("loop " + module.name + "." + loop.name + (writes ? " writes" : " reads") +
                                     " the FIFO " + fifo + ", which its module does not, expected " +
                                     (writes ? "writes_to" : "reads_from") + "(\"" + fifo + "\") in its describe()");
    }

    /// At most one is there.
    void check_ends(std::string const& fifo, bool writes) const {
        Names there;
        for (ModuleDescription const& module : core_.modules)
            for (FifoEnd const& end : module.ends)
                if (end.fifo == fifo && end.writes == writes && hold(module.conditions) && hold(end.conditions))
                    there.push_back(module.name);
        if (there.size() > 1)
            throw InputError("the FIFO " + fifo + (writes ? " is written" : " is read") + " by " + there[0] +
                             " and by " + there[1] + ", expected one " + (writes ? "writer" : "reader") +
                             ", and a FIFO for each other");
    }
    void check_pace() const {
        if (core_.pace.driver.empty())
            return;
        ModuleDescription const& driver = paced(core_.pace.driver);
        Names members{driver.name};
        for (CoreDescription::Pace::Follower const& follower : core_.pace.followers) {
            if (has(members, follower.module))
                throw InputError("the pace names " + follower.module + " twice, expected each module once");
            members.push_back(follower.module);
            if (!joins(follower.anchor, driver, paced(follower.module)))
                throw InputError("module " + follower.module + " follows by the FIFO " + follower.anchor +
                                 " in the pace, expected a FIFO between it and " + driver.name);
        }
    }
    ModuleDescription const& paced(std::string const& name) const {
        for (ModuleDescription const& module : core_.modules)
            if (module.name == name)
                return module;
        throw InputError("the pace names a module " + name + ", which there is not, expected one of the design" +
                         did_you_mean(name, module_names()));
    }
    static bool accesses(ModuleDescription const& module, std::string const& fifo, bool writes) {
        return std::any_of(module.ends.begin(), module.ends.end(),
                           [&](FifoEnd const& end) { return end.fifo == fifo && end.writes == writes; });
    }
    static bool joins(std::string const& fifo, ModuleDescription const& one, ModuleDescription const& other) {
        return (accesses(one, fifo, true) && accesses(other, fifo, false)) ||
               (accesses(one, fifo, false) && accesses(other, fifo, true));
    }

    CoreDescription const& core_;
    Names memories_;
};

}  // namespace

bool hold(Conditions const& conditions) {
    return std::all_of(conditions.begin(), conditions.end(), [](Condition const& one) { return one.holds; });
}

bool is_word(std::string const& name) {
    auto const is_of_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    };
    return !name.empty() && std::all_of(name.begin(), name.end(), is_of_word) && name != "null" && name != "Null" &&
           name != "NULL";
}

void check_design(CoreDescription const& core) { DesignCheck(core).check(); }

}  // namespace dataflow

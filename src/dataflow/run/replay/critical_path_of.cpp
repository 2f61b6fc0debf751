#include "dataflow/run/replay/critical_path_of.hpp"

#include <algorithm>
#include <optional>

#include "dataflow/core/machine/core_ends.hpp"
#include "dataflow/run/replay/path_sweep.hpp"

namespace dataflow::replay {

namespace {

using Part = timing::Region::Part;

/// The sums of one process as rows.
class ProcessRows {
  public:
    ProcessRows(Machine const& machine, timing::CoreTiming const& core, unsigned process, timing::PathSums const& sums,
                std::vector<PathRow>& rows)
        : machine_(machine), core_(core), process_(core.processes()[process]), sums_(sums), rows_(rows) {
        base_.module = process;
    }

    void add() {
        auto const loops = static_cast<unsigned>(process_.loops().size());
        for (unsigned number = 0; number < timing::Region::count(loops); ++number)
            add_region(timing::Region::numbered(number));
    }

  private:
    void add_region(timing::Region region) {
        add_own(region);
        for (unsigned port = 0; port < process_.port_count(); ++port)
            if (!process_.fifo(port).is_stream())
                add_crossings(region, port);
    }

    void add_own(timing::Region region) {
        PathRow row = base_;
        row.loop = loop_at(region);
        row.cause = cause_of(region.part());
        row.cycles = sums_.of(process_.index(), region, timing::PathSums::Share::own);
        put(row);
        row.cause = PathCause::fill_drain;
        row.cycles = sums_.of(process_.index(), region, timing::PathSums::Share::flight);
        put(row);
        row.cause = PathCause::recurrence;
        row.cycles = sums_.of(process_.index(), region, timing::PathSums::Share::recurrence);
        put(row);
        row.cause = PathCause::port_conflict;
        row.cycles = sums_.of(process_.index(), region, timing::PathSums::Share::port_conflict);
        if (row.cycles > 0)
            row.bram = process_.loops()[region.loop()].interval.bram;
        put(row);
    }

    void add_crossings(timing::Region region, unsigned port) {
        timing::FifoShape const& shape = process_.fifo(port).shape();
        PathRow row = base_;
        row.crossings = sums_.turns(process_.index(), region, port);
        row.loop = loop_at(region);
        row.fifo = core_.number_of(process_.fifo(port));
        bool const writes = process_.writes(port);
        row.cause = writes ? PathCause::backpressure : PathCause::read_latency;
        row.cycles = row.crossings * (writes ? shape.room_latency : shape.read_latency);
        put(row);
        if (!writes && shape.issue_latency > 0)
            add_flight(row, shape.issue_latency);
    }

    /// Through the stages of the pipeline in front of a FIFO, which are its writer's.
    void add_flight(PathRow const& crossing, Cycles stages) {
        PathRow row;
        row.module = machine_.fifos[*crossing.fifo].writer;
        row.cause = PathCause::fill_drain;
        row.cycles = crossing.crossings * stages;
        put(row);
    }

    std::optional<std::size_t> loop_at(timing::Region region) const {
        if (!region.is_in_loop())
            return std::nullopt;
        return machine_.loop(base_.module, process_.loops()[region.loop()].name);
    }

    static PathCause cause_of(Part part) {
        bool const flows = part == Part::fill || part == Part::drain;
        return part == Part::setup       ? PathCause::setup
               : part == Part::memory    ? PathCause::memory
               : part == Part::interlock ? PathCause::recurrence
               : flows                   ? PathCause::fill_drain
                                         : PathCause::busy;
    }

    /// Adds to the row of the same thing, if there is one: a loop's filling and draining are one.
    void put(PathRow const& row) {
        if (row.cycles == 0)
            return;
        auto const same = [&row](PathRow const& other) {
            return other.module == row.module && other.loop == row.loop && other.cause == row.cause &&
                   other.fifo == row.fifo;
        };
        auto const found = std::find_if(rows_.begin(), rows_.end(), same);
        if (found == rows_.end()) {
            rows_.push_back(row);
            return;
        }
        found->cycles += row.cycles;
        found->crossings += row.crossings;
    }

    Machine const& machine_;
    timing::CoreTiming const& core_;
    timing::ProcessTiming const& process_;
    timing::PathSums const& sums_;
    std::vector<PathRow>& rows_;
    PathRow base_;
};

}  // namespace

std::vector<PathRow> critical_path_of(timing::CoreTiming const& core, Machine const& machine) {
    std::vector<PathRow> rows;
    std::optional<RunEnd> const end = run_end(machine, core);
    if (!end)
        return rows;
    auto const last = static_cast<unsigned>(end->process);
    // A run that is over with an access ends in the middle of what its process does: the cycle of the access is its
    // own.
    Cycles const of_access = machine.is_over_with_last_sample ? 1 : 0;
    timing::PathSums sums = timing::critical_path(core, last, end->cycle + 1 - of_access);
    sums.of(last, timing::Region(), timing::PathSums::Share::own) += of_access;
    for (unsigned process = 0; process < core.processes().size(); ++process)
        ProcessRows(machine, core, process, sums, rows).add();
    std::stable_sort(rows.begin(), rows.end(), [](PathRow const& a, PathRow const& b) { return a.cycles > b.cycles; });
    return rows;
}

}  // namespace dataflow::replay

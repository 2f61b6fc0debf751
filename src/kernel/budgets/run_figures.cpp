#include "kernel/budgets/run_figures.hpp"

#include <algorithm>

#include "faster/parts.hpp"

namespace faster::budgets {

namespace {

/// Adds figures below a common beginning of their names.
class Section {
  public:
    Section(Figures& figures, std::string prefix) : figures_(figures), prefix_(std::move(prefix)) {}
    void set(std::string const& name, std::uint64_t value) { figures_.set(prefix_ + name, value); }

  private:
    Figures& figures_;
    std::string prefix_;
};

void add_module(Figures& figures, std::string const& core, Parts const& parts, std::size_t i,
                ProcessStatistics const& process) {
    Section section(figures, core + "modules." + module_names[i] + ".");
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        section.set(std::string(cycle_class_names[c]) + "_cycles", process.cycles[c]);
    for (std::size_t const f : fifos_of(parts)) {
        FifoEnds const ends = ends_of(parts, FifoId{f});
        if (index_of(ends.writer) == i || index_of(ends.reader) == i)
            section.set(std::string("stalls.") + fifo_names[f], process.stalls[f]);
    }
    for (std::size_t const b : brams_of(parts))
        section.set(std::string("port_conflicts.") + bram_names[b], process.port_conflicts[b]);
}

void add_fifo(Figures& figures, std::string const& core, std::size_t i, FifoStatistics const& fifo) {
    Section section(figures, core + "fifos." + fifo_names[i] + ".");
    section.set("depth", fifo.depth);
    section.set("capacity", fifo.capacity);
    section.set("write_latency", fifo.write_latency);
    section.set("writes", fifo.writes);
    section.set("reads", fifo.reads);
    section.set("full_stall_cycles", fifo.full_stall_cycles);
    section.set("empty_stall_cycles", fifo.empty_stall_cycles);
    section.set("max_occupancy", fifo.max_occupancy);
}

void add_bram(Figures& figures, std::string const& core, std::size_t i, AcceleratorConfig const& config,
              CoreStatistics const& statistics) {
    Section section(figures, core + "brams." + bram_names[i] + ".");
    section.set("ports", config.brams[i].ports);
    section.set("port_conflict_cycles", port_conflict_cycles(statistics, static_cast<BramId>(i)));
}

void add_loop(Figures& figures, std::string const& core, std::size_t i, LoopStatistics const& loop) {
    Section section(figures, core + "loops." + name_of(loop_names[i].module) + "." + loop_names[i].name + ".");
    section.set("ii_target", loop.ii_target);
    section.set("ii_recurrence", loop.ii_recurrence);
    section.set("ii", loop.ii);
    section.set("depth", loop.depth);
    section.set("entries", loop.entries);
    section.set("iterations", loop.iterations);
    section.set("port_conflict_cycles", loop.port_conflict_cycles);
    section.set("recurrence_cycles", loop.recurrence_cycles);
}

void add_core(Figures& figures, std::string const& prefix, AcceleratorConfig const& config,
              CoreStatistics const& core) {
    Parts const parts(config);
    for (std::size_t const i : modules_of(parts))
        add_module(figures, prefix, parts, i, core.processes[i]);
    for (std::size_t const i : fifos_of(parts))
        add_fifo(figures, prefix, i, core.fifos[i]);
    for (std::size_t const i : brams_of(parts))
        add_bram(figures, prefix, i, config, core);
    for (std::size_t const i : loops_of(parts))
        add_loop(figures, prefix, i, core.loops[i]);
}

void add_to_all_cores(Figures& all, Figures const& core) {
    for (Figure const& figure : core.all()) {
        std::uint64_t const before = all.find(figure.name).value_or(0);
        all.set(figure.name,
                is_largest_over_cores(figure.name) ? std::max(before, figure.value) : before + figure.value);
    }
}

void add_sample(Figures& figures, SampleStatistics const& sample) {
    Section section(figures, "samples." + std::to_string(sample.sample) + ".");
    section.set("core", sample.core);
    section.set("start_cycle", sample.start_cycle);
    section.set("end_cycle", sample.end_cycle);
    section.set("latency_cycles", sample.latency_cycles());
    section.set("valid_raster", sample.counters.valid_raster);
    section.set("valid_depth", sample.counters.valid_depth);
    section.set("inlier", sample.counters.inlier);
    section.set("valid_edge", sample.counters.valid_edge);
    section.set("edge_inlier", sample.counters.edge_inlier);
}

}  // namespace

Figures run_figures(RunStatistics const& run, AcceleratorConfig const& config) {
    Figures figures;
    figures.set("total_cycles", run.total_cycles);
    figures.set("samples", run.samples.size());
    figures.set("raster_cores", run.cores.size());
    for (CoreStatistics const& core : run.cores) {
        Figures of_core;
        add_core(of_core, "", config, core);
        add_to_all_cores(figures, of_core);
    }
    for (SampleStatistics const& sample : run.samples)
        add_sample(figures, sample);
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        add_core(figures, "cores." + std::to_string(core) + ".", config, run.cores[core]);
    return figures;
}

}  // namespace faster::budgets

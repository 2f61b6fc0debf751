#include "dataflow/tools/resources/power.hpp"

#include "dataflow/tools/resources/machine_resources.hpp"

namespace dataflow {

namespace {

class PowerCount {
  public:
    PowerCount(RunStatistics const& run, PowerCoefficients const& coefficients)
        : run_(run), each_(coefficients), resources_(resources_of(run.machine)) {}

    RunPower power() const {
        RunPower power;
        for (MachineResources::Module const& module : resources_.modules) {
            std::size_t const number = run_.machine.process(module.sum.name);
            double const busy = static_cast<double>(process_sum(run_, number)[CycleClass::busy]);
            power.modules.push_back({module.sum.name, milliwatts(logic_pj(module.sum.amount, busy, lane_cycles()))});
        }
        power.fifos = {"fifos", milliwatts(fifos_pj())};
        power.memories = {"memories", milliwatts(accesses() * each_.bram_access_pj)};
        auto const total = static_cast<double>(run_.total_cycles);
        power.beside = {"beside", milliwatts(logic_pj(resources_.beside, busy_share() * total, total))};
        power.dynamic_w = 1e-3 * (sum_of(power.modules) + power.fifos.milliwatts + power.memories.milliwatts +
                                  power.beside.milliwatts);
        power.static_w = each_.static_w;
        power.ps_w = each_.ps_w;
        power.total_w = power.dynamic_w + power.static_w + power.ps_w;
        power.energy_mj = run_.machine.milliseconds(run_.total_cycles) * power.total_w;
        return power;
    }

  private:
    double lane_cycles() const {
        return static_cast<double>(run_.total_cycles) * static_cast<double>(run_.cores.size());
    }

    /// Average over the run.
    Estimate milliwatts(Estimate const& picojoules) const {
        return run_.machine.clock_mhz * 1e-3 / static_cast<double>(run_.total_cycles) * picojoules;
    }

    /// Of one core's amount, whose cores were busy and clocked for so many cycles together.
    Estimate logic_pj(Resources const& amount, double busy, double clocked) const {
        return (busy * amount.lut) * each_.lut_pj + (busy * amount.dsp) * each_.dsp_pj +
               (clocked * amount.ff) * each_.ff_pj;
    }

    Estimate fifos_pj() const {
        double bits = 0;
        double flip_flops = 0;
        for (std::size_t const i : fifos_of(run_.machine))
            for (CoreStatistics const& core : run_.cores)
                bits += static_cast<double>(core.fifos[i].writes) * run_.machine.fifos[i].bits;
        for (ResourcePart const& fifo : resources_.fifos)
            flip_flops += fifo.amount.ff;
        return bits * each_.fifo_bit_pj + (lane_cycles() * flip_flops) * each_.ff_pj;
    }

    /// Of the memory that each loop accesses most.
    double accesses() const {
        double sum = 0;
        for (CoreStatistics const& core : run_.cores)
            for (LoopStatistics const& loop : core.loops)
                sum += static_cast<double>(loop.iterations * loop.bram_accesses);
        return sum;
    }

    double busy_share() const {
        double busy = 0;
        for (std::size_t const i : modules_of(run_.machine))
            busy += static_cast<double>(process_sum(run_, i)[CycleClass::busy]);
        return busy / lane_cycles() / static_cast<double>(modules_of(run_.machine).size());
    }

    static Estimate sum_of(std::vector<PowerRow> const& rows) {
        Estimate sum;
        for (PowerRow const& row : rows)
            sum = sum + row.milliwatts;
        return sum;
    }

    RunStatistics const& run_;
    PowerCoefficients const& each_;
    MachineResources const resources_;
};

}  // namespace

RunPower power_of(RunStatistics const& run, PowerCoefficients const& coefficients) {
    return PowerCount(run, coefficients).power();
}

}  // namespace dataflow

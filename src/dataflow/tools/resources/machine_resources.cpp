#include "dataflow/tools/resources/machine_resources.hpp"

#include <algorithm>

#include "dataflow/base/integer_bits.hpp"
#include "dataflow/tools/resources/fifo_cost.hpp"

namespace dataflow {

namespace {

std::optional<UnitPath> slowest_of(std::vector<UnitPath> const& paths) {
    auto const slowest = std::max_element(paths.begin(), paths.end(), [](UnitPath const& a, UnitPath const& b) {
        return a.of_stage().typical < b.of_stage().typical;
    });
    return slowest == paths.end() ? std::nullopt : std::optional(*slowest);
}

std::vector<MachineResources::Module> modules_of(Machine const& machine, ToldResources const& told) {
    std::vector<MachineResources::Module> modules;
    if (!told.modules.empty())
        for (std::size_t const i : dataflow::modules_of(machine))
            modules.push_back({sum_of(machine.processes[i].name, told.modules[i]), told.modules[i],
                               told.paths.empty() ? std::nullopt : slowest_of(told.paths[i])});
    return modules;
}

std::vector<ResourcePart> fifos_of(Machine const& machine, ToldResources const& told) {
    std::vector<ResourcePart> fifos;
    for (std::size_t const i : dataflow::fifos_of(machine)) {
        ResourcePart part{"", counted_fifo(machine.fifos[i]), ResourceBasis::counted};
        if (!told.fifos.empty())
            part = told.fifos[i];
        part.name = machine.fifos[i].name;
        fifos.push_back(std::move(part));
    }
    return fifos;
}

std::vector<ResourcePart> memories_of(Machine const& machine) {
    std::vector<ResourcePart> memories;
    for (std::size_t const i : brams_of(machine))
        memories.push_back({machine.memories[i].name, {0, 0, 0, ramb36_count(machine.memories[i].shape)}});
    for (LineBuffer const& buffer : machine.line_buffers)
        memories.push_back({buffer.name, {0, 0, 0, ramb36_count({buffer.words, buffer.bits})}});
    return memories;
}

}  // namespace

Resources counted_fifo(MachineFifo const& fifo) {
    Primitives const tokens = primitives_of(fifo.kind, fifo.tokens(), fifo.bits, {});
    double const count = bits_for(fifo.capacity());
    Resources fifo_takes{static_cast<double>(tokens.luts) + 2 * count, count, 0,
                         static_cast<double>(tokens.ramb18) / 2};
    if (fifo.kind == FifoKind::memory)  // two addresses, the output register and its valid bit
        fifo_takes += {2 * count, 2 * count + fifo.bits + 1, 0, 0};
    return fifo_takes;
}

MachineResources resources_of(Machine const& machine) {
    ToldResources const told = machine.resources == nullptr ? ToldResources{} : (*machine.resources)(machine);
    MachineResources all;
    all.modules = modules_of(machine, told);
    all.fifos = fifos_of(machine, told);
    all.memories = memories_of(machine);
    std::vector<ResourcePart> parts = all.fifos;
    parts.insert(parts.end(), all.memories.begin(), all.memories.end());
    for (MachineResources::Module const& module : all.modules)
        parts.push_back(module.sum);
    all.core = sum_of("core", parts);
    auto const cores = static_cast<double>(machine.cores);
    all.cores = {"cores", cores * all.core.amount, all.core.basis};
    all.beside = cores * told.beside;
    all.beside_is = told.beside_is;
    all.chip = all.cores.amount + all.beside;
    return all;
}

bool MachineResources::fits(Device const& device) const {
    return chip.lut <= device.has.lut && chip.ff <= device.has.ff && chip.dsp <= device.has.dsp &&
           chip.ramb36 <= device.has.ramb36;
}

}  // namespace dataflow

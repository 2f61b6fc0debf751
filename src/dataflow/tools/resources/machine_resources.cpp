#include "dataflow/tools/resources/machine_resources.hpp"

#include <algorithm>

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
        MachineFifo const& fifo = machine.fifos[i];
        ResourcePart part{"", counted_fifo(fifo.kind, fifo.tokens(), fifo.capacity(), fifo.bits),
                          ResourceBasis::counted};
        if (!told.fifos.empty())
            part = told.fifos[i];
        part.name = fifo.name;
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

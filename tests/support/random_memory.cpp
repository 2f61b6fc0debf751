#include "support/random_memory.hpp"

#include <initializer_list>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"

namespace faster::testing {
namespace {

class MemoryDice {
  public:
    explicit MemoryDice(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t between(std::uint64_t low, std::uint64_t high) { return low + engine_() % (high - low + 1); }
    bool one_in(std::uint64_t n) { return engine_() % n == 0; }
    template <class Value> Value one_of(std::initializer_list<Value> values) {
        return values.begin()[engine_() % values.size()];
    }

  private:
    std::mt19937_64 engine_;
};

void draw_bursts(MemoryDice& dice, ExternalMemorySettings& memory) {
    auto const beat = dice.one_of<std::uint64_t>({2, 2, 3, 4, 4, 5, 6, 7, 12});  // powers of two
    memory.port_bytes = std::uint64_t{1} << beat;
    memory.burst_bytes = std::uint64_t{1} << (dice.one_in(4) ? beat : dice.between(beat, 12));
    memory.outstanding = dice.one_of<std::uint64_t>({1, 1, 2, 3, 4, 16, 1000});
    memory.prefetch = dice.one_in(2);
    memory.ports = dice.between(1, 5);
}

void draw_controller(MemoryDice& dice, ExternalMemorySettings& memory) {
    memory.request_cycles = dice.one_of<Cycles>({0, 1, 24, dice.between(0, 100)});
    memory.read_latency_ns = dice.one_of<double>({0, 120, static_cast<double>(dice.between(0, 400000)) / 1000});
    memory.dram_gb_per_s = dice.one_of<double>({1e6, 19.2, 1.5, static_cast<double>(dice.between(1, 100)) / 16});
    memory.dram_efficiency = dice.one_of<double>({1, 0.75, 0.3});
}

std::uint64_t draw_address(MemoryDice& dice, std::uint64_t usual) {
    return dice.one_in(2) ? usual : usual + dice.between(0, 5000);
}

void draw_placement(MemoryDice& dice, AcceleratorConfig& config) {
    MemoryPlacement& placement = config.memory_placement;
    placement.mesh = dice.one_in(4) ? Placement::on_chip : Placement::external;
    placement.observation = dice.one_in(4) ? Placement::on_chip : Placement::external;
    placement.observation_copies = dice.between(1, config.cores);
    placement.mesh_address = draw_address(dice, placement.mesh_address);
    placement.image_address = draw_address(dice, placement.image_address);
    placement.table_address = draw_address(dice, placement.table_address);
    placement.header_address = draw_address(dice, placement.header_address);
    placement.result_address = draw_address(dice, placement.result_address);
    if (placement.observation == Placement::on_chip) {
        auto& observation = config.memory(BramId::observation);
        observation.ports = dice.between(1, 3);
        observation.partition = {dice.one_of({PartitionType::none, PartitionType::cyclic}), dice.between(1, 4),
                                 dice.between(0, 2)};
    }
}

}  // namespace

void draw_memory_timing(std::uint64_t seed, AcceleratorConfig& config) {
    MemoryDice dice(seed);
    draw_bursts(dice, config.external_memory);
    draw_controller(dice, config.external_memory);
    config.clock_mhz = dice.one_of<double>({200, 333, static_cast<double>(dice.between(50, 800))});
}

void draw_memory(std::uint64_t seed, AcceleratorConfig& config) {
    MemoryDice dice(seed);
    config.external_memory.model = MemoryModel::axi;
    draw_bursts(dice, config.external_memory);
    draw_controller(dice, config.external_memory);
    draw_placement(dice, config);
    config.clock_mhz = dice.one_of<double>({200, 200, 300, 187.5, static_cast<double>(dice.between(50, 800))});
}

}  // namespace faster::testing

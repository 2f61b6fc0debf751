#include "support/twin_programs.hpp"

#include <algorithm>
#include <utility>

#include "faster/dataflow_names.hpp"
#include "support/ceil_div.hpp"
#include "support/plain_config.hpp"
#include "support/twin_function.hpp"

namespace faster::testing {
namespace {

TwinAccess read_of(FifoId fifo) { return TwinAccess{AccessKind::Read, fifo}; }
TwinAccess write_of(FifoId fifo) { return TwinAccess{AccessKind::Write, fifo}; }

void step(TwinProgram& program, std::vector<TwinAccess> accesses, Cycles advance = 1) {
    TwinState state;
    state.accesses = std::move(accesses);
    state.advance = advance;
    program.push_back(std::move(state));
}

void pass(TwinProgram& program, Cycles cycles) { step(program, {}, cycles); }

void loop(TwinProgram& program, LoopId id, std::vector<TwinAccess> accesses, std::vector<std::uint8_t> iterations) {
    TwinState state;
    state.accesses = std::move(accesses);
    state.loop = id;
    state.iterations = std::move(iterations);
    program.push_back(std::move(state));
}

/// A loop whose iterations all make all accesses.
void uniform_loop(TwinProgram& program, LoopId id, std::vector<TwinAccess> accesses, std::size_t iterations) {
    unsigned const all = (1U << accesses.size()) - 1U;
    loop(program, id, std::move(accesses), std::vector<std::uint8_t>(iterations, static_cast<std::uint8_t>(all)));
}

/// A loop that may have no iteration: then a cycle passes.
void loop_or_pass(TwinProgram& program, LoopId id, std::vector<TwinAccess> accesses,
                  std::vector<std::uint8_t> iterations) {
    if (iterations.empty()) {
        pass(program, 1);
    } else {
        loop(program, id, std::move(accesses), std::move(iterations));
    }
}

bool touches(AcceleratorConfig const& config) { return config.inlier_unit.sweep_region == SweepRegion::touched; }

/// Learns which pixels it is about by a FIFO, if not all are.
void corners(TwinProgram& program, AcceleratorConfig const& config, FifoId fifo) {
    for (int corner = 0; touches(config) && corner < 2; ++corner) {
        step(program, {read_of(fifo)});
    }
}

/// From drawing to reading out in one process.
void turn(TwinProgram& program, AcceleratorConfig const& config, FifoId fifo) {
    corners(program, config, fifo);
    if (!touches(config)) {
        pass(program, 1);
    }
}

/// To another process, which learns by `full` what is to be read out: a token, whatever it says.
void hand_over(TwinProgram& program, AcceleratorConfig const& config, FifoId fifo, FifoId full, FifoId free) {
    corners(program, config, fifo);
    step(program, {write_of(full)});
    step(program, {read_of(free)});
}

TwinProgram sample_dispatcher() {
    TwinProgram program;
    step(program,
         {write_of(FifoId::sample_vertex), write_of(FifoId::sample_raster), write_of(FifoId::sample_observation)});
    return program;
}

TwinProgram vertex_transform(TwinSampleFunction const& sample) {
    TwinProgram program;
    step(program, {read_of(FifoId::sample_vertex)});
    if (sample.triangles.empty()) {
        pass(program, 1);
    } else {
        uniform_loop(program, LoopId::vertex, {write_of(FifoId::vertex)}, 3 * sample.triangles.size());
    }
    return program;
}

constexpr std::uint8_t fragment_accesses = 0b0111;
constexpr std::uint8_t edge_token_access = 0b1000;

std::vector<std::uint8_t> scan_iterations(TwinTriangle const& triangle) {
    std::vector<std::uint8_t> iterations;
    for (TwinScanIteration const& iteration : triangle.scan) {
        unsigned const fragment = iteration.sends_fragment ? fragment_accesses : 0U;
        unsigned const edge_token = iteration.sends_edge_token ? edge_token_access : 0U;
        iterations.push_back(static_cast<std::uint8_t>(fragment | edge_token));
    }
    return iterations;
}

std::vector<TwinAccess> scan_accesses() {
    return {write_of(FifoId::command), write_of(FifoId::fragment_depth), write_of(FifoId::fragment_index),
            write_of(FifoId::edge_token)};
}

void draw_one_by_one(TwinProgram& program, TwinSampleFunction const& sample, Cycles setup_depth) {
    for (TwinTriangle const& triangle : sample.triangles) {
        for (int vertex = 0; vertex < 3; ++vertex) {
            step(program, {read_of(FifoId::vertex)});
        }
        pass(program, setup_depth);
        if (!triangle.is_drawn) {
            step(program, {write_of(FifoId::area)});
            continue;
        }
        step(program, {write_of(FifoId::area), write_of(FifoId::command)});
        loop(program, LoopId::scan, scan_accesses(), scan_iterations(triangle));
    }
}

/// All triangles in one loop, whose iterations also read vertices and announce triangles, `ahead` triangles before.
void draw_overlapped(TwinProgram& program, TwinSampleFunction const& sample, std::size_t ahead, Cycles setup_cycles) {
    constexpr std::uint8_t vertex_access = 0b000001;
    constexpr std::uint8_t area_access = 0b000010;
    constexpr std::uint8_t command_access = 0b000100;
    std::size_t const count = sample.triangles.size();
    if (count == 0)
        return;
    TwinState state;
    state.loop = LoopId::scan;
    state.accesses = scan_accesses();
    state.accesses.insert(state.accesses.begin(), {read_of(FifoId::vertex), write_of(FifoId::area)});
    state.setup_cycles = setup_cycles;
    std::vector<std::size_t> last_vertex;
    for (; last_vertex.size() < std::min(ahead, count); last_vertex.push_back(state.iterations.size() - 1)) {
        state.iterations.insert(state.iterations.end(), 3, vertex_access);
    }
    for (std::size_t t = 0; t < count; ++t) {
        TwinTriangle const& triangle = sample.triangles[t];
        std::size_t const begin = state.iterations.size();
        state.setups.push_back({last_vertex[t], begin});
        state.iterations.push_back(triangle.is_drawn ? area_access | command_access : area_access);
        for (std::uint8_t const accesses : scan_iterations(triangle)) {
            state.iterations.push_back(static_cast<std::uint8_t>(accesses << 2));
        }
        state.iterations.resize(std::max(state.iterations.size(), begin + 3), 0);
        if (t + ahead < count) {
            for (std::size_t i = begin; i < begin + 3; ++i) {
                state.iterations[i] = static_cast<std::uint8_t>(state.iterations[i] | vertex_access);
            }
            last_vertex.push_back(begin + 2);
        }
    }
    program.push_back(std::move(state));
}

TwinProgram rasterizer(TwinSampleFunction const& sample, AcceleratorConfig const& config) {
    // 18 more for the divisions that spans need
    Cycles const setup = setup_depth_of(config) + (config.rasterizer.scan == ScanPolicy::spans ? 18 : 0);
    TwinProgram program;
    step(program, {read_of(FifoId::sample_raster)});
    if (config.rasterizer.setup_overlap == 0) {
        draw_one_by_one(program, sample, setup);
    } else {
        draw_overlapped(program, sample, config.rasterizer.setup_overlap, setup);
    }
    pass(program, 1);
    std::vector<TwinAccess> last{write_of(FifoId::command)};
    if (config.flow == Flow::faster) {
        last.push_back(write_of(FifoId::edge_token));
    }
    step(program, std::move(last));
    for (int corner = 0; touches(config) && corner < 2; ++corner) {
        std::vector<TwinAccess> to_all{write_of(FifoId::fragment_index), write_of(FifoId::region)};
        if (config.flow == Flow::faster) {
            to_all.insert(to_all.begin() + 1, write_of(FifoId::edge_token));
        }
        step(program, std::move(to_all));
    }
    return program;
}

/// The write is a step of its own that may fall in the cycle of the read; that it enters a pipeline of Lw stages is a
/// property of the FIFO model.
TwinProgram area_reciprocal(AcceleratorConfig const& config, TwinSampleFunction const& sample) {
    TwinProgram program;
    for (TwinTriangle const& triangle : sample.triangles) {
        if (triangle.area_code > 0) {
            step(program, {read_of(FifoId::area)}, 0);
            step(program, {write_of(FifoId::area_reciprocal)}, reciprocal_interval(config));
        } else {
            step(program, {read_of(FifoId::area)});
        }
    }
    return program;
}

/// Tokens that have a pixel of a row of the region.
std::size_t row_tokens(AcceleratorConfig const& config, TwinRegion const& region) {
    auto const lanes = static_cast<std::size_t>(config.inlier_unit.sweep_lanes);
    return ceil_div(region.end_col, lanes) - region.first_col / lanes;
}

std::size_t rows_of(TwinRegion const& region) { return region.end_row - region.first_row; }

/// Words of the largest bank.
std::size_t words_of_bank(BramConfig const& bram, std::size_t side) {
    PartitionConfig const& partition = bram.partition;
    if (partition.type == PartitionType::none) {
        return side * side;
    }
    std::size_t const share = ceil_div(side, partition.factor);
    return partition.dimension == 0 ? share * share : share * side;
}

/// A loop of as many iterations as the clearing of these memories takes, if it is a loop.
void clearing_loop(TwinProgram& program, LoopId id, MapClearing clearing, std::vector<BramConfig> const& brams,
                   std::size_t side) {
    std::size_t words = clearing == MapClearing::loop ? side * side : 0;
    for (BramConfig const& bram : brams) {
        words = clearing == MapClearing::wide ? std::max(words, words_of_bank(bram, side)) : words;
    }
    if (clearing != MapClearing::on_read_out) {
        uniform_loop(program, id, {}, words);
    }
}

std::vector<BramConfig> maps_of(AcceleratorConfig const& config) {
    switch (config.edge_map.algorithm) {
        case EdgeMapAlgorithm::threshold:
        case EdgeMapAlgorithm::transition:
        case EdgeMapAlgorithm::bounded:
            return {bram_of(config, BramId::edge_map)};
        case EdgeMapAlgorithm::inner_border:
            return {bram_of(config, BramId::object_map)};
        case EdgeMapAlgorithm::dual_map:
        case EdgeMapAlgorithm::dual_map_4_1_2:
            break;
    }
    return {bram_of(config, BramId::edge_map), bram_of(config, BramId::object_map)};
}

void output(TwinProgram& program, LoopId id, TwinSampleFunction const& sample, AcceleratorConfig const& config) {
    std::size_t const row = row_tokens(config, sample.region);
    std::vector<std::uint8_t> iterations(sample.output_reads_ahead ? row : 0, 0);
    iterations.insert(iterations.end(), rows_of(sample.region) * row, 1);
    loop_or_pass(program, id, {write_of(FifoId::edge_map)}, std::move(iterations));
}

TwinProgram edge_map_builder(TwinSampleFunction const& sample, AcceleratorConfig const& config, std::size_t side) {
    TwinProgram program;
    pass(program, 1);
    clearing_loop(program, LoopId::edge_clear, config.edge_map.clearing, maps_of(config), side);
    step(program, {read_of(FifoId::edge_token)});
    if (sample.token_iteration_reads.empty()) {
        pass(program, 1);
    } else {
        std::vector<std::uint8_t> iterations;
        for (bool const reads : sample.token_iteration_reads) {
            iterations.push_back(reads ? 1 : 0);
        }
        loop(program, LoopId::token, {read_of(FifoId::edge_token)}, std::move(iterations));
        program.back().touches = sample.token_touches;
    }
    if (config.edge_map.buffers == 2) {
        hand_over(program, config, FifoId::edge_token, FifoId::map_full, FifoId::map_free);
    } else {
        turn(program, config, FifoId::edge_token);
        output(program, LoopId::output, sample, config);
    }
    return program;
}

/// With two buffers of the maps: takes one, which frees the other.
TwinProgram edge_map_output(TwinSampleFunction const& sample, AcceleratorConfig const& config) {
    TwinProgram program;
    step(program, {read_of(FifoId::map_full), write_of(FifoId::map_free)});
    output(program, LoopId::buffered_output, sample, config);
    return program;
}

TwinProgram observation_reader(TwinSampleFunction const& sample, AcceleratorConfig const& config) {
    TwinProgram program;
    step(program, {read_of(FifoId::sample_observation)});
    if (touches(config)) {
        uniform_loop(program, LoopId::read, {}, 4);
        step(program, {write_of(FifoId::valid_depth)});
        step(program, {read_of(FifoId::region)});
        step(program, {read_of(FifoId::region)});
    }
    std::size_t const tokens = rows_of(sample.region) * row_tokens(config, sample.region);
    loop_or_pass(program, LoopId::read, {write_of(FifoId::observed_depth), write_of(FifoId::observed_edge)},
                 std::vector<std::uint8_t>(tokens, 0b11));
    return program;
}

/// A row and a token more: before the first pixel while line buffers fill, or after the last to clear what is left.
std::vector<std::uint8_t> sweep_iterations(AcceleratorConfig const& config, TwinRegion const& region) {
    bool const clears = config.inlier_unit.clearing == MapClearing::on_read_out;
    bool const has_neighbours =
        config.flow == Flow::faster && config.edge_map.algorithm != EdgeMapAlgorithm::inner_border;
    bool const is_window = config.inlier_unit.neighbour_access == NeighbourAccess::window;
    std::size_t const row = row_tokens(config, region);
    std::vector<std::uint8_t> iterations(rows_of(region) * row, config.flow == Flow::faster ? 0b111 : 0b011);
    if (iterations.empty()) {
        return iterations;
    }
    if (has_neighbours && is_window) {
        iterations.insert(iterations.begin(), row + 1, 0);
    } else if (has_neighbours && clears) {
        iterations.insert(iterations.end(), row + 1, 0);
    }
    return iterations;
}

/// Flow fpga_grip: an iteration per pixel; line buffers have to fill up to the pixel half a neighbourhood behind.
void extract(TwinProgram& program, LoopId id, EdgeExtractionConfig const& config, TwinRegion const& region) {
    auto const reach = static_cast<std::size_t>(config.neighbourhood / 2);
    bool const fills = config.neighbour_access == NeighbourAccess::window;
    std::size_t const cols = region.end_col - region.first_col;
    std::size_t const pixels = rows_of(region) * cols;
    loop_or_pass(program, id, {},
                 std::vector<std::uint8_t>(pixels + (fills && pixels > 0 ? reach * cols + reach : 0), 0));
    pass(program, 1);
}

void take_one_by_one(TwinProgram& program, TwinSampleFunction const& sample) {
    auto touches = sample.fragment_touches.begin();
    for (TwinTriangle const& triangle : sample.triangles) {
        if (!triangle.is_drawn) {
            continue;  // sends no command and no reciprocal
        }
        step(program, {read_of(FifoId::area_reciprocal), read_of(FifoId::command)});
        if (triangle.fragments == 0) {
            pass(program, 1);
        } else {
            uniform_loop(program, LoopId::fragment,
                         {read_of(FifoId::fragment_depth), read_of(FifoId::fragment_index), read_of(FifoId::command)},
                         triangle.fragments);
            auto const end = touches + static_cast<std::ptrdiff_t>(triangle.fragments);
            program.back().touches.assign(std::exchange(touches, end), end);
        }
    }
}

/// An iteration for each command but the last: what it reads beside the next command.
void take_in_one_loop(TwinProgram& program, TwinSampleFunction const& sample) {
    constexpr std::uint8_t of_triangle = 0b1001;
    constexpr std::uint8_t of_fragment = 0b1110;
    std::vector<std::uint8_t> iterations;
    TwinTouches touches;
    auto fragment = sample.fragment_touches.begin();
    for (TwinTriangle const& triangle : sample.triangles) {
        iterations.insert(iterations.end(), triangle.is_drawn ? 1 : 0, of_triangle);
        iterations.insert(iterations.end(), triangle.fragments, of_fragment);
        touches.resize(touches.size() + (triangle.is_drawn ? 1 : 0));
        auto const end = fragment + static_cast<std::ptrdiff_t>(triangle.fragments);
        touches.insert(touches.end(), std::exchange(fragment, end), end);
    }
    if (!iterations.empty()) {
        loop(program, LoopId::fragment,
             {read_of(FifoId::area_reciprocal), read_of(FifoId::fragment_depth), read_of(FifoId::fragment_index),
              read_of(FifoId::command)},
             std::move(iterations));
        program.back().touches = std::move(touches);
    }
}

struct ScoringLoops {
    LoopId extract;
    LoopId sweep;
};

void score(TwinProgram& program, ScoringLoops const& loops, TwinSampleFunction const& sample,
           AcceleratorConfig const& config) {
    std::vector<TwinAccess> of_pixel{read_of(FifoId::observed_depth), read_of(FifoId::observed_edge)};
    if (config.flow == Flow::fpga_grip) {
        extract(program, loops.extract, config.edge_extraction, sample.region);
    } else {
        of_pixel.insert(of_pixel.begin(), read_of(FifoId::edge_map));
    }
    loop_or_pass(program, loops.sweep, std::move(of_pixel), sweep_iterations(config, sample.region));
    step(program, {write_of(FifoId::result)});
}

TwinProgram inlier_unit(TwinSampleFunction const& sample, AcceleratorConfig const& config, std::size_t side) {
    TwinProgram program;
    pass(program, 1);
    clearing_loop(program, LoopId::depth_clear, config.inlier_unit.clearing, {bram_of(config, BramId::depth_buffer)},
                  side);
    step(program, {read_of(FifoId::command)});
    if (config.inlier_unit.fragment_loop == FragmentLoop::flattened) {
        take_in_one_loop(program, sample);
    } else {
        take_one_by_one(program, sample);
    }
    if (config.inlier_unit.buffers == 2) {
        hand_over(program, config, FifoId::fragment_index, FifoId::depth_full, FifoId::depth_free);
    } else {
        turn(program, config, FifoId::fragment_index);
        score(program, {LoopId::extract, LoopId::sweep}, sample, config);
    }
    return program;
}

/// With two depth buffers: takes one, which frees the other.
TwinProgram inlier_sweep(TwinSampleFunction const& sample, AcceleratorConfig const& config) {
    TwinProgram program;
    step(program, {read_of(FifoId::depth_full), write_of(FifoId::depth_free)});
    score(program, {LoopId::buffered_extract, LoopId::buffered_sweep}, sample, config);
    return program;
}

TwinProgram result_collector(AcceleratorConfig const& config) {
    TwinProgram program;
    std::vector<TwinAccess> accesses{read_of(FifoId::result)};
    if (touches(config)) {
        accesses.push_back(read_of(FifoId::valid_depth));
    }
    step(program, std::move(accesses));
    return program;
}

void bring(TwinState& state, TwinMaster master, TwinRanges ranges) {
    state.master = master;
    state.ranges = std::move(ranges);
}

/// The reader's states that go over the table, if there is one, and over pixels.
void bring_observation(TwinProgram& reader, AcceleratorConfig const& config, Stimulus const& stimulus,
                       std::size_t sample, TwinRegion const& region, TwinMemory const& memory) {
    auto const lanes = static_cast<std::size_t>(config.inlier_unit.sweep_lanes);
    bool is_table = touches(config);
    for (TwinState& state : reader) {
        if (!state.loop)
            continue;
        if (is_table)
            bring(state, TwinMaster::observation, table_ranges(memory, stimulus, sample));
        else if (!memory.observation_on_chip)
            bring(state, TwinMaster::observation, row_ranges(memory, stimulus, sample, region, lanes));
        is_table = false;
    }
}

/// Which steps and loops have data outside the chip.
void bring_all(TwinSamplePrograms& all, AcceleratorConfig const& config, Stimulus const& stimulus, std::size_t sample,
               TwinSampleFunction const& function, TwinMemory const& memory) {
    auto const program = [&all](ModuleId id) -> TwinProgram& { return all.programs[index_of(id)]; };
    bring(program(ModuleId::sample_dispatcher).front(), TwinMaster::header, header_ranges(memory, sample));
    if (!memory.mesh_on_chip && !function.triangles.empty())
        bring(program(ModuleId::vertex_transform).back(), TwinMaster::vertex,
              mesh_ranges(memory, function.triangles.size()));
    bring_observation(program(ModuleId::observation_reader), config, stimulus, sample, function.region, memory);
    bring(program(ModuleId::result_collector).front(), TwinMaster::result, result_ranges(memory, sample));
}

}  // namespace

TwinSamplePrograms programs_of_sample(AcceleratorConfig const& config, Stimulus const& stimulus, std::size_t sample,
                                      TwinMemory const& memory) {
    TwinSampleFunction const function = evaluate_sample(stimulus, sample, config);
    std::size_t const side = static_cast<std::size_t>(stimulus.window);

    TwinSamplePrograms result;
    result.counters = function.counters;
    auto const set = [&result](ModuleId id, TwinProgram program) {
        result.programs[index_of(id)] = std::move(program);
    };
    set(ModuleId::sample_dispatcher, sample_dispatcher());
    set(ModuleId::vertex_transform, vertex_transform(function));
    set(ModuleId::rasterizer, rasterizer(function, config));
    set(ModuleId::area_reciprocal, area_reciprocal(config, function));
    if (config.flow == Flow::faster)
        set(ModuleId::edge_map_builder, edge_map_builder(function, config, side));
    if (config.flow == Flow::faster && config.edge_map.buffers == 2)
        set(ModuleId::edge_map_output, edge_map_output(function, config));
    set(ModuleId::observation_reader, observation_reader(function, config));
    set(ModuleId::inlier_unit, inlier_unit(function, config, side));
    if (config.inlier_unit.buffers == 2)
        set(ModuleId::inlier_sweep, inlier_sweep(function, config));
    set(ModuleId::result_collector, result_collector(config));
    if (memory.is_axi)
        bring_all(result, config, stimulus, sample, function, memory);
    return result;
}

}  // namespace faster::testing

#include "modules/core/memory_entries.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/memory/memory_load.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

namespace {

constexpr std::uint64_t header_bytes = 64;
constexpr std::uint64_t result_bytes = 32;
constexpr std::uint64_t vertex_bytes = 8;
constexpr std::uint64_t word_bytes = 4;
constexpr std::uint64_t pixel_bytes = 2;

timing::MemoryBlock range(std::uint64_t address, std::uint64_t tokens, std::uint64_t token_bytes) {
    timing::MemoryBlock block;
    block.address = address;
    block.bytes = tokens * token_bytes;
    block.tokens = tokens;
    block.token_bytes = token_bytes;
    return block;
}

/// Positions of the image from `begin` to `end`, one behind the last; none if they are equal.
struct Extent {
    std::int64_t begin;
    std::int64_t end;
};
Extent within(std::int64_t begin, std::int64_t end, int size) {
    std::int64_t const first = std::clamp<std::int64_t>(begin, 0, size);
    return {first, std::clamp<std::int64_t>(end, first, size)};
}

std::uint64_t most_triangles(Stimulus const& stimulus) {
    std::uint64_t most = 0;
    for (SampleInput const& sample : stimulus.samples)
        most = std::max<std::uint64_t>(most, sample.triangle_count);
    return most;
}

void require_room(char const* key, std::uint64_t room, std::uint64_t needed, char const* what) {
    if (room < needed)
        throw InputError(fmt::format("accelerator.memory.{} = {}, expected at least {}, {}", key, room, needed, what));
}

}  // namespace

timing::MemoryEntry header_entry(MemoryPlacement const& placement, std::size_t i, std::size_t sample) {
    return {i, {range(placement.header_address + header_bytes * sample, 1, header_bytes)}};
}

timing::MemoryEntry result_entry(MemoryPlacement const& placement, std::size_t i, std::size_t sample) {
    return {i, {range(placement.result_address + result_bytes * sample, 1, result_bytes)}};
}

timing::MemoryEntry mesh_entry(MemoryPlacement const& placement, std::size_t i, std::size_t triangles) {
    return {i, {range(placement.mesh_address, 3 * triangles, vertex_bytes)}};
}

timing::MemoryEntry table_entry(MemoryPlacement const& placement, std::size_t i, Stimulus const& stimulus,
                                SampleInput const& sample) {
    std::int64_t const top = stimulus.window_offset(sample.centre_row);
    std::int64_t const left = stimulus.window_offset(sample.centre_col);
    Extent const rows = within(top, top + stimulus.window, stimulus.height);
    Extent const cols = within(left, left + stimulus.window, stimulus.width);
    timing::MemoryEntry entry{i, {}};
    for (std::int64_t const row : {rows.begin, rows.end})
        for (std::int64_t const col : {cols.begin, cols.end}) {
            auto const word = static_cast<std::uint64_t>(row * (stimulus.width + 1) + col);
            entry.blocks.push_back(range(placement.table_address + word_bytes * word, 1, word_bytes));
        }
    return entry;
}

timing::MemoryEntry pixel_entry(MemoryPlacement const& placement, std::size_t i, Stimulus const& stimulus,
                                SampleInput const& sample, LaneRows const& rows) {
    auto const whole_cols = static_cast<std::int64_t>(rows.tokens_per_row() * rows.lanes());
    std::int64_t const cols = std::min(whole_cols, stimulus.window - static_cast<std::int64_t>(rows.first_col()));
    std::int64_t const top = stimulus.window_offset(sample.centre_row) + static_cast<std::int64_t>(rows.first_row());
    std::int64_t const left = stimulus.window_offset(sample.centre_col) + static_cast<std::int64_t>(rows.first_col());
    Extent const in_rows = within(top, top + static_cast<std::int64_t>(rows.rows()), stimulus.height);
    Extent const in_cols = within(left, left + cols, stimulus.width);
    timing::MemoryBlock block;
    block.bytes = pixel_bytes * static_cast<std::uint64_t>(in_cols.end - in_cols.begin);
    block.token_bytes = pixel_bytes * rows.lanes();
    block.tokens = rows.tokens_per_row();
    block.rows = rows.rows();
    block.fetched_rows = static_cast<std::uint64_t>(in_rows.end - in_rows.begin);
    block.pitch = pixel_bytes * static_cast<std::uint64_t>(stimulus.width);
    if (block.bytes > 0 && block.fetched_rows > 0) {
        block.address = placement.image_address +
                        pixel_bytes * static_cast<std::uint64_t>(in_rows.begin * stimulus.width + in_cols.begin);
        block.lead = pixel_bytes * static_cast<std::uint64_t>(in_cols.begin - left);
        block.first_row = static_cast<std::uint64_t>(in_rows.begin - top);
    }
    return {i, {block}};
}

std::vector<timing::LoadedRange> loaded_before(MemoryPlacement const& placement, Stimulus const& stimulus) {
    std::vector<timing::LoadedRange> ranges;
    if (stimulus.samples.empty())
        return ranges;
    if (placement.mesh == Placement::on_chip)
        ranges.push_back({placement.mesh_address, 3 * vertex_bytes * most_triangles(stimulus), 0});
    if (placement.observation == Placement::on_chip)
        ranges.push_back(
            {placement.image_address,
             pixel_bytes * static_cast<std::uint64_t>(stimulus.width) * static_cast<std::uint64_t>(stimulus.height),
             placement.observation_copies});
    return ranges;
}

void check_fits_on_chip(MemoryPlacement const& placement, Stimulus const& stimulus) {
    if (placement.mesh == Placement::on_chip)
        require_room("mesh_triangles", placement.mesh_triangles, most_triangles(stimulus),
                     "those of the largest sample");
    if (placement.observation == Placement::on_chip) {
        require_room("observation_width", placement.observation_width, static_cast<std::uint64_t>(stimulus.width),
                     "that of the observed image");
        require_room("observation_height", placement.observation_height, static_cast<std::uint64_t>(stimulus.height),
                     "that of the observed image");
    }
}

}  // namespace faster

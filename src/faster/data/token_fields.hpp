#pragma once
#include <array>
#include <cstdint>

#include "dataflow/base/token_field.hpp"
#include "faster/data/buffer_tokens.hpp"
#include "faster/data/tokens.hpp"

namespace dataflow {

// The fields of the tokens of FIFOs that are no plain numbers (see TokenFields).

template <> struct TokenFields<faster::SampleHeader> {
    static constexpr std::array<TokenField, 4> layout{
        {{"sample", 32}, {"centre_row", 32, true}, {"centre_col", 32, true}, {"triangles", 32}}};
    static std::array<std::int64_t, 4> values(faster::SampleHeader const& t) {
        return {t.sample, t.centre_row, t.centre_col, t.triangles};
    }
};
template <> struct TokenFields<faster::VertexCode> {
    static constexpr std::array<TokenField, 3> layout{{{"x", 16, true}, {"y", 16, true}, {"z", 16}}};
    static std::array<std::int64_t, 3> values(faster::VertexCode const& t) { return {t.x, t.y, t.z}; }
};
template <> struct TokenFields<faster::Command> {
    static constexpr std::array<TokenField, 1> layout{
        {{"command", 2, false, TokenField::only_lane, faster::command_names}}};
    static std::array<std::int64_t, 1> values(faster::Command t) { return {static_cast<std::int64_t>(t)}; }
};
template <> struct TokenFields<faster::FragmentIndex> {
    static constexpr std::array<TokenField, 2> layout{{{"row", 16, true}, {"col", 16, true}}};
    static std::array<std::int64_t, 2> values(faster::FragmentIndex const& t) { return {t.row, t.col}; }
};
template <> struct TokenFields<faster::PixelGroup> {
    static constexpr std::array<TokenField, 3> layout{{{"row", 16, true}, {"col", 16, true}, {"mask", 32}}};
    static std::array<std::int64_t, 3> values(faster::PixelGroup const& t) { return {t.row, t.col, t.mask}; }
};
template <> struct TokenFields<faster::DepthGroup> {
    static constexpr std::array<TokenField, 2> layout{{{"value", 64, true}, {"per_column", 64, true}}};
    static std::array<std::int64_t, 2> values(faster::DepthGroup const& t) { return {t.z_sum, t.z_sum_per_column}; }
};
template <> struct TokenFields<faster::EdgeToken> {
    static constexpr std::array<TokenField, 3> layout{
        {{"row", 16, true},
         {"col", 16, true},
         {"kind", 2, false, TokenField::only_lane, faster::edge_token_kind_names}}};
    static std::array<std::int64_t, 3> values(faster::EdgeToken const& t) {
        return {t.row, t.col, static_cast<std::int64_t>(t.kind)};
    }
};
/// edge_map, observed_edge.
template <> struct TokenFields<std::uint8_t> {
    static constexpr std::array<TokenField, 1> layout{{{"edge", 1}}};
    static std::array<std::int64_t, 1> values(std::uint8_t t) { return {t}; }
};
/// observed_depth.
template <> struct TokenFields<std::uint16_t> {
    static constexpr std::array<TokenField, 1> layout{{{"depth", 16}}};
    static std::array<std::int64_t, 1> values(std::uint16_t t) { return {t}; }
};
/// map_free, depth_free.
template <> struct TokenFields<faster::BufferNumber> {
    static constexpr std::array<TokenField, 1> layout{{{"buffer", 1}}};
    static std::array<std::int64_t, 1> values(faster::BufferNumber t) { return {t.number}; }
};
/// Last those of the region, which only some configurations have.
template <> struct TokenFields<faster::FullMaps> {
    static constexpr std::array<TokenField, 5> layout{{{"buffer", 1},
                                                       {"first_row", 16, true},
                                                       {"first_col", 16, true},
                                                       {"last_row", 16, true},
                                                       {"last_col", 16, true}}};
    static std::array<std::int64_t, 5> values(faster::FullMaps const& t) {
        return {t.buffer.number, t.region.first.row, t.region.first.col, t.region.last.row, t.region.last.col};
    }
};
template <> struct TokenFields<faster::FullDepthBuffer> {
    static constexpr std::array<TokenField, 6> layout{{{"buffer", 1},
                                                       {"valid_raster", 64},
                                                       {"first_row", 16, true},
                                                       {"first_col", 16, true},
                                                       {"last_row", 16, true},
                                                       {"last_col", 16, true}}};
    static std::array<std::int64_t, 6> values(faster::FullDepthBuffer const& t) {
        return {t.buffer.number,    static_cast<std::int64_t>(t.valid_raster),
                t.region.first.row, t.region.first.col,
                t.region.last.row,  t.region.last.col};
    }
};
/// Last those of hidden pixels, likewise.
template <> struct TokenFields<faster::SampleCounters> {
    static constexpr std::array<TokenField, faster::sample_counter_count> layout = [] {
        std::array<TokenField, faster::sample_counter_count> fields{};
        for (std::size_t i = 0; i < faster::sample_counter_count; ++i)
            fields[i] = {faster::sample_counters[i].name, 64};
        return fields;
    }();
    static std::array<std::int64_t, faster::sample_counter_count> values(faster::SampleCounters const& t) {
        std::array<std::int64_t, faster::sample_counter_count> values{};
        for (std::size_t i = 0; i < faster::sample_counter_count; ++i)
            values[i] = static_cast<std::int64_t>(counter(faster::sample_counters[i], t));
        return values;
    }
};

}  // namespace dataflow

namespace faster {

/// How many of a token's last fields are a region's.
constexpr std::size_t region_fields = 4;

}  // namespace faster

#pragma once
#include <algorithm>
#include <cstdint>

#include "channels/clocked_fifo.hpp"
#include "faster/data/token_fields.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster {

/// Where a sample's window lies in the image, or near enough for its tokens.
struct WindowPlace {
    int row = 0;
    int col = 0;

    static WindowPlace of(CoreContext const& core, SampleHeader const& header) {
        return {core.stimulus.near_window_offset(header.centre_row),
                core.stimulus.near_window_offset(header.centre_col, core.config.rasterizer.lanes)};
    }
    EdgeToken token(int image_row, int image_col, EdgeTokenKind kind) const {
        return {static_cast<std::int16_t>(image_row - row), static_cast<std::int16_t>(image_col - col), kind};
    }
};

/// The tokens of a triangle's scan, written straight into the channels. Without a channel of edge tokens (flow
/// fpga_grip) only write_fragments() may be called.
class ScanBurst {
  public:
    void connect(ClockedFifo<Command>& command, ClockedFifo<std::int64_t>& depth, ClockedFifo<FragmentIndex>& index,
                 ClockedFifo<EdgeToken>* edge_token) {
        command_ = &command;
        depth_ = &depth;
        index_ = &index;
        edge_token_ = edge_token;
    }

    /// Room for all that a scan may send: a fragment and two edge tokens for every pixel of the box.
    void begin(datapath::TriangleSetup const& setup) {
        command_->await_room();
        depth_->await_room();
        index_->await_room();
        if (edge_token_ != nullptr)
            edge_token_->await_room();
        auto const pixels = static_cast<std::size_t>(setup.right_wall - setup.left_wall + 1) *
                            static_cast<std::size_t>(setup.bottom - setup.start_row + 1);
        next_command_ = command_->reserve(pixels);
        first_depth_ = next_depth_ = depth_->reserve(pixels);
        next_index_ = index_->reserve(pixels);
        first_token_ = next_token_ = edge_token_ != nullptr ? edge_token_->reserve(2 * pixels) : nullptr;
    }

    /// The fragments of a line's covered run, an object token for each, and edge tokens: behind the first fragment that
    /// of `before`, if there is one; behind the last, if the scan `leaves` the triangle, the next pixel's.
    void write_run(datapath::ScanLine const& line, WindowPlace const& window, EdgeToken const* before, bool leaves) {
        std::int64_t* depth = next_depth_;
        FragmentIndex* index = next_index_;
        EdgeToken* token = next_token_;
        std::int64_t z_sum = line.z_sum;
        auto const row = static_cast<std::int16_t>(line.row - window.row);
        int col = line.col(line.before) - window.col;
        int const end = col + line.inside * line.step;
        auto const write = [&] {
            *depth++ = z_sum;
            *index++ = {row, static_cast<std::int16_t>(col)};
            *token++ = {row, static_cast<std::int16_t>(col), EdgeTokenKind::Object};
            z_sum += line.z_sum_per_step;
            col += line.step;
        };
        write();
        if (before != nullptr)
            *token++ = *before;
        while (col != end)
            write();
        if (leaves)
            *token++ = {row, static_cast<std::int16_t>(col), EdgeTokenKind::Edge};
        next_depth_ = depth;
        next_index_ = index;
        next_token_ = token;
    }
    /// The fragments of a line's covered run, and nothing of its edges.
    void write_fragments(datapath::ScanLine const& line, WindowPlace const& window) {
        auto const row = static_cast<std::int16_t>(line.row - window.row);
        int col = line.col(line.before) - window.col;
        std::int64_t z_sum = line.z_sum;
        for (int left = line.inside; left > 0; --left, col += line.step, z_sum += line.z_sum_per_step) {
            *next_depth_++ = z_sum;
            *next_index_++ = {row, static_cast<std::int16_t>(col)};
        }
    }
    /// Edge tokens of a line's pixels from `first` to `end`, one behind the last.
    void write_edges(datapath::ScanLine const& line, WindowPlace const& window, int first, int end) {
        for (int pixel = first; pixel < end; ++pixel)
            write_edge(window.token(line.row, line.col(pixel), EdgeTokenKind::Edge));
    }
    void write_edge(EdgeToken const& token) { *next_token_++ = token; }

    /// Calls with every pixel and every edge token that has been written and not yet handed over.
    template <class Call> void for_each_fragment(Call call) const {
        for (FragmentIndex const* index = next_index_ - fragments(); index != next_index_; ++index)
            call(*index);
    }
    template <class Call> void for_each_token(Call call) const {
        for (EdgeToken const* token = first_token_; token != next_token_; ++token)
            call(*token);
    }

    /// Makes what has been written part of the channels.
    void hand_over() {
        std::size_t const count = fragments();
        next_command_ = std::fill_n(next_command_, count, Command::Fragment);
        command_->append(count);
        depth_->append(count);
        index_->append(count);
        if (edge_token_ != nullptr)
            edge_token_->append(static_cast<std::size_t>(next_token_ - first_token_));
        first_depth_ = next_depth_;
        first_token_ = next_token_;
    }
    /// `lockstep` needs tokens in the channels before the iterations that write them.
    void hand_over_if(bool lockstep) {
        if (lockstep)
            hand_over();
    }
    /// hand_over() at the end of the scan.
    void end() {
        hand_over();
        command_->wake_reader();
        depth_->wake_reader();
        index_->wake_reader();
        if (edge_token_ != nullptr)
            edge_token_->wake_reader();
    }

  private:
    std::size_t fragments() const { return static_cast<std::size_t>(next_depth_ - first_depth_); }

    ClockedFifo<Command>* command_ = nullptr;
    ClockedFifo<std::int64_t>* depth_ = nullptr;
    ClockedFifo<FragmentIndex>* index_ = nullptr;
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;
    std::int64_t const* first_depth_ = nullptr;  ///< not handed over
    EdgeToken const* first_token_ = nullptr;
    Command* next_command_ = nullptr;  ///< to be written
    std::int64_t* next_depth_ = nullptr;
    FragmentIndex* next_index_ = nullptr;
    EdgeToken* next_token_ = nullptr;
};

}  // namespace faster

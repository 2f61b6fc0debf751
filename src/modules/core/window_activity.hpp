#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/recording/memory_activity.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/lane_rows.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Accesses to memories that have a word for each pixel of the window, for waveforms. What derives from this works out
/// from the tokens at which pixel an iteration is; what it does around a pixel, the module's description says.
class WindowActivity : public recording::MemoryActivity {
  public:
    /// Who fills a buffer of the memories, and the FIFOs by which buffers are handed over.
    struct Buffers {
        std::size_t filled_by = 0;
        std::size_t full = 0;
        std::size_t free = 0;
    };

    /// `machine` is the one that the configuration makes, and must outlive this.
    WindowActivity(AcceleratorConfig const& config, Machine const& machine, Buffers const& buffers);

    void token_read(recording::TokenRead const& read) override;
    void iterated(recording::LoopIteration const& iteration, recording::MemoryPorts& ports) override;

  protected:
    /// What a token says of the window: a pixel, or a group of pixels of a row; at a sample's end a region's corner.
    struct Token {
        std::int64_t row = 0;
        std::int64_t col = 0;  ///< of the first pixel
        std::int64_t kind = 0;
        std::int64_t mask = 1;  ///< bit k: the pixel k columns to the right
    };

    /// Puts the accesses of an iteration of one of the loops into ports().
    virtual void access_for(recording::LoopIteration const& iteration) = 0;

    recording::MemoryPorts const& ports() const { return *ports_; }
    std::int64_t side() const { return side_; }
    bool scans_groups() const { return scans_groups_; }

    /// What the process at hand reads out, as tokens of so many pixels: what two corners enclose which the filling
    /// process has read last, or what it got with its buffer. Without regions, the window.
    LaneRows rows_at_hand(std::int64_t lanes, Token const& first, Token const& last) const;
    /// The pixels of the window in an iteration's token. There are none before the first and behind the last.
    static std::vector<std::int64_t> pixels_of(LaneRows const& rows, std::int64_t iteration);

    /// Of the pixels that a token stands for.
    static std::vector<std::int64_t> cols_of(Token const& token);

    // Accesses of the process at hand; of pixels beside the window there are none
    void access(std::size_t memory, bool writes, std::int64_t pixel);
    void access(std::size_t memory, bool writes, std::int64_t row, std::int64_t col);
    void access(std::size_t memory, bool writes, std::vector<PixelOffset> const& words, std::int64_t row,
                std::int64_t col);
    /// What a pattern says of a pixel's word and of those around it.
    void access_around(std::size_t memory, AccessPattern const& words, std::int64_t row, std::int64_t col);
    /// A word, or where the loop is wide, the same word of every bank.
    void clear(std::size_t memory, MapClearing clearing, std::int64_t iteration);

  private:
    void clear_in_all_banks(std::size_t memory, std::uint64_t word);
    static PixelBox box_between(Token const& first, Token const& last);
    PixelBox box_at_hand(Token const& first, Token const& last) const;
    void take_buffer(recording::TokenRead const& read);

    Machine const& machine_;
    Buffers fifos_;
    std::int64_t side_;
    bool scans_groups_;
    bool has_regions_;
    std::vector<std::size_t> buffers_;  ///< that a process is at
    std::vector<PixelBox> regions_;     ///< of a buffer that a process has been given to read out
    std::size_t process_ = 0;           ///< at hand
    recording::MemoryPorts* ports_ = nullptr;
};

}  // namespace faster

#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/recording/memory_activity.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/edge_map_algorithm.hpp"
#include "faster/config/extract_design.hpp"
#include "faster/config/lane_rows.hpp"
#include "faster/config/sweep_design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Which words of its block RAMs a raster core accesses, worked out from the tokens that its modules read: for
/// waveforms. Sources: thesis chapter 5, A.2, A.3.
class RasterCoreActivity : public recording::MemoryActivity {
  public:
    /// `machine` is the one that the configuration makes, and must outlive this.
    RasterCoreActivity(AcceleratorConfig const& config, Machine const& machine);

    void token_read(recording::TokenRead const& read) override;
    void iterated(recording::LoopIteration const& iteration, recording::MemoryPorts& ports) override;

  private:
    /// What an iteration of a loop does to the memories.
    enum class Work { nothing, clear_maps, take_token, read_maps_out, clear_depths, draw_fragment, sweep, extract };

    /// What a token says of the window: a pixel, or a group of pixels of a row; at a sample's end a region's corner.
    struct Token {
        std::int64_t row = 0;
        std::int64_t col = 0;  ///< of the first pixel
        std::int64_t kind = 0;
        std::int64_t mask = 1;  ///< bit k: the pixel k columns to the right
    };

    /// What a branch of the token loop accesses, seen from the token's pixel.
    struct TokenBranch {
        explicit TokenBranch(PerMap const& touches);
        AccessPattern edge_map;
        AccessPattern object_map;
    };

    void note_works(Machine const& machine);
    void take_buffer(recording::TokenRead const& read);
    bool hands_over_full_buffer(std::size_t fifo) const { return fifo == map_full_ || fifo == depth_full_; }
    bool hands_over_buffer(std::size_t fifo) const {
        return hands_over_full_buffer(fifo) || fifo == map_free_ || fifo == depth_free_;
    }
    Token edge_token_of(recording::TokenValues const& fields) const;

    // Regions of the window
    PixelBox box_between(Token const& first, Token const& last) const;
    PixelBox box_of_maps() const;
    PixelBox box_of_depths() const;
    static std::vector<std::int64_t> pixels_of(LaneRows const& rows, std::int64_t iteration);
    bool is_inner(std::int64_t pixel) const;

    // Iterations
    void clear_maps(std::int64_t iteration);
    void clear(std::size_t memory, MapClearing clearing, std::int64_t iteration);
    void clear_in_all_banks(std::size_t memory, std::uint64_t word);
    void take_token(Cycles cycle);
    void read_maps_out(std::int64_t iteration);
    void draw_fragment(Cycles cycle);
    void sweep(std::int64_t iteration);
    void sweep_word(std::int64_t pixel);
    void sweep_neighbours(std::int64_t pixel);
    void extract(std::int64_t iteration);
    void extract_pixel(std::int64_t judged);

    // Accesses; of pixels beside the window there are none
    void access(std::size_t memory, bool writes, std::int64_t pixel);
    void access(std::size_t memory, bool writes, std::int64_t row, std::int64_t col);
    void access_words(std::size_t memory, AccessPattern const& words, std::int64_t row, std::int64_t col);
    void access_around(std::size_t memory, bool writes, std::vector<PixelOffset> const& words, Token const& token);

    Machine const& machine_;
    EdgeMapConfig edge_map_config_;
    TokenBranch edge_branch_, object_branch_, second_;
    MapClearing depth_clearing_;
    AccessPattern fragment_words_, sweep_words_;  ///< around a pixel: of a fragment, and of one that is judged
    SweepDesign sweep_;
    ExtractDesign extract_;
    std::int64_t extract_radius_;
    std::int64_t side_;
    std::int64_t lanes_;
    bool scans_groups_;
    bool sweeps_touched_;

    // Numbers of the machine's parts.
    std::size_t edge_map_builder_, inlier_unit_;
    std::size_t edge_token_, fragment_index_, map_full_, map_free_, depth_full_, depth_free_;
    std::size_t edge_map_, object_map_, depth_buffer_;
    std::vector<Work> works_;  // by loop

    // What is at hand.
    std::size_t process_ = 0;
    recording::MemoryPorts* ports_ = nullptr;
    // What has happened, by process.
    std::vector<std::size_t> buffers_;  // that it is at
    std::vector<PixelBox> regions_;     // of a buffer that it has been given to read out
    // Tokens read last.
    Token token_;  // that the edge map builder works on; in the end a region's first corner
    Token next_;   // read ahead; in the end its last corner
    Token fragment_before_;
    Token fragment_;  // in the end a region's last corner
    Cycles token_read_ = 0;
    Cycles fragment_read_ = ~Cycles{0};
};

}  // namespace faster

#pragma once
#include <vector>

#include "faster/accelerator_config.hpp"
#include "faster/extract_design.hpp"
#include "faster/lane_rows.hpp"
#include "faster/sweep_design.hpp"
#include "kernel/machine/bank_partition.hpp"
#include "kernel/recording/event_merge.hpp"

namespace faster::recording {

/// One access of a block RAM port, as the static schedule of a loop iteration has it.
struct BramAccess {
    std::size_t bram = 0;
    /// Of all banks: bank b has ports b * ports .. (b + 1) * ports - 1; then those of the next buffer.
    std::uint64_t port = 0;
    Cycles cycle = 0;
    bool writes = false;  ///< the slot of a write; whether the data let it happen is not looked at
    std::uint64_t address = 0;
    std::size_t buffer = 0;  ///< which of two
};

/// Which addresses the iterations of one core access, from the tokens its processes read (thesis chapter 5,
/// A.2, A.3). Accesses of
/// one iteration to one bank take its ports in turn, a cycle later where there are not enough.
class BramModel {
  public:
    explicit BramModel(AcceleratorConfig const& config);

    /// To be told of every event of the core; `fields` are those of the token that a read reads. Returns the accesses
    /// of an iteration, valid until the next call.
    std::vector<BramAccess> const& take(CoreEvent const& event, TokenValues const& fields);

  private:
    void iterate(LoopId loop, Event const& event);
    void clear_iteration(BramId bram, MapClearing clearing, Event const& event);
    struct Token {
        std::int64_t row = 0;
        std::int64_t col = 0;  ///< of the first pixel
        std::int64_t kind = 0;
        std::int64_t mask = 1;  ///< bit k: the pixel k columns to the right
    };
    void take_buffer(FifoId fifo, TokenValues const& fields);
    PixelBox box_between(Token const& first, Token const& last) const;
    PixelBox box_of_maps() const;
    PixelBox box_of_depths() const;
    LaneRows swept_rows() const;
    static std::vector<std::int64_t> pixels_of(LaneRows const& rows, std::int64_t iteration);
    void token_iteration(Cycles cycle);
    void single_map_token(Cycles cycle);
    void dual_map_token(bool is_first, Cycles cycle);
    void output_iteration(std::int64_t iteration, Cycles cycle);
    void fragment_iteration(Cycles cycle);
    void extract_iteration(std::int64_t iteration, Cycles cycle);
    void extract_pixel(std::int64_t judged, Cycles cycle);
    void sweep_iteration(std::int64_t iteration, Cycles cycle);
    void sweep_word(std::int64_t pixel, Cycles cycle);
    void sweep_neighbours(std::int64_t pixel, Cycles cycle);
    bool is_read(BramId bram, std::int64_t address) const;
    bool is_inner(std::int64_t pixel) const;
    void add(BramId bram, bool writes, std::int64_t row, std::int64_t col, Cycles cycle);
    void add(BramId bram, bool writes, std::int64_t address, Cycles cycle);
    std::uint64_t accesses_so_far(std::size_t bram, std::uint64_t bank) const;

    EdgeMapConfig edge_map_;
    MapClearing depth_clearing_;
    SweepDesign sweep_;
    ExtractDesign extract_;
    std::int64_t extract_radius_;
    std::int64_t side_;
    std::int64_t lanes_;
    bool scans_groups_;
    bool sweeps_touched_;
    std::array<std::uint64_t, bram_count> ports_{};  ///< of a bank
    std::vector<BankPartition> partitions_;          ///< [BramId]
    std::array<std::size_t, module_count> loop_{};
    std::array<std::size_t, module_count> buffer_{};  ///< that a module is at
    std::array<PixelBox, module_count> region_{};     ///< of a buffer that a module has been given to read out
    std::size_t module_ = 0;                          ///< whose event is at hand
    Token token_of(TokenValues const& fields) const;
    void add_pixels(BramId bram, bool writes, Token const& token, Cycles cycle);
    Token token_;     ///< that the edge-map builder works on; in the end a region's first corner
    Token next_;      ///< read ahead; in the end its last corner
    Token fragment_;  ///< read last; in the end a region's last corner
    Token fragment_before_;
    Cycles token_read_ = 0;
    Cycles fragment_read_ = ~Cycles{0};
    std::vector<BramAccess> accesses_;
};

}  // namespace faster::recording

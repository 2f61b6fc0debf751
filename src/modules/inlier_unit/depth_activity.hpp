#pragma once
#include "faster/config/extract_design.hpp"
#include "faster/config/sweep_design.hpp"
#include "modules/core/window_activity.hpp"

namespace faster {

/// Which words of its depth buffer the InlierUnit accesses, and who reads a second buffer out for it (thesis A.3).
class DepthActivity : public WindowActivity {
  public:
    DepthActivity(AcceleratorConfig const& config, Machine const& machine);

    void token_read(recording::TokenRead const& read) override;

  private:
    /// What an iteration of a loop does to the depths.
    enum class Work { nothing, clear, draw, sweep, extract };

    void access_for(recording::LoopIteration const& iteration) override;
    void draw(Cycles cycle);
    void access_fragment(bool writes, std::vector<PixelOffset> const& words);
    void sweep(std::int64_t iteration);
    void sweep_word(std::int64_t pixel);
    void sweep_neighbours(std::int64_t pixel);
    void extract(std::int64_t iteration);
    void extract_pixel(std::int64_t judged);
    bool is_inner(std::int64_t pixel) const;

    MapClearing clearing_;
    AccessPattern fragment_words_, sweep_words_;  // around a pixel: of a fragment, and of one that is judged
    SweepDesign sweep_;
    ExtractDesign extract_;
    std::int64_t extract_radius_;
    std::int64_t lanes_;
    std::size_t fragment_index_, depth_buffer_;  // numbers of the machine's parts
    std::vector<Work> works_;                    // by loop

    Token fragment_before_;  // in the end a region's first corner
    Token fragment_;         // read last; in the end a region's last corner
    Cycles fragment_read_ = ~Cycles{0};
};

}  // namespace faster

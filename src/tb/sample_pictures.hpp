#pragma once
#include <filesystem>
#include <map>
#include <vector>

#include "common/stimulus.hpp"
#include "io/colour_png.hpp"
#include "modules/core_context.hpp"
#include "report_html/html_report.hpp"

namespace faster {

/// Keeps what the first samples of a run left in the maps, and writes it as pictures (SPEC section 4, images).
class SamplePictures : public SampleProbe {
  public:
    /// Keeps samples below `count`.
    SamplePictures(Stimulus const& stimulus, std::size_t count) : stimulus_(stimulus), count_(count) {}

    void edge_maps_done(std::size_t sample, datapath::EdgeMaps const& maps) override;
    void depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) override;

    /// sample_NNNN_{edges,object,depth}.png for programs, sample_NNNN_overlay.png for people: contour red, object
    /// green, observed edges blue.
    void write(std::filesystem::path const& folder) const;

    /// The overlays for the HTML report.
    std::vector<report::ReportPicture> for_report() const;

  private:
    Image<io::Colour> overlay_of(std::size_t sample, SampleMaps const& maps) const;

    Stimulus const& stimulus_;
    std::size_t count_;
    std::map<std::size_t, SampleMaps> maps_;
};

}  // namespace faster

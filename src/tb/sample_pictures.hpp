#pragma once
#include <filesystem>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/html/html_report.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "modules/core/kept_maps.hpp"

namespace faster {

/// What the first samples of a run left in the maps, as pictures
/// (docs/formats.md#images-with---images-k).
class SamplePictures : public KeptMaps {
  public:
    /// Of samples below `count`.
    SamplePictures(Stimulus const& stimulus, std::size_t count) : KeptMaps(count), stimulus_(stimulus) {}

    /// sample_NNNN_{edges,object,depth}.png for programs; sample_NNNN_{overlay,depth_map}.png and contact_sheet.png for
    /// people. `samples` are those of the whole run.
    void write(std::filesystem::path const& folder, std::vector<SampleStatistics> const& samples) const;

    /// The overlays for the HTML report.
    std::vector<report::ReportPicture> for_report() const;

  private:
    Image<Colour> overlay_of(std::size_t sample, SampleMaps const& maps) const;
    void write_contact_sheet(std::filesystem::path const& file, std::vector<SampleStatistics> const& samples) const;

    Stimulus const& stimulus_;
};

}  // namespace faster

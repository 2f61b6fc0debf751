#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "dataflow/commands/run_extras.hpp"
#include "faster/dataflow_names.hpp"
#include "tb/sample_pictures.hpp"

namespace faster {

/// What `run` has for FASTER besides: --trace, and pictures of samples.
class FasterRunExtras final : public RunExtras {
  public:
    void declare(CLI::App& command) override;
    std::vector<std::string> overrides(std::vector<std::string> const& given) const override;
    void check(bool has_output) const override;
    void before(Workload& workload) override;
    bool writes_pictures() const override { return images_ > 0; }
    void write(std::filesystem::path const& folder, std::vector<SampleStatistics> const& samples) const override;
    std::vector<std::string> warnings(std::vector<SampleStatistics> const& samples) const override;
    std::vector<report::ReportPicture> pictures() const override;

  private:
    std::string trace_;        ///< folder; empty: as configured
    std::int64_t images_ = 0;  ///< samples to write pictures of
    std::unique_ptr<SamplePictures> pictures_;
};

}  // namespace faster

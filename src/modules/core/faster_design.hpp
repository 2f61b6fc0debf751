#pragma once
#include "dataflow/run/config/design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// FASTER, and its baseline FPGA_GRIP, as the kernel's tools see them.
class FasterDesign final : public Design {
  public:
    std::string name() const override { return "faster"; }
    std::unique_ptr<DesignConfig> default_config() const override;
    std::vector<Key> keys() const override;
    CoreDescription core(RunConfig const& config) const override;
    std::vector<std::string> complaints(LoadedConfig const& loaded) const override;
    IdleKeys idle_keys(RunConfig const& config) const override;
    bool decides_function(std::string const& key, RunConfig const& config) const override;
    std::string why_not_retimable(std::string const& key) const override;
    std::vector<Preset> const& presets() const override;
    /// Of a stimulus trace.
    std::vector<std::filesystem::path> files_of(std::filesystem::path const& folder) const override;
    std::vector<ColumnFacts> const& counters() const override;
    std::size_t counters_of_all() const override;
    std::size_t counters_of(RunConfig const& config) const override;
    std::string workload_table() const override { return "poses.csv"; }
    bool leaves_out_of_loops_csv(std::string const& loop) const override;
    std::string main_counter() const override { return "inlier"; }
};

}  // namespace faster

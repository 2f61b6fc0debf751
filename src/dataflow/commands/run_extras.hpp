#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "channels/simulated_design.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/html/html_report.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library has it
class App;
}

namespace dataflow {

/// What a design adds to `run`: options of its own, and what they write. The default adds nothing.
class RunExtras {
  public:
    virtual ~RunExtras() = default;
    virtual void declare(CLI::App& /*command*/) {}
    /// Settings that its options stand for, as KEY=VALUE. `given`: those of --set. Errors: InputError if they
    /// contradict.
    virtual std::vector<std::string> overrides(std::vector<std::string> const& /*given*/) const { return {}; }
    /// `has_output`: there is a folder or a page to write to. Errors: InputError.
    virtual void check(bool /*has_output*/) const {}
    /// The workload is there, and nothing is elaborated yet.
    virtual void before(Workload& /*workload*/) {}
    /// Whether write() is to be called, with a folder for pictures and the samples of the run.
    virtual bool writes_pictures() const { return false; }
    virtual void write(std::filesystem::path const& /*folder*/,
                       std::vector<SampleStatistics> const& /*samples*/) const {}
    /// What in the results looks like a mistake, a line each.
    virtual std::vector<std::string> warnings(std::vector<SampleStatistics> const& /*samples*/) const { return {}; }
    /// For the HTML page.
    virtual std::vector<report::ReportPicture> pictures() const { return {}; }
};

/// Made anew for every run.
using MakeRunExtras = std::function<std::unique_ptr<RunExtras>()>;

}  // namespace dataflow

#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/column.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/idle_keys.hpp"
#include "dataflow/run/config/key.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// A design that `accelerator.architecture` names: what a file of configs/architectures says.
struct Preset {
    std::string name;  ///< the file's, without .yaml
    std::string text;  ///< YAML
};

/// What all tools of the kernel ask a design. A program has one design: whoever builds the program defines design().
class Design {
  public:
    virtual ~Design() = default;

    /// One word, e.g. "faster".
    virtual std::string name() const = 0;
    virtual std::unique_ptr<DesignConfig> default_config() const = 0;
    /// Every key of the design but `simulation.*`, in the order of the documentation; machine_keys() makes those of
    /// its FIFOs, loops and block RAMs.
    virtual std::vector<Key> keys() const = 0;
    /// A core of a configuration: its modules, and the FIFOs that join them.
    virtual CoreDescription core(RunConfig const& config) const = 0;
    /// Once a configuration has been read, before its core is looked at. Errors: InputError for a part without keys.
    virtual void require_keys_of_parts(RunConfig const& config) const;
    /// What no key can say on its own, ready to print. The machine's own checks are made besides.
    virtual std::vector<std::string> complaints(LoadedConfig const& loaded) const;
    /// Keys that mean nothing in a configuration. Those of parts of the machine that are not there are known besides.
    virtual IdleKeys idle_keys(RunConfig const& config) const;
    /// Whether a key that decides about time otherwise decides about more in this configuration.
    virtual bool decides_function(std::string const& key, RunConfig const& config) const;
    /// Why a key cannot be changed without running again, to follow its name.
    virtual std::string why_not_retimable(std::string const& key) const;
    /// Files of values to start from, which `accelerator.architecture` names. None: there is no such key.
    virtual std::vector<Preset> const& presets() const;
    /// The files that make up what a folder means that a key names, in a fixed order. All that are in it, by path.
    virtual std::vector<std::filesystem::path> files_of(std::filesystem::path const& folder) const;
    /// The file among the results of a run that has what its workload was made of. Empty: none.
    virtual std::string workload_table() const;
    /// The counters that a sample's result consists of.
    virtual std::vector<ColumnFacts> const& counters() const = 0;
    /// How many of them, the first ones, are there in every configuration; the others all or not. All.
    virtual std::size_t counters_of_all() const;
    /// How many of them, the first ones, a configuration has. All.
    virtual std::size_t counters_of(RunConfig const& config) const;
    /// A loop, as MODULE.LOOP, that stands in all_loops.csv only. None.
    virtual bool leaves_out_of_loops_csv(std::string const& loop) const;
    /// The one that says most: new budgets guard it. Empty if there are none.
    virtual std::string main_counter() const;
};

/// The design of this program.
Design const& design();

/// Names of the design's presets; the one that all others are compared with first, which has the design's own name.
std::vector<std::string> preset_names();

/// Where messages say that a preset's keys stand.
inline std::string place_of_preset(std::string const& name) { return "configs/architectures/" + name + ".yaml"; }

/// What reports call the cores of this program's design.
std::string const& cores_are();

/// The machine of a configuration.
Machine machine_of(RunConfig const& config);

}  // namespace dataflow

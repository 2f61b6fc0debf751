#pragma once
#include <memory>

#include "dataflow/core/machine/machine_settings.hpp"

namespace dataflow {

/// `lockstep` brings the SystemC kernel to local time before every operation; `decoupled` lets processes run ahead.
enum class Engine { lockstep, decoupled };

/// Keys `simulation.*`.
struct SimulationConfig {
    Engine engine = Engine::decoupled;
};

/// What the keys of a design say: those that all machines have, and its own. Every design derives one.
class DesignConfig {
  public:
    virtual ~DesignConfig() = default;
    virtual std::unique_ptr<DesignConfig> clone() const = 0;
    virtual MachineSettings& machine() = 0;
    virtual MachineSettings const& machine() const = 0;
};

/// A whole configuration, resolved. A value: copies are independent.
class RunConfig {
  public:
    /// The defaults of the program's design.
    RunConfig();
    RunConfig(RunConfig const& other) : simulation(other.simulation), design_(other.design_->clone()) {}
    RunConfig(RunConfig&& other) noexcept = default;
    RunConfig& operator=(RunConfig other) noexcept {
        simulation = other.simulation;
        design_.swap(other.design_);
        return *this;
    }
    ~RunConfig() = default;

    MachineSettings& machine() { return design_->machine(); }
    MachineSettings const& machine() const { return static_cast<DesignConfig const&>(*design_).machine(); }
    /// What the program's design has made of it; `Config` is the class that it derives.
    template <class Config> Config& as() { return static_cast<Config&>(*design_); }
    template <class Config> Config const& as() const { return static_cast<Config const&>(*design_); }

    SimulationConfig simulation;

  private:
    std::unique_ptr<DesignConfig> design_;
};

}  // namespace dataflow

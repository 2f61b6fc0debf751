#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/run/config/calls.hpp"
#include "dataflow/run/config/design.hpp"

namespace dataflow {

/// A whole number of a design's own: one configuration key.
struct DesignNumber {
    std::string key;              ///< e.g. "workload.rows"
    std::uint64_t otherwise = 1;  ///< its value where a configuration does not say it
    std::string meaning;          ///< one sentence
    IntegerRange range{1, 1'000'000};
};

/// What a configuration says of a design's numbers.
class Numbers {
  public:
    /// By key. Errors: InputError if the design has no such number.
    std::uint64_t operator[](std::string const& key) const;
    std::uint64_t& of(std::string const& key) { return values_[key]; }
    std::uint64_t const& of(std::string const& key) const { return values_.at(key); }

  private:
    std::map<std::string, std::uint64_t> values_;
};

/// What the keys of a simple design say.
struct SimpleConfig final : DesignConfig {
    MachineSettings settings;
    Numbers numbers;

    std::unique_ptr<DesignConfig> clone() const override { return std::make_unique<SimpleConfig>(*this); }
    MachineSettings& machine() override { return settings; }
    MachineSettings const& machine() const override { return settings; }
};

/// What there is to know of a simple design besides its modules.
struct SimpleFacts {
    std::string name;                   ///< one word
    std::vector<DesignNumber> numbers;  ///< its own keys
    std::vector<ColumnFacts> counters;  ///< what its last module makes of a sample; may be empty
};

/// A design whose keys are those of its machine, `workload.samples`, and a few whole numbers. That is enough for all
/// that need no files and no choices. The derived class describes a core.
class SimpleDesign : public Design {
  public:
    explicit SimpleDesign(SimpleFacts facts);

    std::string name() const override { return facts_.name; }
    std::unique_ptr<DesignConfig> default_config() const override;
    std::vector<Key> keys() const override;
    CoreDescription core(RunConfig const& config) const override {
        return with_calls(describe(numbers_of(config)), config.machine());
    }
    void require_keys_of_parts(RunConfig const& config) const override { require_keys(numbers_of(config)); }
    std::vector<std::string> complaints(LoadedConfig const& loaded) const override;
    std::string why_not_retimable(std::string const& key) const override;
    std::vector<ColumnFacts> const& counters() const override { return facts_.counters; }

    static Numbers const& numbers_of(RunConfig const& config) { return config.as<SimpleConfig>().numbers; }

  protected:
    /// Keys are those of what is described for the defaults of the numbers. A part that only other values have is
    /// described always, with `only_if({numbers["workload.stages"] == 3, "workload.stages"})`.
    virtual CoreDescription describe(Numbers const& numbers) const = 0;
    /// Errors: InputError if those numbers add a part that has no keys.
    void require_keys(Numbers const& numbers) const;

  private:
    SimpleConfig defaults() const;
    std::vector<Key> keys_of(CoreDescription core) const;
    std::string changed_numbers(Numbers const& numbers) const;

    SimpleFacts facts_;
};

}  // namespace dataflow

#pragma once
#include <string>
#include <utility>
#include <vector>

#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// Keys that mean nothing in a configuration, because what they speak about is not there.
class IdleKeys {
  public:
    /// `beginning`: of the names of keys, or a whole name. `decided_by`: the key whose value makes them idle.
    void add(std::string beginning, std::string decided_by) {
        beginnings_.emplace_back(std::move(beginning), std::move(decided_by));
    }
    void add(IdleKeys const& others) {
        beginnings_.insert(beginnings_.end(), others.beginnings_.begin(), others.beginnings_.end());
    }

    /// The key that makes `key` idle; null if it is not.
    std::string const* decider_of(std::string const& key) const {
        for (auto const& [beginning, decided_by] : beginnings_)
            if (key.rfind(beginning, 0) == 0)
                return &decided_by;
        return nullptr;
    }

  private:
    std::vector<std::pair<std::string, std::string>> beginnings_;
};

/// All of a configuration: of the parts of the machine that are not there, and Design::idle_keys().
IdleKeys idle_keys(RunConfig const& config);

}  // namespace dataflow

#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernel/budgets/figures.hpp"
#include "kernel/budgets/limit.hpp"
#include "kernel/compare/run_record.hpp"

namespace faster::budgets {

/// A key of the accelerator whose value is not the default one.
using Setting = runs::ConfigurationEntry;

/// What a run was when somebody said that it is fine: what a breach is compared with.
struct Baseline {
    std::string date;                  ///< YYYY-MM-DD, UTC
    std::string reason;                ///< in the words of whoever wrote it
    std::string configuration;         ///< hash, see configuration_hash()
    std::vector<Setting> accelerator;  ///< keys with other values than their defaults
    Figures figures;
};

/// A budget file (docs/formats.md, "Budgets"). Paths are as written, relative to the file's folder.
struct Budget {
    std::filesystem::path file;
    std::string configuration;
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string trace;                   ///< empty: the workload as configured
    double time_limit_s = 60;            ///< of the host
    std::vector<Limit> limits;
    std::optional<Baseline> baseline;

    std::string name() const { return file.stem().string(); }
};

}  // namespace faster::budgets

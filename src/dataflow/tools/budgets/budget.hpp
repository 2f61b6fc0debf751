#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/tools/budgets/figures.hpp"
#include "dataflow/tools/compare/run_record.hpp"

namespace dataflow::budgets {

/// A number as a budget writes it.
struct Quantity {
    enum class Kind {
        count,         ///< cycles, tokens, pixels: what the figure counts
        microseconds,  ///< at the accelerator's clock
        baseline,      ///< what the budget's baseline has for the figure
    };
    Kind kind = Kind::count;
    double value = 0;
    std::string text;  ///< as written
};

/// Figures between `lower` and `upper`, both included.
struct Interval {
    std::optional<double> lower;
    std::optional<double> upper;
};

/// What a budget allows for all figures that a pattern matches. At least one of the quantities is there; `exact` and
/// `of` stand alone.
struct Limit {
    std::string figure;  ///< name or pattern
    int line = 0;        ///< in the budget file
    std::optional<Quantity> min;
    std::optional<Quantity> max;
    std::optional<Quantity> exact;
    std::optional<Quantity> of;  ///< within: {of, percent}
    double percent = 0;          ///< of within
    double slack = 0;            ///< percent by which max may be exceeded, and min be missed

    bool needs_baseline() const;
    /// For people, e.g. "max 1.5 ms".
    std::string text() const;
};

/// What the quantities of a limit are measured with.
struct Scale {
    double clock_mhz = 200;
    std::optional<std::uint64_t> baseline;  ///< of the figure
};

/// The limit as whole numbers: times round to the cycle that still keeps them. Throws InputError (without a place) for
/// an exact time that is no whole number of cycles. A quantity `baseline` needs one.
Interval interval_of(Limit const& limit, Scale const& scale);

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

}  // namespace dataflow::budgets

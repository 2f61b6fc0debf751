#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/budgets/budget.hpp"

namespace dataflow::budgets {

/// The keys of the accelerator that do not have their defaults.
std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys);

/// What a simulation has to tell about its budget's run; travels from one process to another as text.
struct Measurement {
    enum class Kind {
        figures,    ///< a finished run
        deadlock,   ///< `message` says who waits for whom
        bad_input,  ///< `message` is the one line of an InputError
        error,      ///< `message` says what broke in the model
    };
    Kind kind = Kind::figures;
    std::string message;
    double clock_mhz = 200;
    std::string configuration;  ///< hash
    std::vector<Setting> accelerator;
    Figures figures;
};

std::string to_text(Measurement const& measurement);
/// Throws std::runtime_error for text that to_text() did not write, for example cut off.
Measurement measurement_from_text(std::string const& text);

}  // namespace dataflow::budgets

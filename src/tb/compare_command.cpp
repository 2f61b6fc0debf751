#include "tb/compare_command.hpp"

#include <fmt/format.h>

#include "kernel/base/files/atomic_file.hpp"
#include "kernel/compare/compare.hpp"
#include "kernel/compare/comparison_json.hpp"
#include "kernel/compare/comparison_text.hpp"
#include "kernel/compare/read_run.hpp"
#include "tb/exit_codes.hpp"

namespace faster {

int compare(CompareRequest const& request) {
    runs::Comparison const comparison = runs::compare(runs::read_run(request.run_a), runs::read_run(request.run_b));
    if (!request.json.empty())
        io::write_file_atomically(request.json, runs::comparison_json(comparison));
    fmt::print("{}", runs::comparison_text(comparison, static_cast<std::size_t>(request.top)));
    return comparison.is_functionally_equal() ? exit_done : exit_failed_check;
}

}  // namespace faster

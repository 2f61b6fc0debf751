#include <systemc>

#include "common/program_commit.hpp"
#include "tb/commands.hpp"
#include "tb/evaluate_command.hpp"
#include "tb/faster_run_extras.hpp"
#include "tool/check_command.hpp"
#include "tool/run_command.hpp"
#include "tool/standard_commands.hpp"
#include "tool/sweep_command.hpp"
#include "tool/tool.hpp"

int sc_main(int argc, char** argv) {
    using namespace faster;
    return run_tool(
        {"faster-sim", "Cycle-accurate simulator of the FASTER pose-scoring accelerator", FASTER_VERSION,
         program_commit, program_commit_date},
        {run_command([] { return std::make_unique<FasterRunExtras>(); }), check_command(), record_command(),
         explore_command(), whatif_command(), sensitivities_command(), size_fifos_command(), compare_command(),
         compare_architectures_command(), cosim_command(), sweep_command(), edge_quality_command(), grip_command(),
         estimate_command(), evaluate_command(), experiment_command(), show_command(), keys_command()},
        argc, argv);
}

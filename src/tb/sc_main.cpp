#include <systemc>

#include "dataflow/commands/check_command.hpp"
#include "dataflow/commands/run_command.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/sweep_command.hpp"
#include "dataflow/commands/tool.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/commands/pose_commands.hpp"
#include "tb/commands.hpp"
#include "tb/faster_run_extras.hpp"
#include "tb/program_commit.hpp"

int sc_main(int argc, char** argv) {
    using namespace faster;
    std::vector<Subcommand> commands{run_command([] { return std::make_unique<FasterRunExtras>(); }),
                                     check_command(),
                                     record_command(),
                                     explore_command(),
                                     whatif_command(),
                                     sensitivities_command(),
                                     size_fifos_command(),
                                     compare_command(),
                                     cosim_command(),
                                     sweep_command(),
                                     schedule_command()};
    for (Subcommand& command : pose_commands())
        commands.push_back(std::move(command));
    commands.push_back(keys_command());
    return run_tool({"faster-sim", "Cycle-accurate simulator of the FASTER pose-scoring accelerator", FASTER_VERSION,
                     program_commit, program_commit_date},
                    commands, argc, argv);
}

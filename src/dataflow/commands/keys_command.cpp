#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/run/config/keys_as_markdown.hpp"

namespace dataflow {

Subcommand keys_command() {
    return {"keys", "Print every configuration key with meaning, unit, range and default (Markdown)", [](CLI::App&) {
                return [] {
                    say("{}", keys_as_markdown());
                    return exit_done;
                };
            }};
}

}  // namespace dataflow

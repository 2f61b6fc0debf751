#include "kernel/config/keys_as_markdown.hpp"
#include "tool/exit_codes.hpp"
#include "tool/say.hpp"
#include "tool/standard_commands.hpp"

namespace faster {

Subcommand keys_command() {
    return {"keys", "Print every configuration key with meaning, unit, range and default (Markdown)", [](CLI::App&) {
                return [] {
                    say("{}", keys_as_markdown());
                    return exit_done;
                };
            }};
}

}  // namespace faster

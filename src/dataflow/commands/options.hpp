#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace dataflow {

/// What several commands declare alike.

/// CLI::Range lets nan pass, and prints six digits of everything.
inline CLI::Validator number_in(double least, double most) {
    auto const check = [least, most](std::string const& text) {
        double number = 0;
        bool const is_sound = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
        return is_sound ? std::string{} : fmt::format("expected a number from {} to {}, found {}", least, most, text);
    };
    return CLI::Validator(check, fmt::format("NUMBER in [{} - {}]", least, most));
}

/// Of integers that CLI::Range, whose numbers are doubles or ints, cannot tell apart.
inline CLI::Validator integer_in(std::uint64_t least, std::uint64_t most) {
    auto const check = [least, most](std::string const& text) {
        std::uint64_t number = 0;
        bool const is_sound = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
        return is_sound ? std::string{} : fmt::format("expected an integer from {} to {}, found {}", least, most, text);
    };
    return CLI::Validator(check, fmt::format("INT in [{} - {}]", least, most));
}

/// Given again for each further value, which its help says.
inline void repeats(CLI::Option& option) { option.expected(1)->take_all()->allow_extra_args(false); }

inline void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    repeats(
        *command
             .add_option("--set", overrides,
                         "Override a key of the configuration, e.g. accelerator.fifos.NAME.depth=16; may be repeated")
             ->type_name("KEY=VALUE"));
}

/// Of work whose size is announced beforehand. `more`: what else it allows.
inline void add_force(CLI::App& command, bool& force, std::string const& more = "") {
    command.add_flag("--force", force, "Do it even if it takes more than an hour or more memory than there is" + more);
}

template <class Number> void add_jobs(CLI::App& command, Number& jobs, std::string const& what) {
    command.add_option("-j,--jobs", jobs, what + " (the host's cores)")->type_name("N")->check(CLI::Range(1, 1024));
}

}  // namespace dataflow

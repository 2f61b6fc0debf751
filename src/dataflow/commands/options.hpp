#pragma once
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "dataflow/base/nearest_name.hpp"

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

/// Large ones, too: the numbers of CLI::Range are doubles or ints.
inline CLI::Validator integer_in(std::uint64_t least, std::uint64_t most) {
    auto const check = [least, most](std::string const& text) {
        std::uint64_t number = 0;
        bool const is_sound = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
        return is_sound ? std::string{} : fmt::format("expected an integer from {} to {}, found {}", least, most, text);
    };
    return CLI::Validator(check, fmt::format("INT in [{} - {}]", least, most));
}

/// As CLI::IsMember, with an answer like that on a key of the configuration.
inline CLI::Validator one_of(std::vector<std::string> const& names) {
    auto const check = [names](std::string const& text) {
        bool const is_sound = std::find(names.begin(), names.end(), text) != names.end();
        return is_sound ? std::string{}
                        : fmt::format("expected one of {}, found {}{}", fmt::join(names, ", "), text,
                                      did_you_mean(text, names));
    };
    return CLI::Validator(check, fmt::format("{{{}}}", fmt::join(names, ",")));
}

/// Given again for each further value, which its help says.
inline void repeats(CLI::Option& option) { option.expected(1)->take_all()->allow_extra_args(false); }

inline void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
    repeats(*command
                 .add_option("--set", overrides,
                             "Override a key of the configuration, e.g. accelerator.clock_mhz=250; may be repeated")
                 ->type_name("KEY=VALUE"));
}

/// Of commands on a recorded run.
inline void add_events(CLI::App& command, std::string& events) {
    command.add_option("events", events, "Event file of run --events")->required()->type_name("EVENTS");
}

/// Of work whose size is announced beforehand. `more`: what else it allows.
inline void add_force(CLI::App& command, bool& force, std::string const& more = "") {
    command.add_flag("--force", force, "Do it even if it takes more than an hour or more memory than there is" + more);
}

template <class Number> void add_jobs(CLI::App& command, Number& jobs, std::string const& what) {
    command.add_option("-j,--jobs", jobs, what + " (the host's cores)")->type_name("N")->check(integer_in(1, 1024));
}

}  // namespace dataflow

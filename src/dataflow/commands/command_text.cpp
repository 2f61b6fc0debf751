#include "dataflow/commands/command_text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "dataflow/base/text_lines.hpp"

namespace dataflow {

namespace {

constexpr std::array<char const*, 15> without_effect{"out",   "report",      "events",       "json",       "csv",
                                                     "junit", "vcd",         "fst",          "timeline",   "jobs",
                                                     "force", "keep-events", "retry-failed", "time-limit", "shard"};

bool has_effect(CLI::Option const& option) {
    return std::none_of(without_effect.begin(), without_effect.end(),
                        [&option](char const* name) { return option.check_lname(name); });
}

std::string quoted(std::string const& word) {
    constexpr char const* plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_@%+=:,./-";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    return "'" + with_replaced(word, {{'\'', "'\\''"}}) + "'";
}

void add(CLI::Option const& option, std::string& text) {
    if (option.get_items_expected_max() == 0) {  // a flag
        text += " " + option.get_name();
        return;
    }
    for (std::string const& value : option.results())
        text += (option.get_positional() ? " " : " " + option.get_name() + " ") + quoted(value);
}

}  // namespace

std::string command_text(CLI::App const& command) {
    std::string text = command.get_name();
    for (bool const operands : {true, false})
        for (CLI::Option const* const option : command.get_options())
            if (option->get_positional() == operands && option->count() > 0 && has_effect(*option))
                add(*option, text);
    return text;
}

}  // namespace dataflow

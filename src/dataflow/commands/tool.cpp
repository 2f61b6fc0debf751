#include "dataflow/commands/tool.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <new>
#include <string_view>
#include <vector>

#include "dataflow/base/held_signals.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/keep_memory.hpp"
#include "dataflow/base/made_by.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/commands/command_text.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/say.hpp"

namespace dataflow {

namespace {

/// SystemC prints its banner before sc_main runs; a tool's output starts with its own.
bool const banner_is_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1) == 0;

class Tool {
  public:
    Tool(ToolText const& text, std::vector<Subcommand> const& commands) : text_(text), commands_(commands) {}

    int run(int argc, char** argv) const {
        try {
            std::vector<char*> words(argv, argv + argc);
            ask_for_help(words);
            int const code = parse(static_cast<int>(words.size()), words.data())();
            finish_saying();
            return code;
        } catch (InputError const& error) {
            return one_line_error(error.what());
        } catch (std::filesystem::filesystem_error const& error) {
            return one_line_error(fmt::format("{}: {}, expected a path that can be used", error.path1().string(),
                                              error.code().message()));
        } catch (processes::Interrupted const&) {  // and whoever called handles the signal
            return one_line_error("interrupted");
        } catch (std::bad_alloc const&) {
            return one_line_error("not enough memory, expected a smaller run or a host with more");
        } catch (std::exception const& error) {
            return one_line_error(std::string("unexpected error: ") + error.what());
        }
    }

  private:
    /// "help" and "help COMMAND" are as "--help" and "COMMAND --help".
    static void ask_for_help(std::vector<char*>& words) {
        static char option[] = "--help";
        if (words.size() < 2 || std::string_view(words[1]) != "help")
            return;
        words.erase(words.begin() + 1);
        words.push_back(option);
    }

    std::function<int()> parse(int argc, char** argv) const {
        if (argc > 1)
            require_known(argv[1]);
        CLI::App app{text_.description, text_.name};
        app.set_version_flag("--version", version());
        app.require_subcommand(1);
        std::vector<std::function<int()>> actions;
        for (Subcommand const& command : commands_) {
            CLI::App& declared = *app.add_subcommand(command.name, command.help);
            actions.push_back(command.declare(declared));
            refuse_values_of_flags(declared);
        }
        try {
            app.parse(argc, argv);
        } catch (CLI::ParseError const& error) {
            int const code = error.get_exit_code();
            if (code != 0)
                refuse(app, error);
            app.exit(error);  // --help, --version
            return [] { return exit_done; };
        }
        std::size_t chosen = 0;
        while (!app.got_subcommand(commands_[chosen].name))
            ++chosen;
        CLI::App const& command = *app.get_subcommand(commands_[chosen].name);
        require_words(command, text_.name + " " + command.get_name());
        made_by().command = command_text(command);
        return actions[chosen];
    }

    /// Of the command, and of commands in it, as of `sweep merge`.
    static void refuse_values_of_flags(CLI::App& command) {
        for (CLI::Option* const option : command.get_options())
            if (option->get_items_expected_max() == 0)
                option->disable_flag_override();
        for (CLI::App* const inner : command.get_subcommands({}))
            refuse_values_of_flags(*inner);
    }

    /// An unknown option comes before whatever the parser complains of, which may be due to it: the value behind it has
    /// been taken for another word. The help named is that of the innermost command at fault, as of `sweep merge`.
    [[noreturn]] void refuse(CLI::App const& app, CLI::ParseError const& error) const {
        CLI::App const* command = &app;
        std::string name = text_.name;
        std::string text = unknown_option(app);
        while (text.empty() && !command->get_subcommands().empty()) {
            command = command->get_subcommands().front();
            name += " " + command->get_name();
            text = unknown_option(*command);
        }
        throw InputError(fmt::format("{} (see {} --help)", text.empty() ? text_of(error) : text, name));
    }

    /// What is wrong with the first word that looks like an option and is none of the command's; empty if none does.
    static std::string unknown_option(CLI::App const& command) {
        std::vector<std::string> const words = command.remaining();
        auto const found = std::find_if(words.begin(), words.end(),
                                        [](std::string const& word) { return word.size() > 1 && word.front() == '-'; });
        if (found == words.end() || *found == "--")  // no options behind that
            return {};
        std::string const given = found->substr(0, found->find('='));
        std::vector<std::string> known;
        for (CLI::Option const* const option : command.get_options())
            for (std::string const& name : option->get_lnames())
                known.push_back("--" + name);
        return given + ": unknown option" + did_you_mean_option(given, known);
    }

    /// A word cut short, as -v or --crit, stands for the one option that begins so.
    static std::string did_you_mean_option(std::string const& given, std::vector<std::string> const& known) {
        std::string const start = given.size() == 2 ? "-" + given : given;
        std::vector<std::string> begun;
        std::copy_if(known.begin(), known.end(), std::back_inserter(begun),
                     [&start](std::string const& option) { return option.compare(0, start.size(), start) == 0; });
        return begun.size() == 1 ? ", did you mean " + begun.front() + "?" : did_you_mean(given, known);
    }

    /// As the parser says it, but for a flag that is given a value, and for a value that is no integer: other
    /// numbers are checked by number_in() before.
    static std::string text_of(CLI::ParseError const& error) {
        std::string text = error.what();
        std::size_t const end = text.find(" was given a disallowed flag override");
        if (end != std::string::npos)
            return (end == 1 ? "-" : "--") + text.substr(0, end) + ": has a value, expected it without one";
        std::string const no_integer = "Could not convert: ";
        std::size_t const equals = text.find(" = ");
        if (text.compare(0, no_integer.size(), no_integer) != 0 || equals == std::string::npos)
            return text;
        return fmt::format("{}: expected an integer, found {}",
                           text.substr(no_integer.size(), equals - no_integer.size()), text.substr(equals + 3));
    }

    /// The parser would only say that some subcommand is missing.
    void require_known(std::string const& given) const {
        std::vector<std::string> known;
        for (Subcommand const& command : commands_)
            known.push_back(command.name);
        if (given.empty() || given.front() == '-' || std::find(known.begin(), known.end(), given) != known.end())
            return;
        throw InputError(fmt::format("unknown command {}, expected one of {}{}", given, fmt::join(known, ", "),
                                     did_you_mean(given, known)));
    }

    /// An empty word is a variable of a script that was never set: not what its user left out.
    static void require_words(CLI::App const& command, std::string const& name) {
        for (CLI::Option const* const option : command.get_options())
            for (std::string const& word : option->results())
                if (word.empty())
                    throw InputError(fmt::format("{}: is empty, expected {} (see {} --help)", option->get_name(),
                                                 option->get_type_name(), name));
        for (CLI::App const* const inner : command.get_subcommands())
            require_words(*inner, name + " " + inner->get_name());
    }

    std::string version() const {
        if (text_.commit.empty())
            return text_.version;
        return fmt::format("{} (commit {} of {})", text_.version, text_.commit, text_.commit_date);
    }

    int one_line_error(std::string const& text) const {
        warn("{}: {}\n", text_.name, message_line(text));
        return exit_bad_input;
    }

    ToolText const& text_;
    std::vector<Subcommand> const& commands_;
};

}  // namespace

int run_tool(ToolText const& text, std::vector<Subcommand> const& commands, int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond its limit of size is an error like a full disk
    keep_freed_memory();
    program_name() = text.name;
    made_by() = {text.version, text.commit, text.commit_date, {}};
    return Tool(text, commands).run(argc, argv);
}

}  // namespace dataflow

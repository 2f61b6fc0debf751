#include "tb/terminal.hpp"

#include <cstdlib>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>

namespace faster {

namespace {

std::string environment(char const* name) {
    char const* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// COLORTERM is the custom of terminals with 24-bit colours; "-direct" that of terminfo. Others would show rubbish.
bool says_24_bit_colours() {
    std::string const colours = environment("COLORTERM");
    return colours == "truecolor" || colours == "24bit" || environment("TERM").find("-direct") != std::string::npos;
}

}  // namespace

Terminal terminal_on_stdout() {
    Terminal terminal;
    if (isatty(STDOUT_FILENO) == 0)
        return terminal;
    terminal.takes_colours = environment("NO_COLOR").empty() && says_24_bit_colours();
    winsize size{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0) {
        terminal.columns = size.ws_col;
        terminal.lines = size.ws_row;
    }
    return terminal;
}

}  // namespace faster

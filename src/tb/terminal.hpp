#pragma once

namespace faster {

/// What stdout can show.
struct Terminal {
    bool takes_colours = false;  ///< a terminal that says it takes 24-bit colours, and NO_COLOR is not set
    int columns = 80;
    int lines = 40;
};

/// Asks the system and the environment (COLORTERM, NO_COLOR, TERM).
Terminal terminal_on_stdout();

}  // namespace faster

#pragma once
#include <cstdint>
#include <vector>

#include "kernel/base/random.hpp"
#include "kernel/config/key_value.hpp"
#include "kernel/sweeps/sweep.hpp"

namespace faster::sweeps {

/// How a random value of a key is drawn.
struct Draw {
    enum class Kind { choice, integer, number, log_integer, log_number };
    Kind kind = Kind::choice;
    std::vector<Cell> choices;  ///< of a choice, all equally likely
    double low = 0;             ///< of the others: from here
    double high = 0;            ///< to here; an integer may be `high`
};

/// One value, as an integer or number. Takes one output of `random`. Of the logarithmic kinds every octave is equally
/// likely. Not for a choice.
KeyValue drawn_value(Draw const& draw, Random& random);

/// One of the choices.
Cell const& drawn_choice(Draw const& draw, Random& random);

}  // namespace faster::sweeps

#include "kernel/sweeps/draw.hpp"

#include <algorithm>
#include <cmath>

namespace faster::sweeps {

namespace {

std::int64_t whole(double value, Draw const& draw) {
    return static_cast<std::int64_t>(std::clamp(std::floor(value), draw.low, draw.high));
}

double between_logarithms(double low, double high, double share) {
    return std::exp(std::log(low) + share * (std::log(high) - std::log(low)));
}

}  // namespace

KeyValue drawn_value(Draw const& draw, Random& random) {
    double const share = random.uniform();
    switch (draw.kind) {
        case Draw::Kind::integer:
            return whole(draw.low + share * (draw.high + 1 - draw.low), draw);
        case Draw::Kind::log_integer:
            return whole(between_logarithms(draw.low, draw.high + 1, share), draw);
        case Draw::Kind::log_number:
            return std::clamp(between_logarithms(draw.low, draw.high, share), draw.low, draw.high);
        default:
            return draw.low + share * (draw.high - draw.low);
    }
}

Cell const& drawn_choice(Draw const& draw, Random& random) {
    auto const count = static_cast<double>(draw.choices.size());
    return draw.choices[static_cast<std::size_t>(random.uniform() * count)];
}

}  // namespace faster::sweeps

#include "dataflow/tools/sweeps/random_dimension.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/random.hpp"
#include "dataflow/run/config/key_value.hpp"

namespace dataflow::sweeps {

namespace {

/// How a random value of a key is drawn.
struct Draw {
    enum class Kind { choice, integer, number, log_integer, log_number };
    Kind kind = Kind::choice;
    std::vector<Cell> choices;  ///< of a choice, all equally likely
    double low = 0;             ///< of the others: from here
    double high = 0;            ///< to here; an integer may be `high`
};

std::int64_t whole(double value, Draw const& draw) {
    return static_cast<std::int64_t>(std::clamp(std::floor(value), draw.low, draw.high));
}

double between_logarithms(double low, double high, double share) {
    return std::exp(std::log(low) + share * (std::log(high) - std::log(low)));
}

/// One value, as an integer or number. Takes one output of `random`. Of the logarithmic kinds every octave is equally
/// likely. Not for a choice.
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

/// One of the choices.
Cell const& drawn_choice(Draw const& draw, Random& random) {
    auto const count = static_cast<double>(draw.choices.size());
    return draw.choices[static_cast<std::size_t>(random.uniform() * count)];
}

using KeyDraw = std::pair<Key const*, Draw>;

Draw::Kind kind_of(Key const& key, bool is_log) {
    if (key.kind == KeyKind::integer)
        return is_log ? Draw::Kind::log_integer : Draw::Kind::integer;
    return is_log ? Draw::Kind::log_number : Draw::Kind::number;
}

std::optional<Draw> draw_between(Key const& key, MapEntry const& way, ValueLists const& lists) {
    bool const is_log = way.name == "log_range";
    auto const limits = lists.bounds(key, way);
    if (!limits)
        return std::nullopt;
    if (is_log && !(limits->first > 0)) {
        lists.fault(way.line, key.name(), "log_range from 0 or below, expected a range above 0");
        return std::nullopt;
    }
    Draw draw;
    draw.kind = kind_of(key, is_log);
    draw.low = limits->first;
    draw.high = limits->second;
    return draw;
}

std::optional<Draw> read_draw(Key const& key, MapEntry const& entry, ValueLists const& lists) {
    static std::vector<std::string> const names{"range", "log_range", "choices"};
    auto const ways = entry.value.IsMap() ? read_entries(entry.value, entry.name + '.', lists.cells().faults())
                                          : std::vector<MapEntry>{};
    if (ways.size() != 1 || std::find(names.begin(), names.end(), ways.front().name) == names.end()) {
        bool const is_one = ways.size() == 1;
        lists.fault(entry.line, entry.name,
                    fmt::format("{}, expected one of {{range: [2, 64]}}, {{log_range: [2, 64]}}, {{choices: [...]}}{}",
                                is_one ? shortened(ways.front().name) : shown(entry.value),
                                is_one ? did_you_mean(ways.front().name, names) : ""));
        return std::nullopt;
    }
    if (ways.front().name != "choices")
        return draw_between(key, ways.front(), lists);
    Draw draw;
    draw.choices = lists.cells_of(key, ways.front(), true);
    return draw.choices.empty() ? std::nullopt : std::optional(draw);
}

std::vector<Cell> drawn_row(std::vector<KeyDraw> const& draws, Random& random) {
    std::vector<Cell> row;
    row.reserve(draws.size());
    for (auto const& [key, draw] : draws)
        row.push_back(draw.kind == Draw::Kind::choice ? drawn_choice(draw, random)
                                                      : KeyCells::cell(*key, drawn_value(draw, random)));
    return row;
}

}  // namespace

Dimension random_dimension(MapEntry const& random, std::int64_t count, std::uint64_t seed, ValueLists const& lists) {
    Dimension dimension;
    std::vector<KeyDraw> draws;
    for (MapEntry const& entry : read_entries(random.value, "random.", lists.cells().faults()))
        if (Key const* const key = lists.cells().key(entry.name, entry.line))
            if (auto const draw = read_draw(*key, entry, lists)) {
                draws.emplace_back(key, *draw);
                dimension.columns.push_back(key->name());
            }
    Random generator(seed);
    for (std::int64_t i = 0; i < count && !draws.empty(); ++i)
        dimension.rows.push_back(drawn_row(draws, generator));
    return dimension;
}

}  // namespace dataflow::sweeps

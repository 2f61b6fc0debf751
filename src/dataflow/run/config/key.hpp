#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "dataflow/run/config/key_value.hpp"
#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// What may be written as the value of a key.
enum class KeyKind {
    boolean,
    integer,
    number,
    choice,  ///< one of Key::choices
    path,    ///< a file or folder; empty for none
    object,  ///< the bare name of something that the design knows, or the path of a file
    vector,  ///< three numbers
    items,   ///< a list of maps, see Key::fields
};

struct IntegerRange {
    std::int64_t min = 0;
    std::int64_t max = std::numeric_limits<std::int64_t>::max();
};

struct NumberRange {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool excludes_min = false;
};

/// What people read about a key.
struct KeyText {
    std::string name;     ///< dotted, e.g. accelerator.window
    std::string unit;     ///< empty: none
    std::string meaning;  ///< one sentence
    std::string source;   ///< where the key or its default comes from
};

/// What a KeyKind::object accepts, in the design's words.
struct ObjectWords {
    std::string expectation = "a name or the path of a file";
    std::string range = "name or path";
};

/// A field of the items of a KeyKind::items.
struct ItemField {
    KeyText text;                       ///< the name is the last part only
    KeyKind kind = KeyKind::vector;     ///< object or vector
    bool required = false;              ///< every item has to give it
    ItemPart otherwise;                 ///< its value where it is not given
    ObjectWords words = ObjectWords{};  ///< KeyKind::object
};

/// One configuration key: all there is to know about it, once. Loader, resolved dump and documentation read this. The
/// default is what `read` finds in a default-constructed RunConfig.
struct Key {
    KeyText text;
    KeyKind kind = KeyKind::boolean;
    IntegerRange integers;             ///< KeyKind::integer
    NumberRange numbers;               ///< KeyKind::number
    std::vector<std::string> choices;  ///< KeyKind::choice
    ObjectWords words;                 ///< KeyKind::object
    std::vector<ItemField> fields;     ///< KeyKind::items, in the order in which they are written
    /// May be changed without running the function again, unless Design::decides_function() says otherwise.
    bool decides_time = false;
    /// Whether a run looks at it. Others are of another command: what is written of a run leaves them out.
    bool of_runs = true;
    /// A whole number of a time or size that the sensitivities change by one.
    bool is_step = false;
    /// A choice about the whole machine, of which the sensitivities try every other value.
    bool is_alternative = false;
    /// False for what only says how a run is made, or what making it may take: no figure depends on it, so it belongs
    /// neither to what identifies a run nor to what is recorded of it.
    bool decides_figures = true;
    std::function<KeyValue(RunConfig const&)> read;
    std::function<void(RunConfig&, KeyValue const&)> write;

    std::string const& name() const { return text.name; }
};

/// A field as a key of its own, as far as what it accepts goes.
Key key_of(ItemField const& field);

/// Whether the value of a KeyKind::object is the name of something that the design knows. A path has a slash or a
/// point.
bool is_bare_name(std::string const& object);

/// What the key accepts, to follow "expected": "an integer from 1 to 4096".
std::string expectation(Key const& key);

/// What the key accepts, as a table has it: "1..4096".
std::string range_text(Key const& key);

bool accepts(IntegerRange const& range, std::int64_t value);
bool accepts(NumberRange const& range, double value);

}  // namespace dataflow

#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "faster/run_config.hpp"
#include "kernel/config/key_value.hpp"

namespace faster {

/// What may be written as the value of a key.
enum class KeyKind {
    boolean,
    integer,
    number,
    choice,   ///< one of Key::choices
    path,     ///< a file or folder; empty for none
    object,   ///< a built-in object class or the path of a mesh file
    vector,   ///< three numbers
    objects,  ///< a list of maps, see scene_object_keys()
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

/// One configuration key: all there is to know about it, once. Loader, resolved dump and documentation read this. The
/// default is what `read` finds in a default-constructed RunConfig.
struct Key {
    KeyText text;
    KeyKind kind = KeyKind::boolean;
    IntegerRange integers;             ///< KeyKind::integer
    NumberRange numbers;               ///< KeyKind::number
    std::vector<std::string> choices;  ///< KeyKind::choice
    std::function<KeyValue(RunConfig const&)> read;
    std::function<void(RunConfig&, KeyValue const&)> write;

    std::string const& name() const { return text.name; }
};

/// What the key accepts, to follow "expected": "an integer from 1 to 4096".
std::string expectation(Key const& key);

/// The same for a table: "1..4096".
std::string range_text(Key const& key);

bool accepts(IntegerRange const& range, std::int64_t value);
bool accepts(NumberRange const& range, double value);

}  // namespace faster

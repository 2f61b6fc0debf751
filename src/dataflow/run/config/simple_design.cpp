#include "dataflow/run/config/simple_design.hpp"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/design_check.hpp"
#include "dataflow/run/config/external_memory_keys.hpp"
#include "dataflow/run/config/machine_keys.hpp"
#include "dataflow/run/figures/table_columns.hpp"

namespace dataflow {
namespace {

void require_key_name(std::string const& key) {
    std::vector<std::string> const words = split_at_points(key);
    if (words.size() < 2 || !std::all_of(words.begin(), words.end(), is_word))
        throw InputError("a number of the design has the key \"" + key +
                         "\", expected words and dots between them, such as workload.rows");
}

/// A key within another would be a section and a value.
void require_separate_keys(std::vector<DesignNumber> const& numbers) {
    for (DesignNumber const& outer : numbers)
        for (DesignNumber const& inner : numbers)
            if (inner.key.rfind(outer.key + '.', 0) == 0)
                throw InputError("numbers of the design have the keys " + outer.key + " and " + inner.key +
                                 ", expected none that begins with another and a dot");
}

/// Columns of samples.csv, as those before them.
void require_columns(std::vector<ColumnFacts> const& counters) {
    std::vector<std::string> names;
    for (auto const& column : sample_columns)
        names.emplace_back(column.name);
    for (ColumnFacts const& counter : counters) {
        if (!is_word(counter.name))
            throw InputError("a result of the design has the name \"" + std::string(counter.name) +
                             "\", expected a word, such as sum, which tables can have");
        if (std::count(names.begin(), names.end(), counter.name) > 0)
            throw InputError("a result of the design has the name " + std::string(counter.name) +
                             ", which another column of its table has, expected another");
        names.emplace_back(counter.name);
    }
}

Key number_key(std::string const& design, DesignNumber const& number) {
    require_key_name(number.key);
    if (number.range.min < 0)
        throw InputError("number " + number.key + ": its range begins with " + std::to_string(number.range.min) +
                         ", expected 0 or more");
    auto const value = static_cast<std::int64_t>(number.otherwise);
    if (value < number.range.min || value > number.range.max)
        throw InputError("number " + number.key + ": its default is " + std::to_string(value) +
                         ", expected one of its range, " + std::to_string(number.range.min) + ".." +
                         std::to_string(number.range.max));
    return KeyMaker<SimpleConfig>::integer_key(
        {number.key, "", number.meaning, design},
        number.range, [name = number.key](auto& config) -> auto& { return config.numbers.of(name); });
}

/// It stands in texts and names of files.
void require_one_word(std::string const& name) {
    auto const is_blank = [](unsigned char letter) { return std::isspace(letter) != 0; };
    if (name.empty() || std::any_of(name.begin(), name.end(), is_blank))
        throw InputError("the name of the design is \"" + name + "\", expected one word");
}

bool uses_memory(CoreDescription const& core) {
    return std::any_of(core.modules.begin(), core.modules.end(),
                       [](ModuleDescription const& module) { return !module.streams.empty(); });
}

/// A module tells what it takes when it comes to it: too late for whoever works ahead.
void require_plain_stream(ModuleDescription const& module, StreamDescription const& stream) {
    std::string const what =
        "module " + module.name + (stream.writes ? " stores " : " fetches ") + stream.name + " by a port to the memory";
    if (&stream != module.streams.data())
        throw InputError(what + ", and has another one for " + module.streams.front().name +
                         ", expected one, and a module for each other");
    if (stream.prefetch != timing::Prefetch::none || stream.is_header)
        throw InputError(what + " that works ahead, expected a design with keys of its own (external_memory_keys())");
    if (!stream.loop.empty())
        keyed_loop(module, stream.loop);
}

void require_plain_streams(CoreDescription const& core) {
    std::vector<std::string> names;
    for (ModuleDescription const& module : core.modules)
        for (StreamDescription const& stream : module.streams) {
            require_plain_stream(module, stream);
            if (std::count(names.begin(), names.end(), stream.name) > 0)
                throw InputError("in the design two ports to the memory have the name " + stream.name +
                                 ", expected another name for one of them");
            names.push_back(stream.name);
        }
}

/// Nobody works ahead.
Keys memory_keys() {
    Keys keys = external_memory_keys();
    keys.erase(std::remove_if(keys.begin(), keys.end(),
                              [](Key const& key) { return key.name() == "accelerator.memory.prefetch"; }),
               keys.end());
    return keys;
}

}  // namespace

std::uint64_t Numbers::operator[](std::string const& key) const {
    auto const found = values_.find(key);
    if (found != values_.end())
        return found->second;
    std::vector<std::string> keys;
    for (auto const& [known, value] : values_)
        keys.push_back(known);
    throw InputError("number(\"" + key + "\"): the design has no such number, expected one of its keys" +
                     did_you_mean(key, keys));
}

SimpleDesign::SimpleDesign(SimpleFacts facts) : facts_(std::move(facts)) {
    facts_.numbers.insert(facts_.numbers.begin(),
                          {"workload.samples", 1, "How often the work is done.", {1, 1'000'000}});
}

SimpleConfig SimpleDesign::defaults() const {
    SimpleConfig config;
    for (DesignNumber const& number : facts_.numbers)
        config.numbers.of(number.key) = number.otherwise;
    return config;
}

std::unique_ptr<DesignConfig> SimpleDesign::default_config() const {
    return std::make_unique<SimpleConfig>(defaults());
}

std::vector<Key> SimpleDesign::keys() const { return keys_of(describe(defaults().numbers)); }

/// Keys of one section have to stand together.
std::vector<Key> SimpleDesign::keys_of(CoreDescription core) const {
    require_one_word(facts_.name);
    require_columns(facts_.counters);
    require_separate_keys(facts_.numbers);
    Keys keys;
    auto const add_numbers = [&](bool of_accelerator) {
        for (DesignNumber const& number : facts_.numbers)
            if ((number.key.rfind("accelerator.", 0) == 0) == of_accelerator)
                keys.push_back(number_key(facts_.name, number));
    };
    add_numbers(false);
    keys.push_back(cores_key("accelerator.cores", "Cores that share the samples.", facts_.name));
    keys.push_back(clock_key(facts_.name));
    keys.push_back(fifo_rules_key());
    add_numbers(true);
    check_design(core);
    require_plain_streams(core);
    if (uses_memory(core))
        for (Key& key : memory_keys())
            keys.push_back(std::move(key));
    core.has_calls = true;
    keys.push_back(calls_key());
    for (Key& key : machine_keys(core))
        keys.push_back(std::move(key));
    return keys;
}

/// Those that have not their defaults.
std::string SimpleDesign::changed_numbers(Numbers const& numbers) const {
    std::string changed;
    for (DesignNumber const& number : facts_.numbers)
        if (numbers.of(number.key) != number.otherwise)
            changed += (changed.empty() ? "" : ", ") + number.key + " = " + std::to_string(numbers.of(number.key));
    return changed;
}

void SimpleDesign::require_keys(Numbers const& numbers) const {
    std::string const changed = changed_numbers(numbers);
    if (changed.empty())
        return;
    Keys const known = keys();
    for (Key const& key : keys_of(describe(numbers)))
        if (std::none_of(known.begin(), known.end(), [&](Key const& one) { return one.name() == key.name(); }))
            throw InputError("with " + changed + " the design has a part with the key " + key.name() +
                             ", which it does not have with the defaults of its numbers, expected describe() to have "
                             "all parts always, with only_if() where a number decides whether one is there");
}

std::vector<std::string> SimpleDesign::complaints(LoadedConfig const& loaded) const {
    return uses_memory(describe(numbers_of(loaded.config))) ? external_memory_complaints(loaded)
                                                            : std::vector<std::string>();
}

std::string SimpleDesign::why_not_retimable(std::string const& key) const {
    return key == calls_key().name() ? "decides which operations there are, not when" : Design::why_not_retimable(key);
}

}  // namespace dataflow

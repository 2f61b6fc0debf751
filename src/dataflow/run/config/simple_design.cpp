#include "dataflow/run/config/simple_design.hpp"

#include <utility>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/design_check.hpp"
#include "dataflow/run/config/machine_keys.hpp"

namespace dataflow {
namespace {

Key number_key(std::string const& design, DesignNumber const& number) {
    return KeyMaker<SimpleConfig>::integer_key(
        {number.key, "", number.meaning, design},
        number.range, [name = number.key](auto& config) -> auto& { return config.numbers.of(name); });
}

/// There are no keys of an external memory, and so there is none.
void require_no_streams(CoreDescription const& core) {
    for (ModuleDescription const& module : core.modules)
        for (StreamDescription const& stream : module.streams)
            throw InputError(
                "module " + module.name + (stream.writes ? " stores " : " fetches ") + stream.name +
                " by a port to the external memory, which a simple design does not have, expected a design " +
                "with keys of its own (external_memory_keys())");
}

}  // namespace

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

/// Keys of one section have to stand together.
std::vector<Key> SimpleDesign::keys() const {
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
    CoreDescription core = describe(defaults().numbers);
    check_design(core);
    require_no_streams(core);
    core.has_calls = true;
    keys.push_back(calls_key());
    for (Key& key : machine_keys(core))
        keys.push_back(std::move(key));
    return keys;
}

std::string SimpleDesign::why_not_retimable(std::string const& key) const {
    return key == calls_key().name() ? "decides which operations there are, not when" : Design::why_not_retimable(key);
}

}  // namespace dataflow

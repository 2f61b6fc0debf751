#include "dataflow/run/config/simple_design.hpp"

#include <utility>

#include "dataflow/run/config/machine_keys.hpp"

namespace dataflow {
namespace {

Key number_key(std::string const& design, DesignNumber const& number) {
    return KeyMaker<SimpleConfig>::integer_key(
        {number.key, "", number.meaning, design},
        number.range, [name = number.key](auto& config) -> auto& { return config.numbers.of(name); });
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
    for (Key& key : machine_keys(describe(defaults().numbers)))
        keys.push_back(std::move(key));
    return keys;
}

}  // namespace dataflow

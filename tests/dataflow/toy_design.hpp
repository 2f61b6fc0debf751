#pragma once
#include "dataflow/run/config/design.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::test {

/// What the keys of the toy say.
struct ToyConfig final : DesignConfig {
    ToyConfig() { settings.cores = 2; }

    MachineSettings settings;
    std::uint64_t rows = 8;  ///< toy.rows
    bool answers = true;     ///< toy.answers
    bool polls = false;      ///< toy.polls

    std::unique_ptr<DesignConfig> clone() const override { return std::make_unique<ToyConfig>(*this); }
    MachineSettings& machine() override { return settings; }
    MachineSettings const& machine() const override { return settings; }
};

/// The design of the kernel's own tests: three processes in a row. A source sends numbers by the FIFO `number`. A
/// worker takes 5 cycles to get ready for each and looks it up in a table, in a loop of one iteration per row, which
/// counts how often it was looked at; it reads the rows above and below too. It sends what it finds to a sink by the
/// FIFO `answer`, unless nobody wants answers: then there is neither. If it polls, it also looks for the next number
/// while it looks one up.
CoreDescription describe_toy(ToyConfig const& config);

}  // namespace faster::test

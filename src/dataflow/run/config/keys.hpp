#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/run/config/idle_keys.hpp"
#include "dataflow/run/config/key.hpp"

namespace dataflow {

using Keys = std::vector<Key>;

/// Every configuration key, once, in the order of the documentation. Keys of one section stand together.
Keys const& all_keys();

/// A number of a design's own may not be named as a key that is there anyway. Errors: InputError
void require_named_once(Keys const& keys);

/// Those that decide how long a run takes and nothing else, and that change by steps of one: depths and latencies of
/// FIFOs, initiation intervals and depths of loops, ports of block RAMs. All are integers. Without those that mean
/// nothing in `config`.
Keys timing_keys(RunConfig const& config);

/// Those that may be changed without running the function again: timing_keys(), the kinds of FIFOs, partitions of block
/// RAMs, how many cores share the samples, the clock; and stages of memories, unless decides_waits().
Keys retiming_keys();

/// Those that the figures of a run depend on: Key::of_runs and Key::decides_figures.
Keys figure_keys();

/// Whether a key may be changed without running the function again: one of retiming_keys(), unless `config` makes it
/// decide about more.
bool is_retimable(Key const& key, RunConfig const& config);
/// Whether it is a key of what a loop does to a block RAM where iterations wait for writes (hazards: interlock): which
/// ones do so is part of what was recorded.
bool decides_waits(Key const& key, RunConfig const& config);

/// All of which that is true, without those that mean nothing in `config`.
Keys retimable_keys(RunConfig const& config);

/// The key of that dotted name, or null.
Key const* find_key(std::string_view name);

/// Whether the key of that name is one of figure_keys(); true of others, which older runs may have had.
bool decides_figures(std::string_view name);

/// True if keys stand below `name`: "accelerator.fifos", but not "accelerator.window".
bool is_section(std::string_view name);

/// What may follow in a section, e.g. "clock_mhz", "fifos", ... for "accelerator". The root is "".
std::vector<std::string> names_in_section(std::string_view section);

/// What is wrong with a dotted name that is neither key nor section, and what it was probably meant to be.
std::string unknown_key_problem(std::string_view name);

/// The first key of the design that is a whole number, for messages that show how a key is written.
std::string const& example_key();

}  // namespace dataflow

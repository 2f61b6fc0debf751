#pragma once
// Everything that a program for a simple design includes; docs/tutorial.md writes one.
#include "channels/clocked_fifo.hpp"
#include "channels/port_binding.hpp"
#include "channels/sample_module.hpp"
#include "channels/simple_simulation.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/tool.hpp"
#include "dataflow/core/machine/core_of.hpp"

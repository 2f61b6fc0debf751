#pragma once
// Everything that a program for a simple design includes; docs/tutorial.md writes one.
#include "channels/clocked_fifo.hpp"
#include "channels/port_binding.hpp"
#include "channels/sample_module.hpp"
#include "channels/simple_simulation.hpp"
#include "kernel/machine/core_of.hpp"
#include "tool/standard_commands.hpp"
#include "tool/tool.hpp"

#pragma once

namespace dataflow {

/// Tells the address sanitizer, in a program that has it, that this thread is on its own stack again. SystemC tells it
/// of the stacks of processes, but not of the one to which sc_start() returns; an exception thrown there would leave
/// the sanitizer's marks of frames that are gone, and later ones would run into them.
void back_on_own_stack();

}  // namespace dataflow

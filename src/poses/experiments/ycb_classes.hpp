#pragma once
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::experiments {

/// The classes in the order of YCB-Video, whose place, from 1, is the obj_id that its dataset gives them.
std::vector<std::string> const& ycb_classes();

/// 0 for a name that is none of them.
int obj_id_of(std::string const& name);

/// What turns the built-in mesh of a class into itself: half turns of a box, any turn of a can or bowl. Colours do not
/// count, as a depth image has none.
void add_symmetries(bop::ObjectModel& model, std::string const& name);

}  // namespace faster::experiments

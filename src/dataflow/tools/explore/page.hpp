#pragma once

namespace dataflow::explore {

/// Joined by the build from the files of page/.
extern char const* const explore_page;

}  // namespace dataflow::explore

#include "dataflow/tools/recording/recorded_window.hpp"

#include <algorithm>

namespace dataflow::recording {

Cycles RecordedWindow::from() const {
    Cycles from = ~Cycles{0};
    for (RecordedCore const& core : cores)
        from = std::min(from, core.from);
    return cores.empty() ? 0 : from;
}

Cycles RecordedWindow::to() const {
    Cycles to = 0;
    for (RecordedCore const& core : cores)
        to = std::max(to, core.to);
    return to;
}

}  // namespace dataflow::recording

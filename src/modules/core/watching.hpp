#pragma once
#include "dataflow/base/write_distances.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Calls with who wants to know what iterations access, or with one who does not; mostly nobody does.
template <class Call> decltype(auto) with_watcher(WriteDistances* watcher, Call call) {
    if (watcher != nullptr)
        return call(*watcher);
    NoWriteDistances nobody;
    return call(nobody);
}

}  // namespace faster

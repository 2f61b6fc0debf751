#pragma once
#include "dataflow/base/write_distances.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// Calls `call` with the watcher of what iterations access, or with NoWriteDistances if there is none, as in most runs.
template <class Call> decltype(auto) with_watcher(WriteDistances* watcher, Call call) {
    if (watcher != nullptr)
        return call(*watcher);
    NoWriteDistances nobody;
    return call(nobody);
}

}  // namespace faster

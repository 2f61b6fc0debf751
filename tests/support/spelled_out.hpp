#pragma once
#include <vector>

#include "dataflow/core/time/operation_log.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// What a log says, an iteration an entry; iterations that access nothing are as good as gaps.
inline std::vector<timing::Operation::Code> spelled_out(timing::OperationLog log) {
    using timing::Operation;
    std::vector<Operation::Code> codes;
    while (!log.exhausted()) {
        log.split_iteration();
        Operation const operation = log.front();
        bool const is_silent = operation.kind() == Operation::Kind::iterate && operation.ports() == 0;
        codes.insert(codes.end(), is_silent ? operation.count() : 1,
                     is_silent ? Operation(Operation::Kind::iterate, 0, 0, 1).code() : operation.code());
        log.consume();
    }
    return codes;
}

}  // namespace faster::testing

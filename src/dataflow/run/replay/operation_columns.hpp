#pragma once
#include <string>
#include <vector>

#include "dataflow/run/replay/bytes.hpp"
#include "dataflow/run/replay/operation_check.hpp"

namespace dataflow::replay {

/// Writes the operations of one process after the other as a table of the shapes that occur, and columns: which shape;
/// then what operations of that shape have, in their order.
void encode_operations(std::vector<timing::Operation> const& operations, std::string& bytes);

/// Reads them. False if the check does not accept them all.
bool decode_operations(ByteReader& bytes, OperationCheck& check, std::vector<timing::Operation>& operations);

}  // namespace dataflow::replay

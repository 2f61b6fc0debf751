#pragma once
#include <string>
#include <vector>

#include "kernel/replay/bytes.hpp"
#include "kernel/replay/operation_check.hpp"

namespace faster::replay {

/// Writes the operations of one process after the other as a table of the shapes that occur, and columns: which shape;
/// then what operations of that shape have, in their order.
void encode_operations(std::vector<timing::Operation> const& operations, std::string& bytes);

/// Reads them. False if the check does not accept them all.
bool decode_operations(ByteReader& bytes, OperationCheck& check, std::vector<timing::Operation>& operations);

}  // namespace faster::replay

#pragma once
#include <string>

namespace dataflow {

/// Tables of all configuration keys, one per section. configs/README.md holds this text between its marker comments.
std::string keys_as_markdown();

}  // namespace dataflow

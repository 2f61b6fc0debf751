#pragma once
#include <filesystem>

#include "dataflow/base/files/folder_kind.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::files {

/// A stimulus trace is a folder that fully determines what the machine computes (docs/formats.md#stimulus-trace):
/// `trace.yaml`, the samples and their triangles after the vertex transform as CSV, the observed depth and edges as
/// PNG.
///
/// read_trace throws InputError for anything wrong with it, naming file and line (or pixel) and what was expected.
Stimulus read_trace(std::filesystem::path const& folder);

/// What write_trace() writes.
FolderKind const& trace_kind();

/// Writes the trace completely or not at all; an older trace of that name is replaced. Throws InputError if the folder
/// cannot be written or holds something else. The stimulus must have explicit triangles (not posed, see Stimulus), and
/// images of its size: anything else is a mistake of the caller (std::logic_error).
void write_trace(Stimulus const& stimulus, std::filesystem::path const& folder);

}  // namespace faster::files

#pragma once
#include <filesystem>
#include <string>

#include "faster/data/fixed_point.hpp"

namespace faster::files {

/// The content of `trace.yaml`: the shape of a stimulus trace and the names of its other files
/// (docs/formats.md#stimulus-trace).
struct TraceManifest {
    static constexpr char const* format = "faster-trace";
    static constexpr int version = 1;
    static constexpr char const* file_name = "trace.yaml";

    int width = 0;   ///< image [px], 1..4096
    int height = 0;  ///< image [px], 1..4096
    int window = 0;  ///< side of the window [px], 1..4096
    FractionBits fraction;
    struct Files {
        std::string samples = "samples.csv";
        std::string triangles = "triangles.csv";
        std::string depth = "depth.png";
        std::string edges = "edges.png";
    } files;
};

/// Throws InputError (file:line) for a missing, repeated or unknown key, a value of the wrong kind or out of range,
/// and fraction bits that contradict each other.
TraceManifest read_manifest(std::filesystem::path const& path);

/// The text of trace.yaml.
std::string manifest_text(TraceManifest const& manifest);

}  // namespace faster::files

#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/uninitialized.hpp"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace dataflow::io {

struct FreeZstdContext {
    void operator()(ZSTD_CCtx_s* context) const;
    void operator()(ZSTD_DCtx_s* context) const;
};

/// Makes zstd frames (RFC 8878), each with a checksum of its content at its end. Equal contents give equal frames.
class ZstdPress {
  public:
    ZstdPress();

    std::string frame(std::string_view content);

  private:
    std::unique_ptr<ZSTD_CCtx_s, FreeZstdContext> context_;  ///< kept from frame to frame: it takes a megabyte to make
};

/// Reads zstd frames, one after the other.
class ZstdReader {
  public:
    ZstdReader();

    /// The content of a frame, until the next one is read; it must not be longer than `most_bytes`. Nothing if the
    /// frame is damaged.
    std::optional<std::string_view> content(std::string_view frame, std::size_t most_bytes);

  private:
    std::unique_ptr<ZSTD_DCtx_s, FreeZstdContext> context_;  ///< kept from frame to frame, as is the room for contents
    std::vector<char, Uninitialized<char>> content_;
};

/// The content of a single frame; otherwise as ZstdReader.
std::optional<std::string> content_of_zstd_frame(std::string_view frame, std::size_t most_bytes);

/// The checksum that ends a frame: of its content, 32 bits of XXH64. 0 of what is too short for a frame.
std::uint32_t checksum_of_zstd_frame(std::string_view frame);

}  // namespace dataflow::io

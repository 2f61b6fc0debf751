#include "dataflow/base/files/zstd_frame.hpp"

#include <stdexcept>
#include <zstd.h>

#include "dataflow/base/little_endian.hpp"

namespace dataflow::io {

namespace {
constexpr int level = 1;  // higher ones hardly make smaller frames, and take longer
}

void FreeZstdContext::operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
void FreeZstdContext::operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }

ZstdPress::ZstdPress() : context_(ZSTD_createCCtx()) {
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, level);
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_checksumFlag, 1);
}

std::string ZstdPress::frame(std::string_view content) {
    std::string frame(ZSTD_compressBound(content.size()) + sizeof(std::uint32_t), '\0');
    std::size_t const size = ZSTD_compress2(context_.get(), frame.data(), frame.size(), content.data(), content.size());
    if (ZSTD_isError(size) != 0)
        throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
    frame.resize(size);
    return frame;
}

ZstdReader::ZstdReader() : context_(ZSTD_createDCtx()) {}

std::optional<std::string_view> ZstdReader::content(std::string_view frame, std::size_t most_bytes) {
    auto const content_bytes = ZSTD_getFrameContentSize(frame.data(), frame.size());  // huge if it is not known
    if (content_bytes > most_bytes || ZSTD_findFrameCompressedSize(frame.data(), frame.size()) != frame.size())
        return std::nullopt;
    content_.resize(content_bytes);
    std::size_t const size =
        ZSTD_decompressDCtx(context_.get(), content_.data(), content_.size(), frame.data(), frame.size());
    if (ZSTD_isError(size) != 0 || size != content_bytes)
        return std::nullopt;
    return std::string_view(content_.data(), content_.size());
}

std::optional<std::string> content_of_zstd_frame(std::string_view frame, std::size_t most_bytes) {
    ZstdReader reader;
    std::optional<std::string_view> const content = reader.content(frame, most_bytes);
    return content ? std::optional<std::string>(*content) : std::nullopt;
}

std::uint32_t checksum_of_zstd_frame(std::string_view frame) {
    constexpr std::size_t width = sizeof(std::uint32_t);
    if (frame.size() < width)
        return 0;
    return static_cast<std::uint32_t>(little_endian_at<width>(frame.data() + frame.size() - width));
}

}  // namespace dataflow::io

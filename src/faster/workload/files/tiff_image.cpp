#include "faster/workload/files/tiff_image.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>
#include <tiffio.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"

namespace faster::files {
namespace {

constexpr std::uint32_t longest_side = 1U << 14;  // as of PNG files

/// The bytes of a file, as libtiff asks for them.
struct TiffBytes {
    std::string_view bytes;
    std::uint64_t place = 0;

    static TiffBytes& of(thandle_t handle) { return *static_cast<TiffBytes*>(handle); }

    static tmsize_t read(thandle_t handle, void* to, tmsize_t count) {
        TiffBytes& file = of(handle);
        std::uint64_t const left = file.place < file.bytes.size() ? file.bytes.size() - file.place : 0;
        auto const taken = static_cast<std::size_t>(std::min<std::uint64_t>(left, static_cast<std::uint64_t>(count)));
        std::memcpy(to, file.bytes.data() + (left == 0 ? 0 : file.place), taken);
        file.place += taken;
        return static_cast<tmsize_t>(taken);
    }
    static tmsize_t write(thandle_t /*handle*/, void* /*from*/, tmsize_t /*count*/) { return 0; }
    static toff_t seek(thandle_t handle, toff_t offset, int from) {
        TiffBytes& file = of(handle);
        std::uint64_t const base = from == SEEK_SET ? 0 : from == SEEK_CUR ? file.place : file.bytes.size();
        return file.place = base + offset;
    }
    static int close(thandle_t /*handle*/) { return 0; }
    static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
};

int say_no_more(TIFF* /*tiff*/, void* /*data*/, char const* /*module*/, char const* /*format*/, va_list /*arguments*/) {
    return 1;  // not to be printed
}

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using Tiff = std::unique_ptr<TIFF, CloseTiff>;

/// Null if it is no TIFF file. Nothing is printed, and nothing larger than a few times the file is allocated.
Tiff open_tiff(TiffBytes& bytes) {
    constexpr tmsize_t least_room = 1 << 20;
    std::unique_ptr<TIFFOpenOptions, CloseTiff> const options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), least_room + 4 * static_cast<tmsize_t>(bytes.bytes.size()));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_no_more, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_no_more, nullptr);
    return Tiff(TIFFClientOpenExt("image", "rm", &bytes, TiffBytes::read, TiffBytes::write, TiffBytes::seek,
                                  TiffBytes::close, TiffBytes::size, nullptr, nullptr, options.get()));
}

template <class Value> Value tag(TIFF* tiff, std::uint32_t name) {
    Value value{};
    TIFFGetFieldDefaulted(tiff, name, &value);
    return value;
}

bool is_packed_plainly(std::uint16_t compression) {
    constexpr std::array<std::uint16_t, 5> known{COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
                                                 COMPRESSION_DEFLATE, COMPRESSION_PACKBITS};
    return std::find(known.begin(), known.end(), compression) != known.end();
}

/// What keeps an image from being read, for a message; nothing if it can be.
std::string problem_of(TIFF* tiff) {
    auto const width = tag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH),
               height = tag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH);
    auto const bits = tag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE),
               channels = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL),
               format = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT);
    if (width == 0 || height == 0 || width > longest_side || height > longest_side)
        return fmt::format("has {} x {} pixels (1 to {} a side are read)", width, height, longest_side);
    if (channels != 1 || bits != 16 || format != SAMPLEFORMAT_UINT)
        return fmt::format("has {} x {}-bit {}", channels, bits,
                           format == SAMPLEFORMAT_IEEEFP ? "floating point numbers"
                           : format == SAMPLEFORMAT_INT  ? "signed numbers"
                                                         : "numbers");
    if (tag<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC) != PHOTOMETRIC_MINISBLACK)
        return "is not grey with 0 for black";
    if (TIFFIsTiled(tiff) != 0)
        return "is made of tiles";
    if (!is_packed_plainly(tag<std::uint16_t>(tiff, TIFFTAG_COMPRESSION)))
        return "is packed in another way than LZW, Deflate or PackBits";
    return tag<std::uint16_t>(tiff, TIFFTAG_ORIENTATION) == ORIENTATION_TOPLEFT ? "" : "is turned";
}

/// Whether a strip's bytes are in the file, and as many as its pixels take if they are plain. libtiff takes the file's
/// first bytes for those of a strip without a place.
bool is_there(TIFF* tiff, std::uint32_t strip, std::uint64_t pixel_bytes) {
    std::uint64_t const offset = TIFFGetStrileOffset(tiff, strip), bytes = TIFFGetStrileByteCount(tiff, strip),
                        size = TiffBytes::size(TIFFClientdata(tiff));
    bool const is_plain = tag<std::uint16_t>(tiff, TIFFTAG_COMPRESSION) == COMPRESSION_NONE;
    return offset > 0 && offset < size && bytes > 0 && bytes <= size - offset && (!is_plain || bytes >= pixel_bytes);
}

bool read_strips(TIFF* tiff, Image<std::uint16_t>& image) {
    auto const rows = static_cast<int>(std::min<std::uint32_t>(tag<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP),
                                                               static_cast<std::uint32_t>(image.height())));
    for (int row = 0; rows > 0 && row < image.height(); row += rows) {
        tmsize_t const bytes = 2 * tmsize_t{image.width()} * std::min(rows, image.height() - row);
        std::uint32_t const strip = TIFFComputeStrip(tiff, static_cast<std::uint32_t>(row), 0);
        if (!is_there(tiff, strip, static_cast<std::uint64_t>(bytes)) ||
            TIFFReadEncodedStrip(tiff, strip, image.row(row), bytes) != bytes)
            return false;
    }
    return rows > 0;
}

[[noreturn]] void refuse_tiff(std::filesystem::path const& path, std::string const& found) {
    throw InputError(fmt::format("{}: {}, expected 16-bit greyscale TIFF in strips", path.string(), found));
}

bool is_tiff(std::string_view file) {
    constexpr std::array<std::string_view, 4> marks{std::string_view("II*\0", 4), std::string_view("MM\0*", 4),
                                                    std::string_view("II+\0", 4), std::string_view("MM\0+", 4)};
    return std::find(marks.begin(), marks.end(), file.substr(0, 4)) != marks.end();
}

Image<std::uint16_t> decode_tiff16(std::filesystem::path const& path, std::string_view file) {
    TiffBytes bytes{file};
    Tiff const tiff = open_tiff(bytes);
    if (tiff == nullptr)
        refuse_tiff(path, "is no TIFF file, or damaged");
    if (std::string const problem = problem_of(tiff.get()); !problem.empty())
        refuse_tiff(path, problem);
    Image<std::uint16_t> image(static_cast<int>(tag<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH)),
                               static_cast<int>(tag<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH)));
    if (!read_strips(tiff.get(), image))
        refuse_tiff(path, "is cut off or damaged");
    return image;
}

}  // namespace

Image<std::uint16_t> read_tiff16(std::filesystem::path const& path) { return decode_tiff16(path, read_file(path)); }

Image<std::uint16_t> read_depth_counts(std::filesystem::path const& path) {
    std::string const file = read_file(path);
    if (is_tiff(file))
        return decode_tiff16(path, file);
    if (file.compare(0, 4, "\x89PNG") != 0)
        io::fail(path, "is neither a PNG nor a TIFF file, expected one of 16-bit greyscale");
    return decode_png16(path, file);
}

}  // namespace faster::files

#include "faster/workload/files/png_codec.hpp"

#include <algorithm>
#include <csetjmp>
#include <new>
#include <png.h>
#include <stdexcept>
#include <utility>
#include <zlib.h>

namespace faster::files {

namespace {

constexpr std::string_view signature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t length_bytes = 4, type_bytes = 4, checksum_bytes = 4, header_bytes = 13;

std::uint32_t byte_at(std::string_view bytes, std::size_t position) {
    return static_cast<unsigned char>(bytes[position]);
}

std::uint32_t big_endian_at(std::string_view bytes, std::size_t position) {
    return byte_at(bytes, position) << 24 | byte_at(bytes, position + 1) << 16 | byte_at(bytes, position + 2) << 8 |
           byte_at(bytes, position + 3);
}

std::uint32_t crc_of(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<Bytef const*>(bytes.data()), bytes.size()));
}

PngHeader parse_header(std::string_view data) {
    PngHeader header;
    header.width = big_endian_at(data, 0);
    header.height = big_endian_at(data, 4);
    header.bit_depth = static_cast<int>(byte_at(data, 8));
    header.colour_type = static_cast<int>(byte_at(data, 9));
    return header;
}

/// libpng comes back here from deep inside, past everything: its callers below own nothing that has a destructor.
[[noreturn]] void give_up(png_structp png, png_const_charp /*what*/) { png_longjmp(png, 1); }
void say_nothing(png_structp /*png*/, png_const_charp /*what*/) {}

bool is_little_endian() {
    std::uint16_t const one = 1;
    return *reinterpret_cast<unsigned char const*>(&one) == 1;
}

class PngReader {
  public:
    explicit PngReader(std::string_view file)
        : left_(file), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, say_nothing)) {
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ != nullptr)
            png_set_read_fn(png_, this, take);
    }
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngReader(PngReader const&) = delete;
    PngReader& operator=(PngReader const&) = delete;

    bool read(png_bytepp rows, std::size_t row_bytes, int height) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0)  // NOLINT(cert-err52-cpp): libpng is C
            return false;
        png_read_info(png_, info_);
        if (is_little_endian())
            png_set_swap(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        if (png_get_rowbytes(png_, info_) != row_bytes ||
            png_get_image_height(png_, info_) != static_cast<png_uint_32>(height))
            return false;
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

  private:
    static void take(png_structp png, png_bytep bytes, std::size_t count) {
        auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
        if (count > reader.left_.size())
            png_error(png, "cut off");
        std::copy_n(reader.left_.data(), count, bytes);
        reader.left_.remove_prefix(count);
    }

    std::string_view left_;
    png_structp png_;
    png_infop info_ = nullptr;
};

class Writer {
  public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, give_up, say_nothing)) {
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ != nullptr)
            png_set_write_fn(png_, &file_, put, flush);
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(Writer const&) = delete;
    Writer& operator=(Writer const&) = delete;

    bool write(PngPixels const& pixels, PngEffort effort) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0)  // NOLINT(cert-err52-cpp): libpng is C
            return false;
        if (effort == PngEffort::little) {
            png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
            png_set_compression_level(png_, Z_BEST_SPEED);
            png_set_compression_strategy(png_, Z_RLE);
        } else {
            png_set_compression_level(png_, 6);
            png_set_compression_strategy(png_, Z_DEFAULT_STRATEGY);
        }
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(pixels.width), static_cast<png_uint_32>(pixels.height),
                     pixels.bits, pixels.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png_, info_);
        if (is_little_endian())
            png_set_swap(png_);
        unsigned char const* row = pixels.bytes.data();
        for (int left = pixels.height; left > 0; --left, row += pixels.row_bytes())
            png_write_row(png_, row);
        png_write_end(png_, info_);
        return true;
    }
    std::string take_file() { return std::move(file_); }

  private:
    static void put(png_structp png, png_bytep bytes, std::size_t count) {
        bool has_room = true;
        try {
            static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char const*>(bytes), count);
        } catch (std::bad_alloc const&) {
            has_room = false;  // an exception must not go through libpng
        }
        if (!has_room)
            png_error(png, "no memory");
    }
    static void flush(png_structp /*png*/) {}

    std::string file_;
    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

std::string PngHeader::pixel_type() const {
    std::string colour = "unknown colour type";
    switch (colour_type) {
        case 0:
            colour = "greyscale";
            break;
        case 2:
            colour = "RGB";
            break;
        case 3:
            colour = "palette";
            break;
        case 4:
            colour = "greyscale with alpha";
            break;
        case 6:
            colour = "RGB with alpha";
            break;
        default:
            break;
    }
    return (bit_depth == 8 ? "an " : "a ") + std::to_string(bit_depth) + "-bit " + colour;
}

PngCheck check_png(std::string_view file) {
    if (file.substr(0, signature.size()) != signature) {
        return {{}, "is not a PNG file"};
    }
    PngCheck check;
    file.remove_prefix(signature.size());
    for (bool first = true;; first = false) {
        if (file.size() < length_bytes + type_bytes + checksum_bytes ||
            big_endian_at(file, 0) > file.size() - length_bytes - type_bytes - checksum_bytes) {
            return {check.header, "is a truncated PNG file"};
        }
        std::size_t const data_bytes = big_endian_at(file, 0);
        std::string_view const type_and_data = file.substr(length_bytes, type_bytes + data_bytes);
        std::string_view const type = type_and_data.substr(0, type_bytes);
        if (crc_of(type_and_data) != big_endian_at(file, length_bytes + type_bytes + data_bytes) ||
            first != (type == "IHDR") || (first && data_bytes != header_bytes)) {
            return {check.header, "is a damaged PNG file"};
        }
        if (first) {
            check.header = parse_header(type_and_data.substr(type_bytes));
        }
        if (type == "IEND") {
            return check;
        }
        file.remove_prefix(length_bytes + type_and_data.size() + checksum_bytes);
    }
}

std::string encode_png(PngPixels const& pixels, PngEffort effort) {
    Writer writer;
    if (!writer.write(pixels, effort))
        throw std::runtime_error("libpng cannot encode an image");
    return writer.take_file();
}

bool decode_png(std::string_view file, PngPixels& pixels) {
    pixels.bytes.resize(pixels.row_bytes() * static_cast<std::size_t>(pixels.height));
    std::vector<png_bytep> rows;
    rows.reserve(static_cast<std::size_t>(pixels.height));
    for (int row = 0; row < pixels.height; ++row)
        rows.push_back(pixels.bytes.data() + static_cast<std::size_t>(row) * pixels.row_bytes());
    return PngReader(file).read(rows.data(), pixels.row_bytes(), pixels.height);
}

}  // namespace faster::files

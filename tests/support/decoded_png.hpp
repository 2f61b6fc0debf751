#pragma once
#include <catch2/catch.hpp>
#include <string>

#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_codec.hpp"

namespace faster::test {

/// What a coloured PNG file says of its pixels, once they could be decoded.
inline files::PngHeader header_of_decoded(std::string const& file) {
    files::PngCheck const check = files::check_png(file);
    CHECK(check.problem == "");
    files::PngPixels pixels{static_cast<int>(check.header.width), static_cast<int>(check.header.height), 3, 8, {}};
    CHECK(files::decode_png(file, pixels));
    return check.header;
}

}  // namespace faster::test

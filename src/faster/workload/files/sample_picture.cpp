#include "faster/workload/files/sample_picture.hpp"

#include <fmt/format.h>

namespace faster::files {

std::filesystem::path sample_picture(std::filesystem::path const& folder, std::size_t sample,
                                     std::string const& content) {
    return folder / fmt::format("sample_{:04}_{}.png", sample, content);
}

}  // namespace faster::files

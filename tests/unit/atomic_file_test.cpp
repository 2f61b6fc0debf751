#include "kernel/base/files/atomic_file.hpp"

#include <catch2/catch.hpp>

#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace atomic_file_test {

using Catch::Matchers::Contains;
using faster::io::write_file_atomically;
using faster::test::content_of;
using faster::test::entries_in;
using faster::test::input_error_text;
using faster::test::TempFolder;
namespace fs = std::filesystem;

TEST_CASE("An atomically written file replaces the older one and leaves nothing beside it", "[atomic_file]") {
    TempFolder const folder;
    write_file_atomically(folder / "file", "old");
    write_file_atomically(folder / "file", "new");
    CHECK(content_of(folder / "file") == "new");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("Writing atomically through a symbolic link keeps the link", "[atomic_file]") {
    TempFolder const folder;
    folder.write("file", "old");
    fs::create_symlink(folder / "file", folder / "link");
    write_file_atomically(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(content_of(folder / "file") == "new");
}

TEST_CASE("Places where no file can be are refused, and nothing is left there", "[atomic_file]") {
    TempFolder const folder;
    fs::create_directory(folder / "folder");
    auto const error = [](fs::path const& path) {
        return input_error_text([&path] { write_file_atomically(path, "new"); });
    };
    CHECK_THAT(error(folder / "folder"), Contains("folder: is no regular file"));
    CHECK_THAT(error(folder / "folder/"), Contains("names no file"));
    CHECK_THAT(error(""), Contains("names no file"));
    CHECK_THAT(error(folder / "missing/file"), Contains("missing/file: cannot be written"));
    CHECK(entries_in(folder.path()) == 1);
    CHECK(entries_in(folder / "folder") == 0);
}

}  // namespace atomic_file_test

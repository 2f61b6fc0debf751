#include <catch2/catch.hpp>
#include <filesystem>

#include "dataflow/base/files/csv_cells.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/yaml_document.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace bounds_of_files_test {

using Catch::Matchers::Contains;
using dataflow::io::parse_json;
using dataflow::io::read_csv_cells;
using dataflow::io::read_json_file;
using faster::load_document;
using faster::test::input_error_text;
using faster::test::TempFolder;

std::string error_of(std::string const& text) {
    TempFolder const folder;
    auto const file = folder.write("a.yaml", text);
    return input_error_text([&] { load_document(file); });
}

/// Each line has ten aliases of the line before.
std::string billion_laughs(int lines) {
    std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < lines; ++i) {
        std::string const before = "*a" + std::to_string(i - 1);
        std::string const name = "a" + std::to_string(i);
        text += name + ": &" + name + " [" + before;
        for (int k = 1; k < 10; ++k)
            text += ", " + before;
        text += "]\n";
    }
    return text;
}

TEST_CASE("Aliases count as what they stand for") {
    CHECK(error_of(billion_laughs(4)) == "(no error)");
    CHECK_THAT(error_of(billion_laughs(9)), Contains("a.yaml:6: more than 1000000 values"));
}

TEST_CASE("An alias does not stand inside of what it stands for") {
    CHECK_THAT(error_of("a: &a [1, *a]\n"), Contains("a.yaml:1: an alias inside of what it stands for"));
    CHECK(error_of("a: &a [1]\nb: *a\n") == "(no error)");
}

TEST_CASE("Maps and lists are nested 32 deep and no deeper") {
    auto const nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK(error_of(nested(32)) == "(no error)");
    CHECK_THAT(error_of(nested(33)), Contains("a.yaml:1: maps and lists more than 32 deep"));
    CHECK_THAT(error_of(std::string(1'000'000, '[')), Contains("maps and lists more than 32 deep"));
    CHECK_THAT(error_of("a: " + std::string(1'000'000, '{')), Contains("maps and lists more than 32 deep"));
}

TEST_CASE("A document of more than 4 MiB is not read") {
    CHECK_THAT(error_of("# " + std::string(5 << 20, 'x')), Contains("a.yaml: is longer than 4 MiB"));
    CHECK(input_error_text([] { load_document("/dev/zero"); }) ==
          "/dev/zero: is longer than 4 MiB, expected a configuration file");
}

TEST_CASE("Folders and loops of links are told apart from files that are missing") {
    TempFolder const folder;
    auto const error = [](std::filesystem::path const& path) { return input_error_text([&] { load_document(path); }); };
    CHECK_THAT(error(folder.path()), Contains("is a folder, expected a configuration file"));
    std::filesystem::create_symlink("b", folder / "a");
    std::filesystem::create_symlink("a", folder / "b");
    CHECK_THAT(error(folder / "a"), Contains("/a: cannot be read (Too many levels of symbolic links), expected"));
    CHECK_THAT(error(folder / "c"), Contains("/c: no such file, expected a configuration file"));
}

TEST_CASE("JSON is nested 64 deep and no deeper, whatever stands in its strings") {
    auto const nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK(parse_json(nested(64)).is_array());
    CHECK(parse_json("[\"" + std::string(1000, '[') + "\\\"[[" + "\"]").size() == 1);
    TempFolder const folder;
    for (std::string const& text : {nested(65), std::string(1'000'000, '['), "{\"a\": " + nested(64) + "}"}) {
        auto const file = folder.write("a.json", text);
        CHECK_THAT(input_error_text([&] { read_json_file(file, "none"); }),
                   Contains("a.json:1: has arrays and objects more than 64 deep"));
    }
}

TEST_CASE("A table has ten thousand columns and no more") {
    TempFolder const folder;
    auto const error = [&](std::size_t commas) {
        auto const file = folder.write("a.csv", "a" + std::string(commas, ',') + "\n");
        return input_error_text([&] { read_csv_cells(file, {"a"}, [](std::size_t, std::string_view const*) {}); });
    };
    CHECK(error(9'999) == "(no error)");
    CHECK_THAT(error(10'000), Contains("a.csv:1: 10001 columns, expected at most 10000"));
}

}  // namespace bounds_of_files_test

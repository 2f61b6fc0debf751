// docs/tutorial.md shows the program as it is, and prints what its commands print.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace tutorial_test {

using namespace faster::test;
namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

fs::path const example = fs::path(FASTER_SOURCE_DIR) / "examples" / "pipeline";

fs::path const functions_example = fs::path(FASTER_SOURCE_DIR) / "examples" / "hls_pipeline";

/// The fenced blocks of a language in the tutorial.
std::vector<Lines> blocks_of(std::string const& language) {
    std::vector<Lines> blocks;
    bool is_inside = false;
    for (std::string const& line : lines_of(content_of(fs::path(FASTER_SOURCE_DIR) / "docs" / "tutorial.md"))) {
        if (line.rfind("```", 0) == 0) {
            is_inside = line == "```" + language;
            if (is_inside)
                blocks.emplace_back();
        } else if (is_inside) {
            blocks.back().push_back(line);
        }
    }
    return blocks;
}

std::vector<std::string> words_of(std::string const& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

bool has_line(Lines const& lines, std::string const& line) {
    return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST_CASE("The tutorial shows the program as it is", "[examples]") {
    Lines program = lines_of(content_of(example / "pipeline.cpp"));
    for (char const* const file : {"functions.cpp", "hls_pipeline.cpp"}) {
        Lines const more = lines_of(content_of(functions_example / file));
        program.insert(program.end(), more.begin(), more.end());
    }
    Lines const settings = lines_of(content_of(example / "pipeline.yaml"));
    for (Lines const& block : blocks_of("cpp"))
        for (std::string const& line : block)
            CHECK((has_line(program, line) ? std::string() : line).empty());
    for (Lines const& block : blocks_of("yaml"))
        for (std::string const& line : block)
            CHECK((has_line(settings, line) ? std::string() : line).empty());
}

/// What follows a command is in its output, in the page's order; "..." stands for what is left out.
TEST_CASE("The tutorial's commands print what it says", "[examples]") {
    TempFolder const folder;
    for (fs::path const& from : {example, functions_example})
        for (auto const& entry : fs::directory_iterator(from))
            if (entry.path().extension() == ".yaml" || entry.path().extension() == ".xml")
                fs::copy(entry.path(), folder / entry.path().filename().string());
    std::map<std::string, std::string> const binaries{{"pipeline", PIPELINE_BINARY},
                                                      {"hls_pipeline", HLS_PIPELINE_BINARY}};
    std::vector<Lines> const blocks = blocks_of("console");
    CHECK(blocks.size() == 11);
    for (Lines const& block : blocks) {
        std::vector<std::string> words = words_of(block.at(0));
        INFO(block.at(0));
        REQUIRE(binaries.count(words.at(1)) == 1);
        std::string const binary = binaries.at(words.at(1));
        words.erase(words.begin(), words.begin() + 2);
        CommandResult const result = run_command(binary, words, folder.path());
        Lines const printed = lines_of(result.out + result.err);
        auto at = printed.begin();
        for (auto line = block.begin() + 1; line != block.end(); ++line) {
            if (*line == "...")
                continue;
            INFO(*line);
            at = std::find(at, printed.end(), *line);
            REQUIRE(at != printed.end());
            ++at;
        }
    }
}

}  // namespace tutorial_test

// What fuzzing has left behind: inputs that reach different code, and those that once did harm.
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>

#include "fuzz/targets.hpp"
#include "support/temp_folder.hpp"

namespace fuzz_corpus_test {

namespace fs = std::filesystem;
using faster::fuzz::Target;
using faster::fuzz::targets;

TEST_CASE("Every input of the kept corpora is read or refused, soon") {
    std::size_t inputs = 0;
    for (Target const& target : targets()) {
        fs::path const folder = fs::path(FASTER_SOURCE_DIR "/fuzz/corpus") / target.name;
        CAPTURE(target.name);
        REQUIRE(fs::is_directory(folder));
        for (auto const& entry : fs::directory_iterator(folder)) {
            CAPTURE(entry.path().filename().string());
            auto const start = std::chrono::steady_clock::now();
            CHECK_NOTHROW(faster::fuzz::feed(target, faster::test::content_of(entry.path())));
            CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
            ++inputs;
        }
    }
    CHECK(inputs >= targets().size());
}

TEST_CASE("Every corpus belongs to a target") {
    for (auto const& entry : fs::directory_iterator(FASTER_SOURCE_DIR "/fuzz/corpus")) {
        CAPTURE(entry.path().string());
        CHECK(faster::fuzz::find_target(entry.path().filename().string()) != nullptr);
    }
}

}  // namespace fuzz_corpus_test

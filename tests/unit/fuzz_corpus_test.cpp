// What fuzzing has left behind: inputs that reach different code, and those that once did harm; and what becomes of
// them by mutation.
//   FASTER_SEED          of the mutation
//   FASTER_FUZZ_SECONDS  for all targets together (6)
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <sys/resource.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "fuzz/mutator.hpp"
#include "fuzz/targets.hpp"
#include "support/temp_folder.hpp"

namespace fuzz_corpus_test {

namespace fs = std::filesystem;
using faster::fuzz::Target;
using faster::fuzz::targets;
using faster::test::content_of;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

std::vector<fs::path> corpus_of(Target const& target) {
    fs::path const folder = fs::path(FASTER_SOURCE_DIR "/fuzz/corpus") / target.name;
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        files.assign(fs::directory_iterator(folder), fs::directory_iterator());
    std::sort(files.begin(), files.end());  // so that a seed gives the same on every host
    return files;
}

double number_from(char const* variable, double otherwise) {
    char const* const text = std::getenv(variable);
    return text == nullptr ? otherwise : std::stod(text);
}

/// Whether it was read or refused within 10 s.
bool is_harmless(Target const& target, std::string const& input) {
    auto const start = Clock::now();
    std::string unexpected;
    try {
        faster::fuzz::feed(target, input);
    } catch (std::exception const& error) {
        unexpected = error.what();
    }
    Seconds const time = Clock::now() - start;
    CHECK(unexpected == "");
    CHECK(time.count() < 10);
    return unexpected.empty() && time.count() < 10;
}

/// For the corpus, once what it found is corrected.
void keep(Target const& target, std::string const& input) {
    fs::path const file = fs::temp_directory_path() / (std::string("fuzz-found-") + target.name);
    std::ofstream(file, std::ios::binary) << input;
    std::cout << target.name << ": see " << file << std::endl;
}

long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

TEST_CASE("Every input of the kept corpora is read or refused, soon") {
    for (Target const& target : targets()) {
        CAPTURE(target.name);
        REQUIRE_FALSE(corpus_of(target).empty());
        for (fs::path const& file : corpus_of(target)) {
            CAPTURE(file.filename().string());
            is_harmless(target, content_of(file));
        }
    }
}

/// Blind mutation for so long, from a seed that is printed.
TEST_CASE("What mutation makes of the kept inputs is read or refused, soon and in little memory") {
    auto const seed = static_cast<std::uint64_t>(number_from("FASTER_SEED", std::random_device()()));
    Seconds const each(number_from("FASTER_FUZZ_SECONDS", 6) / double(targets().size()));
    std::cout << "seed " << seed << std::endl;
    for (Target const& target : targets()) {
        std::vector<std::string> inputs;
        for (fs::path const& file : corpus_of(target))
            inputs.push_back(content_of(file));
        faster::fuzz::Mutator mutator(inputs, seed);
        auto const end = Clock::now() + each;
        std::size_t tried = 0;
        for (bool is_fine = true; is_fine && Clock::now() < end; ++tried) {
            CAPTURE(seed, target.name, tried);
            std::string const input = mutator.next();
            is_fine = is_harmless(target, input);
            if (!is_fine)
                keep(target, input);
        }
        CAPTURE(target.name);
        CHECK(tried > 0);
        CHECK(peak_megabytes() < 2048);
        std::cout << target.name << ": " << tried << " inputs" << std::endl;
    }
}

TEST_CASE("Every corpus belongs to a target") {
    for (auto const& entry : fs::directory_iterator(FASTER_SOURCE_DIR "/fuzz/corpus")) {
        CAPTURE(entry.path().string());
        CHECK(faster::fuzz::find_target(entry.path().filename().string()) != nullptr);
    }
}

}  // namespace fuzz_corpus_test

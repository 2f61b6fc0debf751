// One program for all targets: faster_fuzz --target=NAME [CORPUS...] [libFuzzer's options].
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/targets.hpp"

namespace {

faster::fuzz::Target const* target = nullptr;

int list_targets() {
    for (faster::fuzz::Target const& each : faster::fuzz::targets())
        std::printf("%s\n", each.name);
    return EXIT_SUCCESS;
}

}  // namespace

/// libsystemc has a main(), which would call it. The fuzzer has another.
extern "C" int sc_main(int, char**) { return EXIT_FAILURE; }

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    std::string const option = "--target=";
    for (int i = 1; i < *argc; ++i) {
        std::string const word = (*argv)[i];
        if (word == "--list")
            std::exit(list_targets());
        if (word.rfind(option, 0) == 0)
            target = faster::fuzz::find_target(word.substr(option.size()));
    }
    if (target == nullptr) {
        std::fprintf(stderr, "faster_fuzz: expected --target=NAME, one of those that --list prints\n");
        std::exit(EXIT_FAILURE);
    }
    return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    faster::fuzz::feed(*target, {reinterpret_cast<char const*>(data), size});
    return 0;
}

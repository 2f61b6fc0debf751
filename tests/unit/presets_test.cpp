#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace presets_test {

using namespace faster;
namespace fs = std::filesystem;

LoadedConfig loaded(std::string const& text, std::vector<std::string> const& overrides = {}) {
    test::TempFolder const folder;
    folder.write("test.yaml", text);
    return load_config(folder / "test.yaml", overrides);
}

/// All keys but the one that names the preset.
std::vector<std::string> values_of(RunConfig const& config) {
    std::vector<std::string> values;
    for (Key const& key : all_keys())
        if (key.name() != "accelerator.architecture")
            values.push_back(key.name() + " = " + json_text(key.read(config)));
    return values;
}

TEST_CASE("Every file of configs/architectures is a preset that the key names", "[config][presets]") {
    std::vector<std::string> const names = preset_names();
    CHECK(names.front() == "faster");
    std::size_t files = 0;
    for (auto const& entry : fs::directory_iterator(fs::path(FASTER_SOURCE_DIR) / "configs" / "architectures")) {
        std::string const name = entry.path().stem().string();
        CAPTURE(name);
        RunConfig const by_name = loaded("accelerator: {architecture: " + name + "}").config;
        CHECK(values_of(by_name) == values_of(load_config(entry.path()).config));
        CHECK(accelerator_of(by_name).architecture == name);
        CHECK(values_of(load_preset(name).config) == values_of(by_name));
        ++files;
    }
    CHECK(files == names.size());
}

TEST_CASE("A preset says something about the accelerator, and nothing else", "[config][presets]") {
    for (Preset const& preset : design().presets()) {
        CAPTURE(preset.name);
        LoadedConfig const config = load_preset(preset.name);
        CHECK(config.origins.all().size() > 1);
        for (auto const& [key, origin] : config.origins.all())
            CHECK(key.rfind("accelerator.", 0) == 0);
    }
}

TEST_CASE("A preset lies below file and command line, whichever names it", "[config][presets]") {
    std::string const own = "accelerator: {inlier_unit: {clearing: loop}, architecture: clear_on_read_out}";
    for (LoadedConfig const& config :
         {loaded(own), loaded(own, {"accelerator.architecture=clear_on_read_out"}),
          loaded("accelerator: {inlier_unit: {clearing: loop}}", {"accelerator.architecture=clear_on_read_out"})}) {
        CHECK(accelerator_of(config.config).inlier_unit.clearing == MapClearing::loop);
        CHECK(accelerator_of(config.config).edge_map.clearing == MapClearing::on_read_out);
        KeyOrigin const origin = config.origins.of("accelerator.edge_map.clearing");
        CHECK(origin.source == KeySource::preset);
        CHECK(origin.place.rfind("configs/architectures/clear_on_read_out.yaml:", 0) == 0);
    }
    LoadedConfig const replaced = loaded(own, {"accelerator.architecture=bounded"});
    CHECK(accelerator_of(replaced.config).edge_map.clearing == MapClearing::loop);
    CHECK(accelerator_of(replaced.config).edge_map.algorithm == EdgeMapAlgorithm::bounded);
}

TEST_CASE("An unknown architecture is refused, with the nearest name", "[config][presets]") {
    try {
        loaded("accelerator: {architecture: bonded}");
        FAIL("no error");
    } catch (InputError const& error) {
        CHECK_THAT(error.what(), Catch::Contains("accelerator.architecture") && Catch::Contains("bounded"));
    }
}

}  // namespace presets_test

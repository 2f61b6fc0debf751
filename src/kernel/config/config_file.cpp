#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "kernel/base/files/yaml_document.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/design.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/value_reader.hpp"

namespace faster {
namespace {

class FileReader {
  public:
    FileReader(std::filesystem::path const& path, KeySource source, LoadedConfig& loaded)
        : file_(path.string()), folder_(path.parent_path()), source_(source), loaded_(loaded) {}

    std::vector<std::string> read(YAML::Node const& root) {
        if (!root.IsNull() && !root.IsMap()) {
            return {fmt::format("{}:1: the file is {}, expected a map with {}", file_,
                                root.IsSequence() ? "a list" : shown(root), fmt::join(names_in_section(""), ", "))};
        }
        read_section(root, "");
        std::vector<std::string> messages;
        for (KeyFault const& fault : faults_) {
            messages.push_back(fmt::format("{}:{}: {}", file_, fault.line, fault.text()));
        }
        return messages;
    }

  private:
    void read_section(YAML::Node const& map, std::string const& prefix) {
        for (MapEntry const& entry : read_entries(map, prefix, faults_)) {
            read_entry(entry, prefix + entry.name);
        }
    }

    void read_entry(MapEntry const& entry, std::string const& name) {
        if (entry.name.empty() || entry.name.find('.') != std::string::npos) {
            reject(entry, name, "not a name, expected one map inside the other for a.b.c");
        } else if (Key const* const key = find_key(name); key != nullptr) {
            read_key(entry, *key);
        } else if (!is_section(name)) {
            reject(entry, name, unknown_key_problem(name));
        } else if (entry.value.IsMap()) {
            read_section(entry.value, name + '.');
        } else if (!entry.value.IsNull()) {  // nothing below a heading, say because all is commented out: no harm
            faults_.push_back({entry.line, name, shown(entry.value),
                               fmt::format("expected a map with {}", fmt::join(names_in_section(name), ", "))});
        }
    }

    void reject(MapEntry const& entry, std::string const& name, std::string const& problem) {
        faults_.push_back({entry.line, shortened(name), std::nullopt, problem});
    }

    void read_key(MapEntry const& entry, Key const& key) {
        if (auto const value = read_value(key, entry.value, entry.line, folder_, faults_)) {
            key.write(loaded_.config, *value);
            loaded_.origins.record(key.name(), {source_, fmt::format("{}:{}", file_, entry.line)});
        }
    }

    std::string file_;
    std::filesystem::path folder_;
    KeySource source_;
    LoadedConfig& loaded_;
    KeyFaults faults_;
};

}  // namespace

std::vector<std::string> apply_file(std::filesystem::path const& path, LoadedConfig& loaded) {
    return FileReader(path, KeySource::file, loaded).read(load_document(path));
}

std::vector<std::string> apply_preset(std::string const& name, LoadedConfig& loaded) {
    auto const has_name = [&name](Preset const& preset) { return preset.name == name; };
    std::vector<Preset> const& presets = design().presets();
    auto const preset = std::find_if(presets.begin(), presets.end(), has_name);
    if (preset == presets.end())
        throw std::out_of_range("no preset " + name);
    return FileReader(place_of_preset(name), KeySource::preset, loaded).read(parse_document(preset->text));
}

}  // namespace faster

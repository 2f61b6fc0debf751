#include "dataflow/run/config/load_config.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/base/utf8.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow {

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
        return messages_of(faults_, file_);
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

/// A list is YAML; everything else is taken as it stands, so that a path needs no quotes against `#` or `: `.
YAML::Node node_of(Key const& key, std::string const& value) {
    bool const is_list = key.kind == KeyKind::vector || key.kind == KeyKind::items;
    return is_list ? parse_document(value) : YAML::Node(value);
}

std::string fault_text(KeyFault const& fault, Key const& key) {
    return fault.key == key.name() && fault.found ? fault.problem : fault.text();
}

std::vector<std::string> apply_value(Key const& key, std::string const& value, std::string const& place,
                                     LoadedConfig& loaded) {
    KeyFaults faults;
    try {
        if (auto const sound = read_value(key, node_of(key, value), 1, {}, faults)) {
            key.write(loaded.config, *sound);
            loaded.origins.record(key.name(), {KeySource::command_line, place});
        }
    } catch (YAML::Exception const& error) {
        return {fmt::format("{}: expected {} ({})", place, expectation(key), shortened(error.msg))};
    }
    std::vector<std::string> messages;
    for (KeyFault const& fault : faults) {
        messages.push_back(place + ": " + fault_text(fault, key));
    }
    return messages;
}

std::vector<std::string> apply_all(std::vector<std::filesystem::path> const& files,
                                   std::vector<std::string> const& overrides, LoadedConfig& loaded) {
    std::vector<std::string> complaints;
    auto const note = [&complaints](std::vector<std::string> const& more) {
        complaints.insert(complaints.end(), more.begin(), more.end());
    };
    for (std::filesystem::path const& file : files)
        note(apply_file(file, loaded));
    for (std::string const& setting : overrides)
        note(apply_override(setting, loaded));
    return complaints;
}

/// Files that are no configuration, by the value of their key `format`, and the command that reads them.
struct OtherFile {
    std::string format, what, reader;
};

OtherFile other_file(std::string const& format) {
    static std::vector<OtherFile> const files{{"faster-budget", "a budget file", "check"},
                                              {"faster-sweep", "a sweep file", "sweep"},
                                              {"faster-events", "an event file", "whatif"},
                                              {"faster-summary", "a summary of a run", "compare"}};
    for (OtherFile const& file : files)
        if (file.format == format)
            return file;
    return {format, "of format " + shortened(format), ""};
}

std::string wrong_file_text(std::string const& place, std::string const& format) {
    OtherFile const file = other_file(format);
    std::string const reader = file.reader.empty() ? "" : fmt::format(" ({} {} reads it)", program_name(), file.reader);
    return fmt::format("{}: the file is {}{}, expected a configuration file", place, file.what, reader);
}

/// What says it is another file of ours, unless the design has such a key.
bool is_other_file(YAML::Node const& format) {
    return format && format.IsScalar() && format.Scalar().rfind("faster-", 0) == 0 && find_key("format") == nullptr;
}

}  // namespace

bool is_event_file(std::filesystem::path const& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
        return false;
    std::string begin(event_file_mark.size(), '\0');
    std::ifstream(path, std::ios::binary).read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return begin == event_file_mark;
}

std::vector<std::string> apply_file(std::filesystem::path const& path, LoadedConfig& loaded) {
    if (is_event_file(path))
        return {wrong_file_text(path.string(), "faster-events")};
    YAML::Node const root = load_document(path, "a configuration file", names_in_section(""));
    if (YAML::Node const format = root.IsMap() ? root["format"] : YAML::Node(); is_other_file(format))
        return {wrong_file_text(fmt::format("{}:{}", path.string(), format.Mark().line + 1), format.Scalar())};
    return FileReader(path, KeySource::file, loaded).read(root);
}

std::vector<std::string> apply_preset(std::string const& name, LoadedConfig& loaded) {
    auto const has_name = [&name](Preset const& preset) { return preset.name == name; };
    std::vector<Preset> const& presets = design().presets();
    auto const preset = std::find_if(presets.begin(), presets.end(), has_name);
    if (preset == presets.end())
        throw std::out_of_range("no preset " + name);
    return FileReader(place_of_preset(name), KeySource::preset, loaded).read(parse_document(preset->text));
}

std::vector<std::string> apply_override(std::string const& setting, LoadedConfig& loaded) {
    std::string const place = "--set " + shortened(setting);
    if (first_bad_byte(setting)) {
        return {place + ": expected printable UTF-8 text"};
    }
    std::size_t const equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
        return {place + ": expected KEY=VALUE"};
    }
    std::string const name = setting.substr(0, equals);
    if (Key const* const key = find_key(name); key != nullptr) {
        return apply_value(*key, setting.substr(equals + 1), place, loaded);
    }
    if (is_section(name)) {
        return {fmt::format("{}: {} is a section, expected a key in it, one of {}", place, name,
                            fmt::join(names_in_section(name), ", "))};
    }
    return {place + ": " + unknown_key_problem(name)};
}

LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides) {
    return layered_config({path}, overrides);
}

LoadedConfig layered_config(std::vector<std::filesystem::path> const& files,
                            std::vector<std::string> const& overrides) {
    LoadedConfig loaded;
    std::vector<std::string> complaints = apply_all(files, overrides, loaded);
    if (loaded.origins.is_explicit(architecture_key_name)) {
        // A preset lies below files and command line, and any may name it: it is known only when all have been read.
        auto const architecture = std::get<std::string>(find_key(architecture_key_name)->read(loaded.config));
        loaded = {};
        throw_first(apply_preset(architecture, loaded));
        complaints = apply_all(files, overrides, loaded);
    }
    throw_first(complaints);
    design().require_keys_of_parts(loaded.config);
    throw_first(cross_check(loaded));
    return loaded;
}

LoadedConfig load_preset(std::string const& name) {
    LoadedConfig loaded;
    throw_first(apply_preset(name, loaded));
    throw_first(apply_override(std::string(architecture_key_name) + '=' + name, loaded));
    throw_first(cross_check(loaded));
    return loaded;
}

}  // namespace dataflow

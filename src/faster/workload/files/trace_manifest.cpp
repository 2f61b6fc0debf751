#include "faster/workload/files/trace_manifest.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string_view>
#include <utility>
#include <vector>
#include <yaml-cpp/yaml.h>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::files {
namespace {

/// An integer key: where its value goes and what it may be. The fraction limits keep every product of section 2 within
/// 64 bits and every quantity of its fixed width meaningful.
struct IntegerKey {
    char const* name;
    int* value;
    int min;
    int max;
};

std::vector<IntegerKey> shape_keys(TraceManifest& manifest) {
    return {{"width", &manifest.width, 1, 4096},
            {"height", &manifest.height, 1, 4096},
            {"window", &manifest.window, 1, 4096}};
}

std::vector<IntegerKey> fraction_keys(FractionBits& fraction) {
    return {{"vertex_xy", &fraction.vertex_xy, 0, 15},
            {"vertex_z", &fraction.vertex_z, 0, 16},
            {"area_reciprocal", &fraction.area_reciprocal, 0, 62},
            {"fragment_depth", &fraction.fragment_depth, 0, 30},
            {"depth_buffer", &fraction.depth_buffer, 0, 11}};
}

/// One mapping of the file: hands out its keys and knows how to complain about them.
class Section {
  public:
    Section(std::string path, std::string prefix, YAML::Node const& node, std::vector<std::string> const& known_keys)
        : path_(std::move(path)), prefix_(std::move(prefix)), node_(node) {
        if (!node_.IsMap()) {
            fail(node_.Mark(),
                 fmt::format("{} is no mapping, expected the keys {}", name(), fmt::join(known_keys, ", ")));
        }
        check_keys(known_keys);
    }

    YAML::Node at(std::string const& key) const {
        YAML::Node const value = std::as_const(node_)[key];
        if (!value) {
            fail(node_.Mark(), fmt::format("no key {}{}, expected one", prefix_, key));
        }
        return value;
    }

    std::string text(std::string const& key) const {
        YAML::Node const value = at(key);
        if (!value.IsScalar() || value.Scalar().empty()) {
            fail(value.Mark(), fmt::format("{}{} is no text, expected one value", prefix_, key));
        }
        return value.Scalar();
    }

    int integer(std::string const& key, int min, int max) const {
        YAML::Node const node = at(key);
        bool const is_quoted = node.Tag() == "!";  // and text then, as in configurations
        std::string const digits = !node.IsScalar() ? "(no single value)"
                                   : is_quoted      ? '"' + node.Scalar() + '"'
                                                    : node.Scalar();
        int value = 0;
        auto const result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        bool const is_integer = result.ec == std::errc{} && result.ptr == digits.data() + digits.size();
        if (!is_integer || value < min || value > max) {
            std::string const range = min == max ? std::to_string(min) : fmt::format("an integer in {}..{}", min, max);
            fail_value(key, digits, range);
        }
        return value;
    }

    void read(IntegerKey const& key) const { *key.value = integer(key.name, key.min, key.max); }

    [[noreturn]] void fail_value(std::string const& key, std::string const& found, std::string const& expected) const {
        fail(at(key).Mark(), fmt::format("{}{} = {}, expected {}", prefix_, key, found, expected));
    }

  private:
    std::string name() const { return prefix_.empty() ? "the file" : prefix_.substr(0, prefix_.size() - 1); }

    void check_keys(std::vector<std::string> const& known_keys) const {
        std::vector<std::string> seen;
        for (auto const& entry : node_) {
            std::string const key = entry.first.IsScalar() ? entry.first.Scalar() : std::string{"(not a name)"};
            if (std::find(known_keys.begin(), known_keys.end(), key) == known_keys.end()) {
                std::string const hint = did_you_mean(key, known_keys);
                fail(entry.first.Mark(),
                     fmt::format("unknown key {}{}{}", prefix_, key,
                                 hint.empty() ? fmt::format(", expected {}", fmt::join(known_keys, ", ")) : hint));
            }
            if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
                fail(entry.first.Mark(), fmt::format("key {}{} stands twice, expected once", prefix_, key));
            }
            seen.push_back(key);
        }
    }

    [[noreturn]] void fail(YAML::Mark const& mark, std::string const& what) const {
        throw InputError(mark.is_null() ? fmt::format("{}: {}", path_, what)
                                        : fmt::format("{}:{}: {}", path_, mark.line + 1, what));
    }

    std::string path_;
    std::string prefix_;  // "fraction." in front of the keys of that section
    YAML::Node node_;
};

void check_format(Section const& root) {
    if (root.text("format") != TraceManifest::format) {
        root.fail_value("format", root.text("format"), TraceManifest::format);
    }
    root.integer("version", TraceManifest::version, TraceManifest::version);
}

FractionBits read_fraction(std::filesystem::path const& path, YAML::Node const& node) {
    FractionBits fraction;
    std::vector<std::string> names;
    for (auto const& key : fraction_keys(fraction)) {
        names.emplace_back(key.name);
    }
    Section const section(path.string(), "fraction.", node, names);
    for (auto const& key : fraction_keys(fraction)) {
        section.read(key);
    }
    int const most_reciprocal_bits = 62 - 2 * fraction.vertex_xy;
    if (fraction.area_reciprocal > most_reciprocal_bits) {
        section.fail_value("area_reciprocal", std::to_string(fraction.area_reciprocal),
                           fmt::format("at most {} (62 - 2 * vertex_xy)", most_reciprocal_bits));
    }
    return fraction;
}

TraceManifest::Files read_files(std::filesystem::path const& path, YAML::Node const& node) {
    Section const section(path.string(), "files.", node, {"samples", "triangles", "depth", "edges"});
    return {section.text("samples"), section.text("triangles"), section.text("depth"), section.text("edges")};
}

}  // namespace

TraceManifest read_manifest(std::filesystem::path const& path) {
    Section const root(path.string(), "", load_document(path, "a readable file"),
                       {"format", "version", "width", "height", "window", "fraction", "files"});
    check_format(root);
    TraceManifest manifest;
    for (auto const& key : shape_keys(manifest)) {
        root.read(key);
    }
    manifest.fraction = read_fraction(path, root.at("fraction"));
    manifest.files = read_files(path, root.at("files"));
    return manifest;
}

std::string manifest_text(TraceManifest const& manifest) {
    TraceManifest copy = manifest;
    std::string text = fmt::format("format: {}\nversion: {}\n", TraceManifest::format, TraceManifest::version);
    for (auto const& key : shape_keys(copy)) {
        text += fmt::format("{}: {}\n", key.name, *key.value);
    }
    text += "fraction:\n";
    for (auto const& key : fraction_keys(copy.fraction)) {
        text += fmt::format("  {}: {}\n", key.name, *key.value);
    }
    text += fmt::format("files:\n  samples: {}\n  triangles: {}\n  depth: {}\n  edges: {}\n", copy.files.samples,
                        copy.files.triangles, copy.files.depth, copy.files.edges);
    return text;
}

}  // namespace faster::files

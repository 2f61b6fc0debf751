#include "poses/experiments/experiment_file.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/sweeps/key_cells.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/experiments/ycb_classes.hpp"

namespace faster::experiments {

namespace {

class ExperimentReader {
  public:
    explicit ExperimentReader(std::filesystem::path const& file) : cells_(file.parent_path(), faults_) {
        experiment_.file = file.string();
    }

    Experiment experiment() {
        read_top(experiment_.file, "an experiment", "faster-experiment",
                 {{"base", [this](MapEntry const& entry) { read_path(entry, experiment_.base); }},
                  {"set", [this](MapEntry const& entry) { experiment_.settings = settings(entry, "set."); }},
                  {"seed",
                   [this](MapEntry const& entry) {
                       experiment_.seed = static_cast<std::uint64_t>(integer(entry, 0, 1'000'000'000));
                   }},
                  {"scenes", [this](MapEntry const& entry) { read_scenes(entry); }},
                  {"methods", [this](MapEntry const& entry) { read_methods(entry); }}},
                 {"scenes", "methods"}, faults_);
        throw_first_of(faults_, experiment_.file);
        return experiment_;
    }

  private:
    void read_path(MapEntry const& entry, std::filesystem::path& path) {
        if (auto const read = cells_.path(entry.name, entry.value, entry.line))
            path = *read;
    }

    /// Here, as scenes are made for minutes before it is looked into.
    void read_folder(MapEntry const& entry, std::filesystem::path& folder) {
        read_path(entry, folder);
        if (!folder.empty() && !std::filesystem::is_directory(folder))
            reject(faults_, entry, "a folder that is there");
    }

    std::int64_t integer(MapEntry const& entry, std::int64_t least, std::int64_t most) {
        auto const value = entry.value.IsScalar() ? parse_integer(entry.value.Scalar()) : std::nullopt;
        if (value && *value >= least && *value <= most)
            return *value;
        reject(faults_, entry, fmt::format("an integer from {} to {}", least, most));
        return least;
    }

    double number(MapEntry const& entry, double least, double most) {
        auto const value = entry.value.IsScalar() ? parse_number(entry.value.Scalar()) : std::nullopt;
        if (value && *value >= least && *value <= most)
            return *value;
        reject(faults_, entry, fmt::format("a number from {} to {}", least, most));
        return least;
    }

    std::vector<std::string> settings(MapEntry const& map, std::string const& prefix) {
        std::vector<std::string> list;
        if (map.value.IsNull())
            return list;
        if (!map.value.IsMap()) {
            reject(faults_, map, "a map of dotted keys, e.g. {estimator.backend: grip}");
            return list;
        }
        for (MapEntry const& entry : read_entries(map.value, prefix, faults_))
            if (Key const* const key = cells_.key(entry.name, entry.line))
                if (auto const cell = cells_.cell(*key, entry.value, entry.line))
                    list.push_back(cell->setting);
        return list;
    }

    /// Names become names of files and folders.
    bool is_name(MapEntry const& entry) {
        bool const is_fine = !entry.name.empty() && std::all_of(entry.name.begin(), entry.name.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        });
        if (!is_fine)
            faults_.push_back({entry.line, shortened(entry.name), std::nullopt,
                               "is no name, expected letters, digits, _ and - only"});
        return is_fine;
    }

    void read_methods(MapEntry const& map) {
        if (!map.value.IsMap() || map.value.size() == 0)
            return reject(faults_, map, "a map of names to settings, e.g. {grip: {estimator.backend: grip}}");
        for (MapEntry const& entry : read_entries(map.value, "methods.", faults_))
            if (is_name(entry))
                experiment_.methods.push_back({entry.name, settings(entry, "methods." + entry.name + ".")});
    }

    void read_scenes(MapEntry const& map) {
        if (!map.value.IsMap() || map.value.size() == 0)
            return reject(faults_, map, "a map of names to settings, e.g. {dark: {objects: [banana], images: 40}}");
        for (MapEntry const& entry : read_entries(map.value, "scenes.", faults_))
            if (is_name(entry))
                read_setting(entry);
    }

    void read_setting(MapEntry const& map) {
        if (!map.value.IsMap())
            return reject(faults_, map, "a map with dataset, or with objects and images");
        std::size_t const faults_before = faults_.size();
        Setting setting;
        setting.name = map.name;
        std::vector<MapEntry> const entries = read_entries(map.value, "scenes." + map.name + ".", faults_);
        read_each(
            entries,
            {{"dataset", [&](MapEntry const& entry) { read_folder(entry, setting.dataset); }},
             {"models", [&](MapEntry const& entry) { read_folder(entry, setting.models); }},
             {"objects", [&](MapEntry const& entry) { setting.objects = objects(entry); }},
             {"images", [&](MapEntry const& entry) { setting.images = static_cast<int>(integer(entry, 1, 100'000)); }},
             {"visible", [&](MapEntry const& entry) { read_visible(entry, setting); }},
             {"boxes", [&](MapEntry const& entry) { read_boxes(entry, setting.boxes); }}},
            faults_);
        auto const of_made_scenes = std::find_if(entries.begin(), entries.end(), [](MapEntry const& entry) {
            return entry.name != "dataset" && entry.name != "boxes";
        });
        bool const is_either = setting.dataset.empty() != (setting.objects.empty() || setting.images == 0);
        if (!is_either && faults_.size() == faults_before)
            faults_.push_back({map.line, map.name, std::nullopt, "expected either dataset, or objects and images"});
        else if (!setting.dataset.empty() && of_made_scenes != entries.end() && faults_.size() == faults_before)
            faults_.push_back({map.line, map.name, std::nullopt,
                               "has " + of_made_scenes->name + ", expected none beside dataset, which brings its own"});
        experiment_.scenes.push_back(std::move(setting));
    }

    std::vector<std::string> objects(MapEntry const& list) {
        std::vector<std::string> names;
        if (!list.value.IsSequence())
            reject(faults_, list, "a list of classes, e.g. [banana, mug]");
        else
            for (YAML::Node const& item : list.value) {
                std::string const name = item.IsScalar() ? item.Scalar() : "";
                bool const is_class = obj_id_of(name) != 0;
                if (!is_class || std::count(names.begin(), names.end(), name) > 0)
                    faults_.push_back({list.line, list.name, shown(item),
                                       "expected each of the built-in classes at most once" +
                                           (is_class ? ""
                                                     : ", as others are looked for in a dataset only" +
                                                           did_you_mean(name, ycb_classes()))});
                names.push_back(name);
            }
        return names;
    }

    void read_visible(MapEntry const& list, Setting& setting) {
        auto const bound = [&](std::size_t i) { return number({list.name, list.line, list.value[i]}, 0, 1); };
        if (!list.value.IsSequence() || list.value.size() != 2)
            return reject(faults_, list, "two shares, e.g. [0.3, 0.9]");
        setting.visible = {bound(0), bound(1)};
        if (setting.visible[0] > setting.visible[1])
            reject(faults_, list, "the smaller share first");
    }

    void read_boxes(MapEntry const& map, DetectorModel& boxes) {
        if (!map.value.IsMap())
            return reject(faults_, map, "a map with shift, scale, missing, wrong");
        read_each(read_entries(map.value, map.name + ".", faults_),
                  {{"shift", [&](MapEntry const& entry) { boxes.shift = number(entry, 0, 10); }},
                   {"scale", [&](MapEntry const& entry) { boxes.scale = number(entry, 0, 3); }},
                   {"missing", [&](MapEntry const& entry) { boxes.missing = number(entry, 0, 1); }},
                   {"wrong", [&](MapEntry const& entry) { boxes.wrong = number(entry, 0, 1); }}},
                  faults_);
    }

    KeyFaults faults_;
    sweeps::KeyCells cells_;
    Experiment experiment_;
};

}  // namespace

Experiment read_experiment_file(std::filesystem::path const& path) { return ExperimentReader(path).experiment(); }

}  // namespace faster::experiments

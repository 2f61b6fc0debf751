#include "dataflow/tools/sweeps/manifest.hpp"

#include <fmt/format.h>
#include <set>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/tools/sweeps/sweep.hpp"

namespace dataflow::sweeps {

namespace {}

std::string Manifest::name(std::size_t point) const { return name_of_point(point, columns, points[point].values); }

std::string to_text(Manifest const& manifest) {
    Json points = Json::array();
    for (Manifest::Point const& point : manifest.points)
        points.push_back({{"id", point.id}, {"values", point.values}});
    Json const json{{"format", "faster-sweep-folder"}, {"version", 1},
                    {"faster_sim", manifest.version},  {"sweep", manifest.sweep},
                    {"columns", manifest.columns},     {"points", points}};
    return io::text_of(json) + "\n";
}

Manifest manifest_from_text(std::string const& text, std::string const& file) {
    try {
        Json const json = io::parse_json(text);
        if (json.at("format") != "faster-sweep-folder" || json.at("version") != 1)
            throw InputError(file + ": is of another format or version, expected faster-sweep-folder, 1");
        Manifest manifest;
        json.at("faster_sim").get_to(manifest.version);
        json.at("sweep").get_to(manifest.sweep);
        json.at("columns").get_to(manifest.columns);
        for (Json const& point : json.at("points")) {
            manifest.points.push_back({point.at("id"), point.at("values")});
            if (manifest.points.back().values.size() != manifest.columns.size())
                throw InputError(file + ": is damaged: a point has another number of values, expected one per column");
        }
        return manifest;
    } catch (Json::exception const&) {
        throw InputError(file + ": is damaged, expected what faster-sim sweep wrote");
    }
}

std::string why_no_part_of(Manifest const& smaller, Manifest const& larger) {
    if (smaller.version != larger.version)
        return fmt::format("it is of faster-sim {}, this is {}", smaller.version, larger.version);
    std::set<std::string> ids;
    for (Manifest::Point const& point : larger.points)
        ids.insert(point.id);
    std::size_t missing = 0, first = 0;
    for (std::size_t i = smaller.points.size(); i-- > 0;)
        if (ids.count(smaller.points[i].id) == 0) {
            ++missing;
            first = i;
        }
    if (missing == 0)
        return "";
    return fmt::format("{} of its {} points are not in {}, the first is {}", missing, smaller.points.size(),
                       larger.sweep, smaller.name(first));
}

}  // namespace dataflow::sweeps

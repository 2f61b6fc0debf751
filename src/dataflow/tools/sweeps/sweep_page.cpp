#include "dataflow/tools/sweeps/sweep_page.hpp"

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/sweeps/page.hpp"
#include "dataflow/tools/sweeps/results_table.hpp"

namespace dataflow::sweeps {

namespace {

Json points_json(Manifest const& manifest, Results const& results) {
    Json points = Json::array();
    for (auto const& [i, result] : points_with_results(manifest, results)) {
        Json point{{"point", i}, {"values", manifest.points[i].values}};
        point.update(to_json(result));
        points.push_back(point);
    }
    return points;
}

/// Made of the manifest as all else, not of the command, which may have been `sweep merge`.
std::string made_by(Manifest const& manifest) {
    MadeBy maker = dataflow::made_by();
    maker.version = manifest.version;
    maker.command = "sweep " + manifest.sweep;
    return report::made_by_html(hash_of(to_text(manifest)), maker);
}

}  // namespace

std::string sweep_page(Manifest const& manifest, Results const& results) {
    Json const data{{"format", "faster-sweep-page"}, {"version", 1},
                    {"sweep", manifest.sweep},       {"planned", manifest.points.size()},
                    {"columns", manifest.columns},   {"points", points_json(manifest, results)}};
    return report::filled_page(sweep_page_template, manifest.sweep, made_by(manifest), io::text_of(data));
}

}  // namespace dataflow::sweeps

#include "dataflow/tools/report/json_rows.hpp"

#include "dataflow/run/figures/module_row.hpp"

namespace dataflow::report {

namespace {

/// What is not zero, by name.
Json by_name(std::vector<NamedCycles> const& all) {
    Json object = Json::object();
    for (NamedCycles const& one : all)
        if (one.cycles > 0)
            object[one.name] = one.cycles;
    return object;
}

}  // namespace

Json json_row(ModuleRow const& module) {
    Json row{{"core", module.core}, {"module", module.module}};
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        if (module.has_class(c))
            row[cycles_column(cycle_class_names[c])] = module.cycles[c];
    row["stalls"] = by_name(module.stalls);
    row["port_conflicts"] = by_name(module.port_conflicts);
    return row;
}

}  // namespace dataflow::report

#include "dataflow/commands/recorded_events.hpp"

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/tools/report/summary.hpp"

namespace dataflow {

void write_events(io::OutputFile const& file, LoadedConfig const& loaded, replay::RecordedRun const& recorded,
                  RunStatistics run, std::string const& function) {
    run.sensitivities.clear();
    run.alternatives.clear();
    run.critical_path.reset();
    events::write_event_file(file, loaded.config, recorded, run,
                             report::summary_json(resolved_keys(loaded.config), run, report::HostTime{}), function);
}

}  // namespace dataflow

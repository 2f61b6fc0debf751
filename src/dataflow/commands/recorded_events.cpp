#include "tool/recorded_events.hpp"

#include "kernel/config/resolved_config.hpp"
#include "kernel/events/event_file.hpp"
#include "kernel/report/summary.hpp"

namespace faster {

void write_events(io::OutputFile const& file, LoadedConfig const& loaded, replay::RecordedRun const& recorded,
                  RunStatistics run, std::string const& function) {
    run.sensitivities.clear();
    run.alternatives.clear();
    run.critical_path.reset();
    events::write_event_file(file, loaded.config, recorded, run,
                             report::summary_json(resolved_keys(loaded.config), run, report::HostTime{}), function);
}

}  // namespace faster

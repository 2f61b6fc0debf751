#pragma once
#include <map>
#include <string>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/schedule/synthesis_report.hpp"

namespace dataflow::schedule {

/// Names of a report's parts, by those of the design: loops as MODULE.LOOP, FIFOs.
struct NameMap {
    std::string file;  ///< that says so
    std::map<std::string, std::string> loops;
    std::map<std::string, std::string> fifos;
};

/// Reads {loops: {MODULE.LOOP: MODULE.LOOP of the report}, fifos: {FIFO: VARIABLE of the report}}. Errors: InputError.
NameMap read_name_map(std::string const& file);

/// A key for which the report has a value.
struct ScheduledKey {
    std::string key;
    std::uint64_t assumed = 0;
    std::uint64_t scheduled = 0;
    std::string source;  ///< in the report
};

struct Schedule {
    std::vector<ScheduledKey> keys;
    std::vector<std::string> without;  ///< what has no counterpart, a line each
};

/// A loop of the design is that of the report which the map names; else one of the same name in its module, or in a
/// function that the tool made of it (MODULE_...); else the only one there, if the module has only one too. A token
/// leaves in the last stage or state of its loop: that is an assumption, which the report says nothing of.
Schedule schedule_of(Machine const& machine, SynthesisReport const& report, NameMap const& names);

}  // namespace dataflow::schedule

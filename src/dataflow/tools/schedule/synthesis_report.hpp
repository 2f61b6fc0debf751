#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dataflow::schedule {

/// What a synthesis report says of a loop. Of a range, its largest number; what the tool does not know is not there.
struct ReportLoop {
    std::string module;
    std::string name;
    std::optional<std::uint64_t> ii;                 ///< of a pipelined loop
    std::optional<std::uint64_t> depth;              ///< its stages
    std::optional<std::uint64_t> iteration_latency;  ///< of a loop that is not pipelined
    bool is_around_others = false;
    std::string place;  ///< FILE:LINE

    std::string full_name() const { return module + '.' + name; }
};

struct ReportFifo {
    std::string name;  ///< of the variable
    std::uint64_t depth = 0;
    std::string place;  ///< FILE:LINE
};

/// csynth.xml and MODULE_csynth.xml, as Vivado HLS and Vitis HLS write them.
struct SynthesisReport {
    std::string version;  ///< of the tool
    std::vector<ReportLoop> loops;
    std::vector<ReportFifo> fifos;
};

/// `name`: of the file, for messages. Errors: InputError that names file, element, what was found and expected.
SynthesisReport parse_synthesis_report(std::string const& name, std::string_view text);

/// Several reports of one design as one: what several say in equal figures is there once.
SynthesisReport read_synthesis_reports(std::vector<std::string> const& files);

}  // namespace dataflow::schedule

#pragma once
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "dataflow/base/cycles.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::sweeps {

/// What came of a point.
struct PointResult {
    static constexpr char const* journal_key = "point";  ///< see sweeps::Journal
    enum class Status {
        done,
        deadlock,  ///< a result like any other; `message` says who waits for whom
        failed,    ///< there is no result; `message` says why
    };
    Status status = Status::failed;
    std::string message;  ///< one line; empty if done
    // Of all cores, in lane-cycles; only if done.
    Cycles total_cycles = 0;  ///< not summed up: of the machine
    double milliseconds = 0;
    Cycles stall_cycles = 0;  ///< of the modules, full and empty, while they have work
    Cycles port_conflict_cycles = 0;
    Cycles fifo_full_stall_cycles = 0;
    Cycles fifo_empty_stall_cycles = 0;
    double ramb36 = 0;  ///< block RAMs of 36 Kbit of all cores; unless failed, as are the three below
    double lut = 0;
    double ff = 0;
    double dsp = 0;

    bool operator==(PointResult const& other) const;
};

/// Results by the hash of their point (PointIdentity::point).
using Results = std::map<std::string, PointResult>;

/// A figure of a result, under the name that it has in journals and results.csv.
struct ResultFigure {
    char const* name;
    char const* format;  ///< of results.csv
    std::variant<Cycles PointResult::*, double PointResult::*> member;
    bool of_a_run = true;  ///< not known of a deadlock
};
inline constexpr std::array result_figures{
    ResultFigure{"total_cycles", "{}", &PointResult::total_cycles},
    ResultFigure{"milliseconds", "{}", &PointResult::milliseconds},
    ResultFigure{"stall_cycles", "{}", &PointResult::stall_cycles},
    ResultFigure{"port_conflict_cycles", "{}", &PointResult::port_conflict_cycles},
    ResultFigure{"fifo_full_stall_cycles", "{}", &PointResult::fifo_full_stall_cycles},
    ResultFigure{"fifo_empty_stall_cycles", "{}", &PointResult::fifo_empty_stall_cycles},
    ResultFigure{"ramb36", "{:g}", &PointResult::ramb36, false},
    ResultFigure{"lut", "{:.0f}", &PointResult::lut, false},
    ResultFigure{"ff", "{:.0f}", &PointResult::ff, false},
    ResultFigure{"dsp", "{:.0f}", &PointResult::dsp, false},
};

PointResult result_of(RunStatistics const& run);
PointResult failed(std::string const& message);

nlohmann::ordered_json to_json(PointResult const& result);
/// Throws Json::exception for anything else.
void from_json(nlohmann::ordered_json const& json, PointResult& result);

}  // namespace dataflow::sweeps

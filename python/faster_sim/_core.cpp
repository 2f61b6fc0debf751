// What re-times recorded runs in the process of Python. Simulations are processes of their own (_program.py): SystemC can
// elaborate one design per process.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <fmt/format.h>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

#include "tb/program_commit.hpp"
#include "faster/dataflow_names.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/made_by.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/retimed_config.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/retime_many.hpp"
#include "dataflow/run/replay/scripted_run.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/report/csv.hpp"
#include "dataflow/tools/report/provenance.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/report/text_report.hpp"
#include "dataflow/tools/sizing/sizing_files.hpp"

namespace py = pybind11;

/// The SystemC library brings main(), which nobody calls here.
PYBIND11_EXPORT int sc_main(int, char**) {
    return 1;
}

namespace faster::python {
namespace {

using Overrides = std::vector<std::string>;  // KEY=VALUE
using Progress = std::optional<py::function>;
using Row = std::pair<std::optional<Cycles>, double>;

struct Cancelled {};

/// Work in a thread of its own, so that Python's main thread can tell its progress and notice Ctrl-C, which it throws as
/// KeyboardInterrupt once the work has stopped.
class Work {
  public:
    /// Called by the work, from any of its threads.
    void check() const {
        if (is_cancelled_)
            throw Cancelled();
    }
    void tell(std::size_t done, std::size_t all) {
        check();
        done_ = done;
        all_ = all;
    }

    template <class Function> auto result_of(Function const& function, Progress const& progress) {
        auto result = std::async(std::launch::async, function);
        while (is_running(result))
            look_after(progress);
        if (!is_cancelled_)
            return result.get();
        try {
            result.get();
        } catch (Cancelled const&) {
        }
        throw py::error_already_set();
    }

  private:
    template <class Result> static bool is_running(std::future<Result> const& result) {
        py::gil_scoped_release const others_may_run;
        return result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready;
    }

    /// What Python raised stays raised until the work has stopped.
    void look_after(Progress const& progress) {
        if (is_cancelled_)
            return;
        if (PyErr_CheckSignals() != 0) {
            is_cancelled_ = true;
            return;
        }
        if (!progress || all_ == 0)
            return;
        PyObject* const answer = PyObject_CallFunction(progress->ptr(), "nn", static_cast<Py_ssize_t>(done_),
                                                       static_cast<Py_ssize_t>(all_));
        is_cancelled_ = answer == nullptr;
        Py_XDECREF(answer);
    }

    std::atomic<bool> is_cancelled_{false};
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> all_{0};
};

/// The figures of a run with other timing.
struct Retimed {
    LoadedConfig loaded;
    RunStatistics run;

    /// 0 if it deadlocked.
    Cycles total_cycles() const { return run.deadlocked() ? 0 : run.total_cycles; }
    double milliseconds() const { return run.machine.milliseconds(total_cycles()); }
    std::string deadlock_report() const { return run.deadlocked() ? report::deadlock_report(run) : ""; }
    std::string summary() const {
        std::vector<ResolvedKey> const keys = resolved_keys(loaded.config);
        Json const made_by = report::made_by_json(keys);
        return run.deadlocked() ? report::deadlock_summary_json(keys, run, made_by)
                                : report::summary_json(keys, run, {}, made_by);
    }
};

class Events {
  public:
    explicit Events(std::string const& path)
        : file_(events::read_event_file(path)), scripted_(file_.run) {}

    std::string const& recorded_summary() const { return file_.summary; }

    /// Each key with its value, as JSON.
    std::string config() const {
        std::string text;
        for (ResolvedKey const& key : resolved_keys(file_.loaded.config))
            text += fmt::format("{}\"{}\": {}", text.empty() ? "" : ", ", key.key, json_text(key.value));
        return "{" + text + "}";
    }

    Retimed retime(Overrides const& overrides, bool critical_path) const {
        py::gil_scoped_release const others_may_run;
        LoadedConfig loaded = events::retimed_config(file_.loaded, overrides);
        Machine const machine = machine_of(loaded.config);
        RunStatistics run =
            critical_path ? replay::retime_with_path(scripted_, machine) : replay::retime(scripted_, machine);
        return {std::move(loaded), std::move(run)};
    }

    /// For each its cycles, none if it deadlocks, and its clock in MHz.
    std::vector<Row> retime_many(std::vector<Overrides> const& list, Progress const& progress) const {
        Work work;
        return work.result_of([&] { return rows(list, work); }, progress);
    }

    std::string sensitivities(Overrides const& overrides, Progress const& progress) const {
        Work work;
        return work.result_of(
            [&] {
                LoadedConfig const loaded = events::retimed_config(file_.loaded, overrides);
                RunStatistics run = replay::retime(scripted_, machine_of(loaded.config));
                run.sensitivities = replay::sensitivities(
                    file_.run, loaded, [&work](std::size_t done, std::size_t all) { work.tell(done, all); });
                run.alternatives = replay::alternatives(file_.run, loaded);
                return report::sensitivities_csv(run);
            },
            progress);
    }

    std::string size_fifos(Overrides const& overrides, double within_percent, unsigned front_points, unsigned jobs,
                           Progress const& progress) const {
        Work work;
        return work.result_of(
            [&] {
                sizing::SizingOptions options;
                options.within_percent = within_percent;
                options.front_points = front_points;
                options.jobs = static_cast<unsigned>(jobs_or_host_cores(jobs));
                options.before_retiming = [&work] { work.check(); };
                LoadedConfig const loaded = events::retimed_config(file_.loaded, overrides);
                return sizing::sizing_json(
                    sizing::size_fifos(file_.run, loaded.config, options,
                                       [&work](std::size_t done, std::size_t all) { work.tell(done, all); }));
            },
            progress);
    }

  private:
    std::vector<Row> rows(std::vector<Overrides> const& list, Work& work) const {
        std::vector<Machine> machines;
        std::vector<Row> rows;
        for (Overrides const& overrides : list) {
            work.tell(0, list.size());
            machines.push_back(machine_of(events::retimed_config(file_.loaded, overrides).config));
            rows.emplace_back(std::nullopt, machines.back().clock_mhz);
        }
        std::size_t done = 0;
        replay::retime_many(scripted_, machines, [&](std::size_t i, std::optional<RunStatistics> const& run) {
            if (run && !run->deadlocked())
                rows[i].first = run->total_cycles;
            work.tell(++done, machines.size());
        });
        return rows;
    }

    events::EventFile file_;
    replay::ScriptedRun scripted_;  ///< made ready once, for many retimings
};

}  // namespace

PYBIND11_MODULE(_core, module) {
    module.doc() = "Re-times recorded runs; faster_sim has what is meant to be used.";
    made_by() = {FASTER_VERSION, program_commit, program_commit_date, {}};
    module.attr("version") = made_by().version;
    module.attr("commit") = made_by().commit;
    py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
    module.def(
        "recording_program", [](std::string const& path) { return events::recording_program(path); }, py::arg("path"));
    py::class_<Retimed>(module, "Retimed")
        .def_property_readonly("total_cycles", &Retimed::total_cycles)
        .def_property_readonly("milliseconds", &Retimed::milliseconds)
        .def_property_readonly("deadlock_report", &Retimed::deadlock_report)
        .def_property_readonly("summary", &Retimed::summary)
        .def_property_readonly("samples", [](Retimed const& r) { return report::samples_csv(r.run, r.loaded.config); })
        .def_property_readonly("fifos", [](Retimed const& r) { return report::fifos_csv(r.run); })
        .def_property_readonly("loops", [](Retimed const& r) { return report::loops_csv(r.run); });
    py::class_<Events>(module, "Events")
        .def(py::init<std::string const&>(), py::arg("path"))
        .def_property_readonly("config", &Events::config)
        .def_property_readonly("recorded_summary", &Events::recorded_summary)
        .def("retime", &Events::retime, py::arg("overrides"), py::arg("critical_path"))
        .def("retime_many", &Events::retime_many, py::arg("list"), py::arg("progress"))
        .def("sensitivities", &Events::sensitivities, py::arg("overrides"), py::arg("progress"))
        .def("size_fifos", &Events::size_fifos, py::arg("overrides"), py::arg("within_percent"),
             py::arg("front_points"), py::arg("jobs"), py::arg("progress"));
}

}  // namespace faster::python

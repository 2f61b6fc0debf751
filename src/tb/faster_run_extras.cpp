#include "tb/faster_run_extras.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/options.hpp"
#include "faster/config/adopt_trace.hpp"
#include "faster/data/sample_counters.hpp"
#include "faster/dataflow_names.hpp"
#include "tb/faster_workload.hpp"

namespace faster {

void FasterRunExtras::declare(CLI::App& command) {
    command.add_option("--trace", trace_, "Replay a stimulus trace instead of the configured workload")
        ->type_name("DIR");
    command
        .add_option(
            "--images", images_,
            "Write pictures of the first K samples to DIR/images and into the HTML report (needs --out or --report)")
        ->type_name("K")
        ->check(integer_in(0, 1000000));
}

std::vector<std::string> FasterRunExtras::overrides(std::vector<std::string> const& given) const {
    return trace_.empty() ? std::vector<std::string>{} : std::vector<std::string>{setting_of_trace(trace_, given)};
}

void FasterRunExtras::check(bool has_output) const {
    if (images_ > 0 && !has_output)
        throw InputError("--images " + std::to_string(images_) + ": expected --out DIR or --report FILE as well");
}

void FasterRunExtras::before(Workload& workload) {
    auto& ours = static_cast<FasterWorkload&>(workload);
    pictures_ = std::make_unique<SamplePictures>(ours.stimulus, static_cast<std::size_t>(images_));
    if (images_ > 0)
        ours.probe = pictures_.get();
}

void FasterRunExtras::write(std::filesystem::path const& folder, std::vector<SampleStatistics> const& samples) const {
    pictures_->write(folder, samples);
}

std::vector<std::string> FasterRunExtras::warnings(std::vector<SampleStatistics> const& samples) const {
    std::vector<std::size_t> empty;
    for (SampleStatistics const& sample : samples)
        if (counters_from(sample.counters).valid_raster == 0)
            empty.push_back(sample.sample);
    if (empty.empty())
        return {};
    return {
        fmt::format("{} of {} samples draw no pixel, the first is sample {}: the object is outside of the window, too "
                    "small or too near there",
                    empty.size(), samples.size(), empty.front())};
}

std::vector<report::ReportPicture> FasterRunExtras::pictures() const { return pictures_->for_report(); }

}  // namespace faster

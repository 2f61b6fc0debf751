#include "tool/sweep_outputs.hpp"

#include <fmt/format.h>

#include "kernel/base/files/durable_file.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/sweeps/results_table.hpp"
#include "kernel/sweeps/sweep_page.hpp"
#include "tool/exit_codes.hpp"
#include "tool/say.hpp"

namespace faster {

namespace {

std::size_t count_of(sweeps::PointResult::Status status, sweeps::Manifest const& manifest,
                     sweeps::Results const& results) {
    std::size_t count = 0;
    for (sweeps::Manifest::Point const& point : manifest.points) {
        auto const found = results.find(point.id);
        if (found != results.end() && found->second.status == status)
            ++count;
    }
    return count;
}

void name_first_failed(sweeps::Manifest const& manifest, sweeps::Results const& results, std::size_t count) {
    for (std::size_t i = 0; i < manifest.points.size(); ++i) {
        auto const found = results.find(manifest.points[i].id);
        if (found == results.end() || found->second.status != sweeps::PointResult::Status::failed)
            continue;
        warn("{}: {} points failed, the first is {}: {}\n", program_name(), count, manifest.name(i),
             found->second.message);
        return;
    }
}

}  // namespace

int write_sweep_outputs(sweeps::SweepFolder const& folder, sweeps::Manifest const& manifest,
                        sweeps::Results const& results) {
    io::write_file_durably(folder.table(), sweeps::results_csv(manifest, results));
    io::write_file_durably(folder.page(), sweeps::sweep_page(manifest, results));
    std::size_t const failed = count_of(sweeps::PointResult::Status::failed, manifest, results);
    std::size_t const done = count_of(sweeps::PointResult::Status::done, manifest, results);
    std::size_t const deadlocked = count_of(sweeps::PointResult::Status::deadlock, manifest, results);
    std::size_t const all = manifest.points.size(), there = done + deadlocked + failed;
    say("{}{} points: {} done, {} deadlocked, {} failed\nwritten: {}, {}\n",
        there < all ? fmt::format("{} of ", there) : "", all, done, deadlocked, failed, folder.table().string(),
        folder.page().string());
    if (failed == 0)
        return exit_done;
    name_first_failed(manifest, results, failed);
    return exit_failed_check;
}

}  // namespace faster

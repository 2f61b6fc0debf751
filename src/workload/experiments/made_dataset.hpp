#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

#include "workload/experiments/experiment.hpp"

namespace faster::experiments {

/// Writes a setting's scenes as a dataset in the format of BOP, whole or not at all: a scene per class, whose number is
/// the obj_id. A folder that already holds these very scenes is left as it is. `progress` is told how many
/// images of all are done. Throws InputError if it cannot be written.
void make_dataset(std::filesystem::path const& folder, Setting const& setting, std::uint64_t seed, std::size_t jobs,
                  std::function<void(std::size_t done, std::size_t all)> const& progress);

}  // namespace faster::experiments

#include "dataflow/tools/sizing/certificate.hpp"

#include <algorithm>
#include <numeric>

#include "dataflow/base/on_threads.hpp"

namespace dataflow::sizing {

namespace {

double cost_at(FifoFrame const& frame, std::size_t fifo, FifoChoice const& choice) {
    return cost_of(primitives_of(choice, frame.freedoms[fifo], frame.weights), frame.weights);
}

/// 0 if nothing shallower costs less.
std::uint64_t cheaper_depth(FifoFrame const& frame, std::size_t fifo, FifoChoice const& choice) {
    std::uint64_t depth = choice.depth - 1;
    while (depth > 0 && cost_at(frame, fifo, frame.freedoms[fifo].at_depth(depth)) >= cost_at(frame, fifo, choice))
        --depth;
    return depth;
}

/// The cores, by how long they take.
std::vector<std::size_t> latest_first(Choice const& choice, CoreTimes& times) {
    std::vector<std::size_t> cores(times.cores());
    std::iota(cores.begin(), cores.end(), std::size_t{0});
    std::stable_sort(cores.begin(), cores.end(), [&](std::size_t one, std::size_t other) {
        return times.cycles(one, choice) > times.cycles(other, choice);
    });
    return cores;
}

}  // namespace

std::vector<CertificateRow> steps_down(FifoFrame const& frame, Choice const& choice) {
    std::vector<CertificateRow> rows;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        if (choice[i].depth == 1)
            continue;
        CertificateRow row;
        row.fifo = i;
        row.shallower = frame.freedoms[i].at_depth(choice[i].depth - 1);
        row.is_token_step = true;
        std::uint64_t const cheaper = cheaper_depth(frame, i, choice[i]);
        row.is_cost_step = cheaper == choice[i].depth - 1;
        if (row.is_cost_step || row.shallower.kind == choice[i].kind)
            rows.push_back(row);
        if (row.is_cost_step || cheaper == 0)
            continue;
        row.shallower = frame.freedoms[i].at_depth(cheaper);
        row.is_token_step = false;
        row.is_cost_step = true;
        rows.push_back(row);
    }
    return rows;
}

void time_steps(Choice const& choice, Cycles bound, CoreTimes& times, unsigned jobs, std::vector<CertificateRow>& rows,
                std::function<void()> const& done) {
    std::vector<std::size_t> const cores = latest_first(choice, times);
    on_threads(rows.size(), jobs, [&](std::size_t i) {
        Choice shallower = choice;
        shallower[rows[i].fifo] = rows[i].shallower;
        for (std::size_t k = 0; k < cores.size() && !rows[i].breaks(bound); ++k) {
            rows[i].core = cores[k];
            rows[i].core_cycles = times.cycles(cores[k], shallower);
        }
        done();
    });
}

}  // namespace dataflow::sizing

#pragma once
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow {

/// Figures as bytes, on their way from one process of this program to another.
class FigureWriter {
  public:
    template <class Item> void operator()(Item const& item) {
        static_assert(std::is_trivially_copyable_v<Item>);
        bytes_.append(reinterpret_cast<char const*>(&item), sizeof item);
    }
    void operator()(std::string const& text) {
        (*this)(text.size());
        bytes_ += text;
    }
    template <class Item> void size_of(std::vector<Item> const& items) { (*this)(items.size()); }
    std::string take() && { return std::move(bytes_); }

  private:
    std::string bytes_;
};

class FigureReader {
  public:
    explicit FigureReader(std::string bytes) : bytes_(std::move(bytes)) {}

    template <class Item> void operator()(Item& item) {
        static_assert(std::is_trivially_copyable_v<Item>);
        std::memcpy(&item, next(sizeof item), sizeof item);
    }
    void operator()(std::string& text) {
        std::size_t size = 0;
        (*this)(size);
        text.assign(next(size), size);
    }
    template <class Item> void size_of(std::vector<Item>& items) {
        std::size_t size = 0;
        (*this)(size);
        if (size > bytes_.size())
            throw std::runtime_error("figures of a part of a run are cut off");
        items.resize(size);
    }

  private:
    char const* next(std::size_t size) {
        if (size > bytes_.size() - at_)
            throw std::runtime_error("figures of a part of a run are cut off");
        at_ += size;
        return bytes_.data() + at_ - size;
    }

    std::string bytes_;
    std::size_t at_ = 0;
};

template <class Bytes, class Items, class Each> void pass_all(Bytes& bytes, Items& items, Each each) {
    bytes.size_of(items);
    for (auto& item : items)
        each(item);
}

/// Reads or writes what simulate() finds of cores that are not stuck.
template <class Bytes, class Core> void pass_core(Bytes& bytes, Core& core) {
    auto const whole = [&bytes](auto& item) { bytes(item); };
    bytes(core.samples);
    bytes(core.end_cycle);
    pass_all(bytes, core.fifos, whole);
    pass_all(bytes, core.loops, [&bytes](auto& loop) {
        for (auto* cycles : {&loop.ii_target, &loop.ii_recurrence, &loop.ii, &loop.depth, &loop.port_conflict_cycles,
                             &loop.recurrence_cycles, &loop.interlock_cycles})
            bytes(*cycles);
        bytes(loop.entries);
        bytes(loop.iterations);
        bytes(loop.bram_accesses);
        bytes(loop.limited_by);
        bytes(loop.bram);
    });
    pass_all(bytes, core.processes, [&](auto& process) {
        bytes(process.cycles);
        pass_all(bytes, process.stalls, whole);
        pass_all(bytes, process.port_conflicts, whole);
    });
}

template <class Bytes, class Run> void pass_figures(Bytes& bytes, Run& run) {
    bytes(run.total_cycles);
    pass_all(bytes, run.samples, [&bytes](auto& sample) {
        bytes(sample.sample);
        bytes(sample.core);
        bytes(sample.start_cycle);
        bytes(sample.end_cycle);
        pass_all(bytes, sample.counters, [&bytes](auto& counter) { bytes(counter); });
    });
    pass_all(bytes, run.cores, [&bytes](auto& core) { pass_core(bytes, core); });
}

}  // namespace dataflow

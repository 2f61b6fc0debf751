#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// A stretch of a process's program, as far as a critical path tells them apart.
class Region {
  public:
    enum class Part : std::uint8_t { outside, setup, memory, fill, iterations, interlock, drain };

    Region() = default;
    static Region setup() { return Region(1); }
    static Region memory() { return Region(2); }  ///< it waits for the external one
    static Region of_loop(unsigned loop, Part part) {
        static_assert(static_cast<unsigned>(Part::fill) == first_of_loop);
        return Region(static_cast<std::uint16_t>(parts_of_loop * loop + static_cast<unsigned>(part)));
    }

    Part part() const {
        return !is_in_loop() ? static_cast<Part>(number_)
                             : static_cast<Part>((number_ - first_of_loop) % parts_of_loop + first_of_loop);
    }
    /// Only inside one.
    unsigned loop() const { return (number_ - first_of_loop) / parts_of_loop; }
    bool is_in_loop() const { return number_ >= first_of_loop; }
    unsigned number() const { return number_; }
    /// Regions of a process with so many loops.
    static unsigned count(unsigned loops) { return first_of_loop + parts_of_loop * loops; }
    static Region numbered(unsigned number) { return Region(static_cast<std::uint16_t>(number)); }
    bool operator==(Region const& other) const { return number_ == other.number_; }

  private:
    static constexpr unsigned first_of_loop = 3;
    static constexpr unsigned parts_of_loop = 4;
    explicit Region(std::uint16_t number) : number_(number) {}

    std::uint16_t number_ = 0;
};

/// What the cycles of a path were spent with, by process and region. There is room for so many regions and ports of
/// each process. Of no processes: nothing.
class PathSums {
  public:
    enum class Share : std::uint8_t { own, recurrence, port_conflict, flight };
    static constexpr unsigned shares = 4;

    PathSums() = default;
    PathSums(std::size_t processes, std::size_t regions, std::size_t ports)
        : regions_(regions), ports_(ports), own_(processes * regions * shares), turns_(processes * regions * ports) {}

    std::uint64_t& of(unsigned process, Region region, Share share) { return own_[place(process, region, share)]; }
    std::uint64_t of(unsigned process, Region region, Share share) const { return own_[place(process, region, share)]; }
    /// How often the path left `process`, in a region, for the process at the other end of a port.
    std::uint64_t& turns(unsigned process, Region region, unsigned port) {
        return turns_[place(process, region) * ports_ + port];
    }
    std::uint64_t turns(unsigned process, Region region, unsigned port) const {
        return turns_[place(process, region) * ports_ + port];
    }

    /// this += times * (other - base), all of the same processes.
    void add(PathSums const& other, PathSums const& base, std::uint64_t times);
    void add(PathSums const& other);

  private:
    std::size_t place(unsigned process, Region region) const { return process * regions_ + region.number(); }
    std::size_t place(unsigned process, Region region, Share share) const {
        return place(process, region) * shares + static_cast<std::size_t>(share);
    }

    std::size_t regions_ = 0, ports_ = 0;
    std::vector<std::uint64_t> own_;
    std::vector<std::uint64_t> turns_;
};

}  // namespace dataflow::timing

#pragma once
#include <cstddef>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

namespace faster {

/// The memories of a unit that its samples take in turn: one, or two, so that a process fills one while another reads
/// the other out. Tokens tell whose turn it is; this holds both processes to it.
///   errors  to claim what somebody else holds is a fatal report: two samples in one memory at once
template <class Memory> class PingPong {
  public:
    explicit PingPong(std::vector<Memory> memories) : memories_(std::move(memories)), held_(memories_.size(), false) {}

    std::size_t size() const { return memories_.size(); }
    /// Nobody else may touch it until release().
    Memory& claim(std::size_t number) {
        if (held_.at(number))
            SC_REPORT_FATAL("faster/ping_pong", ("buffer " + std::to_string(number) + " is in use").c_str());
        held_[number] = true;
        return memories_[number];
    }
    void release(std::size_t number) { held_.at(number) = false; }
    /// Whose turn comes after `number`'s.
    std::size_t after(std::size_t number) const { return (number + 1) % memories_.size(); }

  private:
    std::vector<Memory> memories_;
    std::vector<bool> held_;
};

}  // namespace faster

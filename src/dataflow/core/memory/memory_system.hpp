#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/memory_master.hpp"
#include "dataflow/core/memory/served_burst.hpp"
#include "dataflow/core/time/trail.hpp"

namespace dataflow::timing {

class CoreTiming;

/// The memory that all cores of a machine share: it joins their times (docs/memory-model.md). Bursts are served in the
/// order in which they are asked for. One may be served as soon as nothing that is not known yet can be asked for
/// before it.
class MemorySystem {
  public:
    /// What a stream of a core is to the memory, which has one for each. Masters stand in the order that settles ties.
    struct MasterShape {
        unsigned process = 0;
        Prefetch prefetch = Prefetch::none;
        bool hands_out = false;  ///< headers, which tell others what to prefetch
    };

    MemorySystem(ExternalMemory const& shape, std::vector<MasterShape> masters);

    ExternalMemory const& shape() const { return shape_; }
    /// In order. The core must stay where it is. `has_work`: it does something at all. `resume`, if there is one, lets
    /// it go on instead of CoreTiming::resume(), for who does not log all at once.
    using Resume = std::function<void(ProcessMask woken)>;
    void add_core(CoreTiming& core, bool has_work, Resume resume = nullptr);
    /// More to do for a core's master, in order; before its process comes there.
    void add(std::size_t core, std::size_t master, MemoryEntry entry) {
        masters_[core * shapes_.size() + master].master.add(std::move(entry));
    }

    /// Gives cycles to all operations that the cores have logged and that can have them. `at_the_end`: nothing more
    /// will be logged.
    void go_on(bool at_the_end);
    /// To be called when a core has logged another sample: goes on when about all have.
    void note_sample() {
        if (++samples_ % cores_.size() == 0)
            go_on(false);
    }

    // Step by step, for who brings time itself.

    /// A process that may go on.
    struct Target {
        std::size_t core = 0;
        unsigned process = 0;
    };
    /// Looks at what all processes have done.
    std::vector<Target> follow();
    /// When the next burst is asked for, as far as is known.
    std::optional<Cycles> next_ask() const;
    /// Serves it.
    Target serve_next();

    /// From now on, tells of every burst when it is served. In the order of asking.
    void on_served(std::function<void(ServedBurst const&)> call) { served_call_ = std::move(call); }

    MasterFigures const& figures(std::size_t core, std::size_t master) const {
        return masters_[core * shapes_.size() + master].master.figures();
    }
    std::vector<MasterShape> const& masters() const { return shapes_; }
    /// Beats that each port has brought to the cores.
    std::vector<std::uint64_t> const& port_beats() const { return port_beats_; }
    ControllerFigures const& controller() const { return controller_; }

  private:
    /// A master, and what is at its two sides.
    struct Joint {
        MemoryMaster master;
        Target target;
        std::size_t port = 0;
        MemoryMaster::HandedOut* handing_out = nullptr;  ///< of the headers' master; null: hands out nothing
        bool is_waiting = false;                         ///< is in requests_
    };
    /// Requests by the cycle of asking, then by master.
    using Request = std::pair<Cycles, std::size_t>;
    using Requests = std::priority_queue<Request, std::vector<Request>, std::greater<>>;

    struct Served {
        std::size_t master = 0;
        Cycles first_readable = MemoryMaster::never;
    };
    bool follow_master(std::size_t master);
    void settle(std::size_t core, ProcessMask woken);
    void note_request(std::size_t master);
    Served serve();
    Cycles wake(Served const& served);
    void let_go(std::size_t core);
    Cycles unknown_from() const;
    void note_queue(Picoseconds arrival, Picoseconds begin);

    ExternalMemory shape_;
    std::vector<MasterShape> shapes_;
    /// A core. `woken`: its processes for which something has been brought since it went on, a bit each, of which none
    /// goes on before a cycle.
    struct Core {
        CoreTiming* timing = nullptr;
        Resume resume;
        ProcessMask woken = 0;
        Cycles goes_on_from = MemoryMaster::never;
    };
    std::vector<Core> cores_;
    std::uint64_t samples_ = 0;
    std::vector<CoreTiming const*> working_;          // those that do something
    std::deque<MemoryMaster::HandedOut> handed_out_;  // by core
    std::deque<Joint> masters_;                       // of the first core, of the second, ...
    Requests requests_;
    std::vector<Picoseconds> controllers_free_ps_;  // one, or one of each master
    std::vector<Cycles> ports_free_;                // of all, or one of each master
    std::vector<std::uint64_t> port_beats_;
    ControllerFigures controller_;
    std::function<void(ServedBurst const&)> served_call_;
    std::deque<Picoseconds> begins_ps_;  // of bursts that begin later than they arrive
};

}  // namespace dataflow::timing

#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/files/c_file.hpp"
#include "dataflow/tools/recording/event.hpp"

namespace dataflow::recording {

/// The events of one process, in order, a few bytes each. What does not fit into a small buffer waits in a temporary
/// file. Errors: InputError if there is no room for it.
class EventSpool {
  public:
    void put(Event const& event);
    /// Goes back to the first event; nothing can be put any more.
    void rewind();
    /// The next event; false at the end.
    bool get(Event& event);

  private:
    static constexpr std::size_t buffer_size = 1U << 18;
    static constexpr std::size_t longest_event = 48;  // bytes

    void put_number(std::uint64_t number) {
        for (; number >= 0x80; number >>= 7)
            *at_++ = static_cast<std::uint8_t>(number | 0x80U);
        *at_++ = static_cast<std::uint8_t>(number);
    }
    std::uint64_t get_number() {
        std::uint64_t number = 0;
        for (unsigned shift = 0;; shift += 7) {
            std::uint8_t const byte = *at_++;
            number |= std::uint64_t{byte & 0x7FU} << shift;
            if (byte < 0x80)
                return number;
        }
    }
    void spill();
    void refill();

    io::CFile file_;
    std::vector<std::uint8_t> buffer_;
    std::uint8_t* at_ = nullptr;
    std::uint8_t* end_ = nullptr;     ///< of what is to be read, or of the room
    Cycles cycle_ = 0;                ///< of the last event
    std::vector<std::uint8_t> last_;  ///< put after the last spill
};

/// Those of a core. Samples begin and end in cycles of their own, before or after what their processes do meanwhile.
struct Spools {
    std::vector<EventSpool> processes;
    EventSpool begins, ends;  ///< of samples

    template <class Visit> void each(Visit visit) {
        for (std::size_t process = 0; process < processes.size(); ++process)
            visit(process, processes[process]);
        visit(0, begins);
        visit(0, ends);
    }
};

}  // namespace dataflow::recording

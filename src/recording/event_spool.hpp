#pragma once
#include <cstdio>
#include <memory>
#include <vector>

#include "recording/event.hpp"

namespace faster::recording {

/// The events of one process, in order. What does not fit into a small buffer waits in a temporary file.
class EventSpool {
  public:
    void put(Event const& event);
    /// Goes back to the first event; nothing can be put any more.
    void rewind();
    /// The next event; false at the end.
    bool get(Event& event);

  private:
    static constexpr std::size_t most_in_memory = 1U << 14;

    void spill();
    bool refill();

    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Closer> file_;
    std::vector<Event> buffer_;
    std::size_t next_ = 0;
    bool reads_file_ = false;
    std::vector<Event> last_;  ///< put after the last spill
};

}  // namespace faster::recording

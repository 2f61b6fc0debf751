#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/byte_stream.hpp"
#include "hls/observer.hpp"

namespace dataflow::untimed {

struct Access {
    std::size_t stream = 0;
    bool writes = false;

    friend bool operator<(Access const& a, Access const& b) {
        return a.stream != b.stream ? a.stream < b.stream : a.writes < b.writes;
    }
    friend bool operator==(Access const& a, Access const& b) { return a.stream == b.stream && a.writes == b.writes; }
};
using Accesses = std::vector<Access>;
using LoopNames = std::set<std::string, std::less<>>;  // of a process

/// Something that a function has done, in program order.
struct Event {
    enum class What {
        enter,    ///< loop `number` begins
        iterate,  ///< `count` iterations of it, each of which makes the accesses of group `number`
        leave,
        access  ///< outside loops: the one of group `number`
    };
    What what;
    std::size_t number = 0;
    std::uint64_t count = 1;
};
using Events = std::vector<Event>;

/// Sees that a function does something else than to go round in its loops.
///   errors  InputError for one that never does
class IdleIterations {
  public:
    void ends() { count_ = 0; }
    void count(std::string const& process, LoopMark const& loop);

  private:
    std::uint64_t count_ = 0;
};

/// Turns what a function does into events. A loop goes on until its function does something else: loops around it that
/// have no mark and do nothing of their own are one with it, as tools flatten them. A marked loop around other marked
/// ones only says where those end; what it accesses itself is outside loops.
///   errors  InputError for a pipelined loop around a marked one, for two loops of one name that differ, and for a
///           function that never ends
class LoopRecorder {
  public:
    /// `around`: of the same function, what around() has been of it before.
    explicit LoopRecorder(std::string process, LoopNames around = {})
        : process_(std::move(process)), around_(std::move(around)) {}

    void access(Access access);
    /// Some of the accesses of that kind do not wait, or the stream is asked. Behind an iteration it may be the
    /// condition of the loop that asks, which is part of an iteration.
    void attempt(Access const& access);
    bool attempts(Access const& access) const { return attempts_.count(access) != 0; }
    std::set<Access> const& attempts() const { return attempts_; }
    /// In an iteration of the loop, or in its condition.
    bool attempts_in(std::size_t loop, Access const& access) const { return attempts_in_.count({loop, access}) != 0; }
    /// And an iteration of that loop reads behind it.
    bool attempts_before_reads(std::size_t loop, Access const& access) const {
        return before_reads_.count({loop, access}) != 0;
    }
    void begin(LoopMark const& loop);
    void end();
    /// All that has happened since the last call. The function has returned, or is stuck.
    Events take();

    /// What it has taken down of a function, for another process of the program.
    void send(ValueWriter& bytes) const { bytes.put(around_, loops_, groups_, attempts_, attempts_in_, before_reads_); }
    void receive(ValueReader& bytes) { bytes.get(around_, loops_, groups_, attempts_, attempts_in_, before_reads_); }

    /// Loops that have had a marked one in them.
    LoopNames const& around() const { return around_; }
    std::vector<LoopMark> const& loops() const { return loops_; }
    std::vector<Accesses> const& groups() const { return groups_; }

  private:
    struct Open {
        std::size_t loop;
        Accesses accesses;  ///< of the iteration at hand
        Accesses attempts;  ///< and those that do not wait, with those of its condition
        bool is_around = false;
    };
    std::size_t number_of(LoopMark const& loop);
    std::size_t group_of(Accesses const& accesses);
    void leave();
    void look_behind();
    Events as_parts(Events const& events);
    void put_around(Open& outer);

    std::string process_;
    LoopNames around_;
    std::vector<LoopMark> loops_;
    std::vector<Accesses> groups_;
    std::map<Accesses, std::size_t> group_numbers_;
    std::set<Access> attempts_;
    std::set<std::pair<std::size_t, Access>> attempts_in_;   // loops, and what they attempt
    std::set<std::pair<std::size_t, Access>> before_reads_;  // of those
    Accesses condition_;                                     // attempts behind the last iteration
    std::vector<Open> open_;
    bool is_in_loop_ = false;
    std::size_t loop_ = 0;  // that it is in
    Events events_;
    IdleIterations idle_;
};

}  // namespace dataflow::untimed

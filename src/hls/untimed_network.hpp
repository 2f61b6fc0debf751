#pragma once
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hls/loop_recorder.hpp"
#include "hls/observer.hpp"

namespace dataflow::untimed {

/// Throws InputError.
[[noreturn]] void refuse_size(StreamBase const& stream);
[[noreturn]] void refuse_stranger(StreamBase const& stream);

/// How an error ends that names what a design's functions do with its numbers alone, not with their defaults.
inline constexpr char const* expected_defaults =
    " with the defaults of the design's numbers, expected defaults that make it use all of its loops and streams";

/// What the function of a process has thrown, as the InputError that names it. In the handler of it.
std::exception_ptr thrown_by_process(std::string const& name);

/// A function of a design, with its arguments.
struct ProcessCall {
    std::string name;
    std::function<void()> call;
};

/// Runs the functions of a design without time, as C simulation does, and takes down what they do. One runs at a time,
/// in their order, each until it returns or finds a stream empty; streams have no end. What a function does does not
/// depend on that order, as each stream has one writer and one reader and reads wait. So this is what hardware does,
/// whenever it does it. An access that does not wait has no such answer: of those every third finds nothing, so that
/// both ways through a function are seen, and what comes of it is no more than an example.
///   errors  InputError for size(), for what the functions throw, and for one that does not return
class UntimedNetwork {
  public:
    /// `around`: by process, what its recorder has of another network's; or nothing.
    explicit UntimedNetwork(std::vector<ProcessCall> const& processes, std::vector<LoopNames> const& around = {});
    ~UntimedNetwork();

    /// Calls each function once. Those that are left waiting for tokens that nobody writes are given up.
    void run();
    /// So does this, in a process of its own: static variables of the functions stay as they are. Of what was done all
    /// is known but the tokens.
    ///   errors  InputError also for a function that ends that process
    void run_apart();
    /// Those were, as "a waits for b, c waits for d", each a process and its stream.
    std::string const& waiting() const { return waiting_; }
    /// What each has done in the last run, by process.
    std::vector<Events>& events() { return events_; }
    LoopRecorder const& recorder(std::size_t process) const { return *recorders_[process]; }
    /// The tokens that were written to each stream in the last run, as waveforms show them.
    std::vector<std::vector<std::int64_t>>& written() { return written_; }

  private:
    std::string sent_run();
    void receive(std::string bytes);

    class Baton;
    class Watcher;

    std::vector<ProcessCall> const& processes_;
    std::vector<std::unique_ptr<LoopRecorder>> recorders_;
    std::vector<Events> events_;
    std::string waiting_;
    std::vector<std::vector<std::int64_t>> written_;
};

}  // namespace dataflow::untimed

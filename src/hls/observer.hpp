#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dataflow::untimed {

/// What the wrapper of a loop says of it (hls/faster_hls.h).
struct LoopMark {
    char const* name;
    unsigned ii;     ///< initiation interval asked for; of a loop that is not pipelined, its states; 0: it is no loop
    unsigned depth;  ///< stages of an iteration, unless a configuration says otherwise
    bool is_pipelined;
    char const* file = "";  ///< where it stands in the source, if that is known
    unsigned line = 0;

    /// A block of states, with none before its first and none behind its last.
    bool is_block() const { return ii == 0; }
};

class StreamBase;

/// An access that does not wait.
struct Attempt {
    bool writes = false;
    bool only_asks = false;  ///< empty() and full(): no access takes place
    std::int64_t shown = 0;  ///< the token to be written, as waveforms show it
};

/// Who looks on while a function runs: what it does to streams, and in which iterations of which loops. Of a thread
/// each; without one a function is plain C++.
class Observer {
  public:
    virtual ~Observer() = default;
    /// The number of the function.
    virtual std::size_t process() const = 0;
    /// Returns when the stream has a token.
    virtual void reads(StreamBase& stream) = 0;
    virtual void wrote(StreamBase& stream) = 0;
    /// Whether it finds a token, or room.
    virtual bool attempts(StreamBase const& stream, Attempt const& attempt) = 0;
    /// size(), which no hardware counts. Throws.
    virtual void asks_size(StreamBase const& stream) = 0;
    /// Something is done to a stream that no design has, and that this function has not made itself. Throws.
    virtual void meets_stranger(StreamBase const& stream) = 0;
    virtual void begins_iteration(LoopMark const& loop) = 0;
    /// Does not throw: it may be called because something has been thrown.
    virtual void ends_iteration(LoopMark const& loop) noexcept = 0;
};

inline thread_local Observer* observer = nullptr;
/// Where streams that are made enter themselves: those of the design that is being made, if any.
inline thread_local std::vector<StreamBase*>* streams_of_design = nullptr;

/// The part of a stream that does not depend on the type of its tokens.
class StreamBase {
  public:
    StreamBase(StreamBase const&) = delete;
    StreamBase& operator=(StreamBase const&) = delete;
    virtual ~StreamBase() {
        if (streams_of_design != nullptr && number_ < streams_of_design->size() &&
            (*streams_of_design)[number_] == this)
            (*streams_of_design)[number_] = nullptr;  // HlsDesign::complete() refuses it
    }

    std::string const& name() const { return name_; }
    void rename(std::string name) { name_ = std::move(name); }
    /// Its number in the design that it belongs to, if it belongs to one.
    bool is_of_design() const { return number_ != of_no_design; }
    std::size_t number() const { return number_; }
    /// What its type says: stream<T, DEPTH>. 0: nothing.
    unsigned depth() const { return depth_; }

    virtual bool has_token() const = 0;
    virtual unsigned bits() const = 0;
    virtual bool is_signed() const = 0;
    /// The token written last, as waveforms show it.
    virtual std::int64_t shown_last() const = 0;

  protected:
    explicit StreamBase(std::string name) : name_(std::move(name)) {
        if (streams_of_design == nullptr)
            return;
        number_ = streams_of_design->size();
        streams_of_design->push_back(this);
    }
    void set_depth(unsigned depth) { depth_ = depth; }

    /// None of what a function keeps to itself: that takes no time, as its arrays.
    Observer* watcher() const {
        if (observer == nullptr || is_of_design())
            return observer;
        if (made_by_ != observer->process())
            observer->meets_stranger(*this);
        return nullptr;
    }

  private:
    static constexpr std::size_t of_no_design = ~std::size_t{0};
    static constexpr std::size_t by_nobody = ~std::size_t{0};
    std::string name_;
    std::size_t number_ = of_no_design;
    unsigned depth_ = 0;
    std::size_t made_by_ = observer != nullptr ? observer->process() : by_nobody;  ///< a function, which may keep it
};

/// An iteration of a loop: the rest of the scope in which it stands.
class Iteration {
  public:
    explicit Iteration(LoopMark const& loop) : loop_(loop) {
        if (observer != nullptr)
            observer->begins_iteration(loop_);
    }
    ~Iteration() {
        if (observer != nullptr)
            observer->ends_iteration(loop_);
    }
    Iteration(Iteration const&) = delete;
    Iteration& operator=(Iteration const&) = delete;

  private:
    LoopMark const& loop_;
};

}  // namespace dataflow::untimed

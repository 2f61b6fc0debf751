#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "channels/port_binding.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

/// The tokens of a TokenLoop's FIFOs, one of each per iteration.
template <class... Tokens> struct Reads {};
template <class... Tokens> struct Writes {};

/// Calls the body of an iteration with its tokens, and before them with its number, if it takes one.
template <class Body, class... Tokens> auto call_iteration(Body& body, std::uint64_t iteration, Tokens&... tokens) {
    if constexpr (std::is_invocable_v<Body&, std::uint64_t, Tokens&...>)
        return body(iteration, tokens...);
    else
        return body(tokens...);
}

/// What TokenLoop::run_mixed() is told of iterations.
struct MixedIterations {
    unsigned count = 0;
    std::uint32_t seconds = 0;  ///< bit i: the i-th took a second one, which accesses nothing
    bool is_last = false;       ///< no more follow
};

/// A pipelined loop whose every iteration reads the same FIFOs, when it begins, and writes the same: what
/// ProcessClock::pipeline() is with tokens_of(), for modules that take a loop in parts, or many tokens at once. Tokens
/// lie side by side, the clock is told of many iterations together, and bodies are inlined.
///
///     TokenLoop<Reads<Pixel, Depth>> sweep_;                                            of a module
///     sweep_.connect(clock_, "sweep", &channel_of(pixel_in), &channel_of(depth_in));    in end_of_elaboration()
///     sweep_.run_while([&](Pixel const& pixel, Depth const& depth) { ...; return !pixel.is_last; });
///
/// Bodies of single iterations are called with the tokens read, then with those to be written, and before them with the
/// iteration's number from 0 on, if they take one. Where iterations may have to wait for writes (`hazards: interlock`),
/// they are told one by one: what the body lets the loop's WriteDistances meet is what its iteration waits for.
///
/// Bodies access no FIFOs themselves, and are called ahead of time: in lockstep, too, up to `longest_burst` iterations
/// that only write are worked out before the first takes place.
template <class Inputs, class Outputs = Writes<>> class TokenLoop;

template <class... In, class... Out> class TokenLoop<Reads<In...>, Writes<Out...>> {
  public:
    static constexpr std::size_t longest_burst = 1024;  ///< of tokens written
    static constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

    /// Once, after the clock's connect_all(). A FIFO that is absent is null, and so are its tokens in take(). Several
    /// may be of one loop, where iterations differ in what they access. Errors: InputError for a FIFO that the loop
    /// does not name, whose end is another module's, or that is there twice, and for a loop of which
    /// ProcessClock::reads_first() is false.
    void connect(ProcessClock& clock, std::string_view name, ClockedFifo<In>*... in, ClockedFifo<Out>*... out) {
        clock_ = &clock;
        loop_ = clock.loop(name);
        if (!clock.reads_first(loop_))
            throw InputError(
                "loop " + clock.timing().name() + "." + std::string(name) +
                " is told of many iterations at once, and reads a FIFO when they are under way, or makes " +
                "attempts, expected read_stage 0, or ProcessClock::pipeline() in the module");
        in_ = {in...};
        out_ = {out...};
        ports_ = timing::no_ports;
        each_of(in_, [this](auto& fifo) {
            clock_->require_end(fifo, fifo.read_port(), false);
            clock_->note_first_reads(loop_, fifo.read_port());
            add(fifo.read_port());
        });
        each_of(out_, [this](auto& fifo) {
            clock_->require_end(fifo, fifo.write_port(), true);
            add(fifo.write_port());
        });
    }
    /// What iterations access besides: the external memory.
    void also_accesses(timing::Ports ports) { ports_ = ports_ | ports; }

    void enter(SourceSite site = SourceSite::here()) { clock_->enter_loop(loop_, site); }
    void leave() { clock_->leave_loop(); }
    /// All of the loop: take(), each() and take_while().
    template <class Body> void run(std::size_t count, Body body, SourceSite site = SourceSite::here()) {
        enter(site);
        take(count, body);
        leave();
    }
    template <class Body> void run_each(std::size_t count, Body body, SourceSite site = SourceSite::here()) {
        enter(site);
        each(count, body);
        leave();
    }
    template <class Body> void run_while(Body body, SourceSite site = SourceSite::here()) {
        enter(site);
        take_while(body);
        leave();
    }

    /// `count` iterations, in bursts: body(first, n, in..., out...) does up to n of them, from number `first` on, whose
    /// tokens are behind the pointers. It returns how many it has done, or nothing if it does them all.
    template <class Body> void take(std::size_t count, Body body) {
        for (std::size_t done = 0; done < count;)
            done += burst(count - done, [&](std::size_t n, auto*... tokens) {
                if constexpr (std::is_void_v<decltype(body(done, n, tokens...))>) {
                    body(done, n, tokens...);
                    return n;
                } else {
                    return body(done, n, tokens...);
                }
            });
    }
    /// `count` iterations, of each of which the body is called. Tokens are of one value, as in take_while() and
    /// run_mixed(): several side by side, a FIFO's lanes, are for take().
    template <class Body> void each(std::size_t count, Body body) {
        take(count, [&](std::size_t first, std::size_t n, auto*... tokens) {
            for (std::size_t i = 0; i < n; ++i)
                call_iteration(body, first + i, token_at(tokens + i)...);
        });
    }
    /// Iterations until the body, called of each, returns false.
    template <class Body> void take_while(Body body) {
        bool goes_on = true;
        for (std::size_t first = 0; goes_on;)
            first += burst(no_limit, [&](std::size_t n, auto*... tokens) {
                std::size_t done = 0;
                for (; goes_on && done < n; ++done)
                    goes_on = call_iteration(body, first + done, token_at(tokens + done)...);
                return done;
            });
    }

    /// All of a loop that only reads, in which some iterations take a second one: body(n, in...) does 1 to n
    /// iterations, n at most 32, and their second ones.
    template <class Body> void run_mixed(Body body, SourceSite site = SourceSite::here()) {
        enter(site);
        for (bool goes_on = true; goes_on;) {
            auto const n = static_cast<unsigned>(std::min(at_hand(), most_at_once(timing::Operation::longest_mix)));
            MixedIterations const mix = with_tokens([&](auto const*... in) { return body(n, in...); });
            tell(mix);
            each_of(in_, [&mix](auto& fifo) { fifo.consume(mix.count); });
            goes_on = !mix.is_last;
        }
        leave();
    }

  private:
    void add(timing::Ports port) {
        clock_->require_access(loop_, ports_, port);
        ports_ = ports_ | port;
    }
    /// To be read; or to be written, where there may be what another token has left.
    template <class Token> static Token const& token_at(Token const* token) { return *token; }
    template <class Token> static Token& token_at(Token* token) { return *token = Token(); }

    template <class Fifos, class Call> static void each_of(Fifos const& fifos, Call call) {
        std::apply([&](auto*... fifo) { ((fifo != nullptr ? call(*fifo) : void()), ...); }, fifos);
    }
    bool waits_for_writes() const { return clock_->has_interlocks(loop_); }
    std::size_t most_at_once(std::size_t most) const { return waits_for_writes() ? 1 : most; }

    /// Suspends the calling thread until there is a token of each.
    std::size_t at_hand() {
        std::size_t least = no_limit;
        timing::Ports before;
        each_of(in_, [&](auto& fifo) {
            least = std::min(least, fifo.peek(before));
            before = before | fifo.read_port();
        });
        return least;
    }
    template <class Call> auto with_tokens(Call call) {
        return std::apply([&](auto*... in) { return call((in != nullptr ? in->front() : nullptr)...); }, in_);
    }

    template <class Call> auto with_room(std::size_t count, Call call) {
        return std::apply([&](auto*... out) { return call((out != nullptr ? out->reserve(count) : nullptr)...); },
                          out_);
    }

    /// body(n, in..., out...) does up to n iterations, n at most `most`, and says how many. Returns that.
    template <class Body> [[gnu::always_inline]] std::size_t burst(std::size_t most, Body body) {
        std::size_t n = std::min(at_hand(), most_at_once(most));
        if constexpr (sizeof...(Out) > 0)
            n = std::min(n, longest_burst);
        each_of(out_, [](auto& fifo) { fifo.await_room(); });
        // Room first: a FIFO that is read here as well may move its tokens for it.
        std::size_t const done = with_room(
            n, [&](auto*... out) { return with_tokens([&](auto const*... in) { return body(n, in..., out...); }); });
        each_of(out_, [done](auto& fifo) { fifo.commit(done); });
        clock_->await_writes(loop_);
        clock_->iterate(ports_, done);
        each_of(in_, [done](auto& fifo) { fifo.consume(done); });
        return done;
    }

    void tell(MixedIterations const& mix) {
        if (!waits_for_writes()) {
            clock_->iterate_mixed(ports_, mix.count, mix.seconds);
            return;
        }
        bool const has_second = mix.seconds != 0;
        clock_->await_writes(loop_, has_second);
        clock_->iterate(ports_, 1);
        if (!has_second)
            return;
        clock_->await_writes(loop_);
        clock_->iterate(timing::no_ports, 1);
    }

    ProcessClock* clock_ = nullptr;
    unsigned loop_ = 0;
    std::tuple<ClockedFifo<In>*...> in_;
    std::tuple<ClockedFifo<Out>*...> out_;
    timing::Ports ports_;
};

}  // namespace dataflow

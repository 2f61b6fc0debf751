#pragma once
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "channels/token_loop.hpp"

namespace dataflow {

/// FIFOs that every iteration of a loop accesses: see tokens_of().
template <class Inputs, class Outputs> class TokenPorts;

template <class... In, class... Out> class TokenPorts<Reads<In...>, Writes<Out...>> {
  public:
    using Inputs = std::tuple<ClockedFifo<In>*...>;
    using Outputs = std::tuple<ClockedFifo<Out>*...>;
    TokenPorts(Inputs const& in, Outputs const& out) : in_(in), out_(out) {}

    TokenLoop<Reads<In...>, Writes<Out...>> loop(ProcessClock& clock, std::string_view name) const {
        TokenLoop<Reads<In...>, Writes<Out...>> loop;
        std::apply([&](auto*... fifos) { loop.connect(clock, name, fifos...); }, std::tuple_cat(in_, out_));
        return loop;
    }
    /// An iteration that reads the FIFOs, calls `body`, and writes them: what it returns is whether more follow.
    template <class Body> auto by_plain_accesses(ProcessClock& clock, Body& body) const {
        return [this, &clock, &body](std::uint64_t iteration) {
            std::tuple<In...> in = std::apply([](auto*... fifo) { return std::tuple<In...>{fifo->read()...}; }, in_);
            std::tuple<Out...> out;
            auto const tokens = std::tuple_cat(references_to(std::as_const(in)), references_to(out));
            bool goes_on = true;
            clock.in_tokens_body([&] {
                goes_on = std::apply([&](auto&... token) { return go_on(body, iteration, token...); }, tokens);
            });
            std::apply([&](auto*... fifo) { std::apply([&](auto&... token) { (fifo->write(token), ...); }, out); },
                       out_);
            return goes_on;
        };
    }

  private:
    template <class Tokens> static auto references_to(Tokens& tokens) {
        return std::apply([](auto&... token) { return std::tie(token...); }, tokens);
    }
    template <class Body, class... Tokens> static bool go_on(Body& body, std::uint64_t iteration, Tokens&... tokens) {
        if constexpr (std::is_same_v<decltype(call_iteration(body, iteration, tokens...)), bool>) {
            return call_iteration(body, iteration, tokens...);
        } else {
            call_iteration(body, iteration, tokens...);
            return true;
        }
    }

    Inputs in_;
    Outputs out_;
};

template <class Token> std::tuple<ClockedFifo<Token>*> input_of(sc_core::sc_fifo_in<Token>& port) {
    return {&channel_of(port)};
}
template <class Token> std::tuple<> input_of(sc_core::sc_fifo_out<Token>& /*port*/) { return {}; }
template <class Token> std::tuple<ClockedFifo<Token>*> output_of(sc_core::sc_fifo_out<Token>& port) {
    return {&channel_of(port)};
}
template <class Token> std::tuple<> output_of(sc_core::sc_fifo_in<Token>& /*port*/) { return {}; }

template <class... In, class... Out>
TokenPorts<Reads<In...>, Writes<Out...>> token_ports(std::tuple<ClockedFifo<In>*...> const& in,
                                                     std::tuple<ClockedFifo<Out>*...> const& out) {
    return {in, out};
}

/// The tokens of a module's ports, plain SystemC ones bound to clocked FIFOs: one of each per iteration of a loop. See
/// ProcessClock::pipeline(). Errors: std::bad_cast if a port is bound to any other kind of channel.
template <class... Ports> auto tokens_of(Ports&... ports) {
    return token_ports(std::tuple_cat(input_of(ports)...), std::tuple_cat(output_of(ports)...));
}

}  // namespace dataflow

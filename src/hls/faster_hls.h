#pragma once
// The wrapper of a loop. It stands first in the loop's body, where the tool wants its pragma, and takes its place:
//
//     for (int i = 0; i < n; ++i) {
//         FASTER_PIPELINE(scale, 1);       // #pragma HLS PIPELINE II=1
//         out.write(3 * in.read());
//     }
//
//   FASTER_PIPELINE(NAME, II)          a pipelined loop
//   FASTER_PIPELINE(NAME, II, DEPTH)   and its stages, if they are known; 2 otherwise
//   FASTER_LOOP(NAME, STATES)          a loop that is not pipelined, and the states of an iteration
//   FASTER_STATES(NAME, STATES)        at the head of a block, which is no loop: it takes so many states
//
// For a tool, or with FASTER_UNTIMED defined, only the pragma is left.
#include <hls_stream.h>

#define FASTER_PRAGMA(...) _Pragma(#__VA_ARGS__)

#if defined(FASTER_HLS_STREAM) && !defined(FASTER_UNTIMED) && !defined(__SYNTHESIS__)
#define FASTER_LOOP_MARK(name, ii, depth, is_pipelined)                                                     \
    static constexpr ::dataflow::untimed::LoopMark faster_mark_of_##name{#name,        ii,       depth,     \
                                                                         is_pipelined, __FILE__, __LINE__}; \
    ::dataflow::untimed::Iteration const faster_iteration_of_##name(faster_mark_of_##name)
#define FASTER_PIPELINE_2(name, ii) FASTER_LOOP_MARK(name, ii, 2, true)
#define FASTER_PIPELINE_3(name, ii, depth) FASTER_LOOP_MARK(name, ii, depth, true)
#define FASTER_LOOP(name, states) FASTER_LOOP_MARK(name, states, states, false)
#define FASTER_STATES(name, states) FASTER_LOOP_MARK(name, 0, states, false)
#else
// NOLINTBEGIN(bugprone-macro-parentheses): the tool's pragma takes a number
#define FASTER_PIPELINE_2(name, ii) FASTER_PRAGMA(HLS PIPELINE II = ii)
#define FASTER_PIPELINE_3(name, ii, depth) FASTER_PRAGMA(HLS PIPELINE II = ii)
// NOLINTEND(bugprone-macro-parentheses)
#define FASTER_LOOP(name, states) FASTER_PRAGMA(HLS PIPELINE off)
#define FASTER_STATES(name, states)
#endif
#define FASTER_PIPELINE_CHOICE(name, ii, depth, choice, ...) choice
#define FASTER_PIPELINE(...) \
    FASTER_PIPELINE_CHOICE(__VA_ARGS__, FASTER_PIPELINE_3, FASTER_PIPELINE_2, none)(__VA_ARGS__)

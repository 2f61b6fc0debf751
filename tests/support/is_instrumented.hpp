#pragma once

namespace faster::test {

/// By a sanitizer, whose memory and time are not ours.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_instrumented = true;
#else
constexpr bool is_instrumented = false;
#endif

}  // namespace faster::test

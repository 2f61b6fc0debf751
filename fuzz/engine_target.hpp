#pragma once
#include <string_view>

namespace faster::fuzz {

/// The first 8 bytes are the seed of a random machine, a small random trace, and another timing for it. Both engines
/// run it, and what-if gives the recorded run the other timing, which is run as well. Throws std::logic_error if two of
/// these that should agree do not.
void run_engine(std::string_view bytes);

/// An event file of a small run, of which the bytes change header, index and samples, sealed again behind its
/// checksums: read, and timed once more. The bytes are changes, each a part (1 byte), a place (2 bytes), the number of
/// bytes that go (1 byte), of those that come (1 byte), and these.
void run_events(std::string_view bytes);

}  // namespace faster::fuzz

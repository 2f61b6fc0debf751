#pragma once
#include <string>
#include <string_view>

namespace dataflow {

/// Text from outside as it may stand on one line of a terminal or a page: valid UTF-8 without anything that moves the
/// cursor, changes colours or the order of reading, or cannot be seen (a no-break space). Such characters, and bytes
/// that are no UTF-8, are escaped: \n, \x1b, \u202e. A text without them stays as it is.
std::string printable(std::string_view text);

/// A text of several lines as it may stand on a terminal or a page: as printable(), but line ends and tabs stay.
std::string printable_lines(std::string_view text);

/// A name or a value from outside for a message: printable(), and cut after 80 characters or so.
std::string shortened(std::string_view text);

/// A whole message: printable(), on one line, and of bounded length whatever stands in it. Overlong words, and then an
/// overlong whole, lose their middle, since the begin names the file and the end says what was expected.
std::string message_line(std::string_view text);

}  // namespace dataflow

#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace faster::files {

/// A decimal number, which is the whole word: with or without sign, point and exponent, also nan and inf. What is too
/// large for a double is infinite, what is too small is 0.
std::optional<double> number_in(std::string_view word);

/// A number without a fraction, which may be written with a point.
std::optional<std::int64_t> integer_in(std::string_view word);

/// The words of a mesh file, line by line. Lines end in \n, \r\n or \r; words are parted by blanks; a # and what
/// follows it on its line is a comment.
class MeshText {
  public:
    /// `text` has to outlive this; its first line has number `first_line`.
    MeshText(std::filesystem::path path, std::string_view text, std::size_t first_line = 1);

    /// From now on a \ at the end of a line continues it.
    void join_lines() { joins_lines_ = true; }

    /// Moves to the next line; false if there is none.
    bool next_line();

    /// Moves to the next line that has a word; false if there is none.
    bool next_line_of_words();

    /// The next word of the line; empty at its end.
    std::string_view word();

    /// The next word of this line or a later one. Fails at the end of the text.
    std::string_view word_of_row();

    /// Three numbers, the next words of the line or, with word_of_row(), of later ones too; of the vertex with this
    /// number. Fails if they are none.
    Eigen::Vector3d coordinates(std::size_t vertex, std::string_view (MeshText::*next)() = &MeshText::word);

    /// The number of the line, from 1.
    std::size_t line() const { return line_; }

    /// "path:line".
    std::string place() const;

    /// Throws InputError "path:line: what".
    [[noreturn]] void fail(std::string const& what) const;

    /// Throws InputError: the text ends where it must not.
    [[noreturn]] void fail_at_end() const;

  private:
    void skip_blanks();
    void skip_line_end();
    bool takes_continuation();

    std::filesystem::path path_;
    std::string_view rest_;  ///< from the next word of the line on
    std::size_t line_;
    bool joins_lines_ = false;
    bool is_before_first_ = true;
};

}  // namespace faster::files

#pragma once
#include <algorithm>
#include <cstdint>

namespace dataflow::timing {

/// Decides whether new phrases are cut into pieces. That pays unless most of the pieces are new themselves, as where
/// followers may be ahead by this or that much, which makes many states within phrases. Tried again from time to time.
class CutTrial {
  public:
    /// Whether the next phrase is to be cut.
    bool decide() {
        if (new_pieces_ > most_new_pieces)
            end(std::min(4 * patience_, most_patience));
        else if (phrases_ == length)
            end(0);
        if (left_whole_ > 0) {
            --left_whole_;
            return false;
        }
        ++phrases_;
        return true;
    }
    void worked_out_piece() { ++new_pieces_; }

    static constexpr std::uint32_t length = 64;  // phrases of a trial
    static constexpr std::uint32_t most_new_pieces = 2 * length;
    static constexpr std::uint32_t most_patience = 64;

  private:
    /// The next trial begins after that many times the length of one.
    void end(std::uint32_t patience) {
        patience_ = std::max(patience, 1U);
        left_whole_ = patience * length;
        phrases_ = new_pieces_ = 0;
    }

    std::uint32_t phrases_ = 0;
    std::uint32_t new_pieces_ = 0;  ///< of them
    std::uint32_t left_whole_ = 0;  ///< phrases not to be cut
    std::uint32_t patience_ = 1;
};

}  // namespace dataflow::timing

#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace dataflow::timing {

/// Keeps lists of words, which stay where they are.
template <class Word> class WordArena {
  public:
    Word const* keep(Word const* words, std::size_t count) {
        if (left_ < count) {
            left_ = std::max(usual_chunk, count);
            chunks_.emplace_back(new Word[left_]);
            free_ = chunks_.back().get();
        }
        Word const* const kept = free_;
        std::copy(words, words + count, free_);
        free_ += count;
        left_ -= count;
        return kept;
    }

  private:
    static constexpr std::size_t usual_chunk = std::size_t{1} << 14;

    std::vector<std::unique_ptr<Word[]>> chunks_;
    Word* free_ = nullptr;  ///< of the last chunk
    std::size_t left_ = 0;
};

}  // namespace dataflow::timing

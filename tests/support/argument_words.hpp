#pragma once
#include <string>
#include <vector>

namespace faster::test {

/// A program and its arguments as execv() wants them.
class ArgumentWords {
  public:
    ArgumentWords(std::string const& program, std::vector<std::string> const& arguments) : words_{program} {
        words_.insert(words_.end(), arguments.begin(), arguments.end());
        for (std::string& word : words_)
            pointers_.push_back(word.data());
        pointers_.push_back(nullptr);
    }
    ArgumentWords(ArgumentWords const&) = delete;
    ArgumentWords& operator=(ArgumentWords const&) = delete;

    char* const* pointers() const { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

}  // namespace faster::test

#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace faster::fuzz {

/// Makes new inputs of older ones by small changes, blindly: it does not know what code they reach, as libFuzzer does.
/// The same seed gives the same inputs.
class Mutator {
  public:
    /// `inputs`: at least one.
    Mutator(std::vector<std::string> inputs, std::uint64_t seed);

    /// One of the inputs with one to eight changes, at most 64 KiB long.
    std::string next();

  private:
    std::size_t below(std::size_t bound);  // 0 if bound is 0
    std::string const& any_input();
    std::string any_part();
    void change(std::string& bytes);

    std::vector<std::string> inputs_;
    std::mt19937_64 random_;
};

}  // namespace faster::fuzz

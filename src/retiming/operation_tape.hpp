#pragma once
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "timing/operation.hpp"

namespace faster::retiming {

/// What the processes of one core do, operation by operation, in rounds: a round holds what each of them has said since
/// the last. Says nothing about time, so that any timing can be put to it. Kept in a temporary file; may be read by
/// several threads at once. Errors: InputError if there is no room for it.
class OperationTape {
  public:
    /// Appends the operations of a log to the round at hand.
    void put(std::size_t process, timing::OperationLog const& log);
    void end_round();
    /// Nothing is put any more.
    void finish();

    std::size_t rounds() const { return round_ends_.size(); }
    /// Calls `visit(process, operations)` for each part of a round.
    template <class Visit> void read_round(std::size_t round, Visit visit) const {
        std::vector<timing::Operation> operations;
        for (std::size_t i = round == 0 ? 0 : round_ends_[round - 1]; i < round_ends_[round]; ++i) {
            read(parts_[i], operations);
            visit(parts_[i].process, operations);
        }
    }

  private:
    struct Part {
        std::size_t process;
        std::uint64_t first;  ///< operation in the file
        std::uint64_t count;
    };
    struct Closer {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    void read(Part const& part, std::vector<timing::Operation>& operations) const;

    std::unique_ptr<std::FILE, Closer> file_;
    std::uint64_t written_ = 0;
    std::vector<Part> parts_;
    std::vector<std::size_t> round_ends_;  // numbers of parts
};

}  // namespace faster::retiming

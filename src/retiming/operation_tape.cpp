#include "retiming/operation_tape.hpp"

#include <cerrno>
#include <cstring>
#include <string>
#include <unistd.h>

#include "common/input_error.hpp"

namespace faster::retiming {

namespace {
[[noreturn]] void fail(char const* what) {
    throw InputError(std::string("temporary file of operations: cannot ") + what + ": " + std::strerror(errno) +
                     ", expected room in the system's folder for temporary files");
}
}  // namespace

void OperationTape::put(std::size_t process, timing::OperationLog const& log) {
    std::size_t const count = log.pending();
    if (count == 0)
        return;
    if (file_ == nullptr)
        file_.reset(std::tmpfile());
    if (file_ == nullptr)
        fail("create it");
    if (std::fwrite(log.begin(), sizeof(timing::Operation), count, file_.get()) != count)
        fail("write it");
    parts_.push_back({process, written_, count});
    written_ += count;
}

void OperationTape::end_round() {
    if (parts_.size() > (round_ends_.empty() ? 0 : round_ends_.back()))
        round_ends_.push_back(parts_.size());
}

void OperationTape::finish() {
    end_round();
    if (file_ != nullptr && std::fflush(file_.get()) != 0)
        fail("write it");
}

void OperationTape::read(Part const& part, std::vector<timing::Operation>& operations) const {
    operations.resize(part.count);
    auto* to = reinterpret_cast<char*>(operations.data());
    std::size_t left = part.count * sizeof(timing::Operation);
    auto at = static_cast<off_t>(part.first * sizeof(timing::Operation));
    while (left > 0) {
        ssize_t const count = pread(fileno(file_.get()), to, left, at);
        if (count <= 0)
            fail("read it");
        to += count;
        at += count;
        left -= static_cast<std::size_t>(count);
    }
}

}  // namespace faster::retiming

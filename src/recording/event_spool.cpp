#include "recording/event_spool.hpp"

#include <cerrno>
#include <cstring>

#include "common/input_error.hpp"

namespace faster::recording {

namespace {
[[noreturn]] void fail(char const* what) {
    throw InputError(std::string("temporary file of a recording: cannot ") + what + ": " + std::strerror(errno) +
                     ", expected room in the system's folder for temporary files");
}
}  // namespace

void EventSpool::put(Event const& event) {
    buffer_.push_back(event);
    if (buffer_.size() == most_in_memory)
        spill();
}

void EventSpool::spill() {
    if (file_ == nullptr)
        file_.reset(std::tmpfile());
    if (file_ == nullptr)
        fail("create it");
    if (std::fwrite(buffer_.data(), sizeof(Event), buffer_.size(), file_.get()) != buffer_.size())
        fail("write it");
    buffer_.clear();
}

void EventSpool::rewind() {
    if (file_ == nullptr)
        return;
    last_.swap(buffer_);
    std::rewind(file_.get());
    reads_file_ = true;
}

bool EventSpool::refill() {
    next_ = 0;
    if (reads_file_) {
        buffer_.resize(most_in_memory);
        buffer_.resize(std::fread(buffer_.data(), sizeof(Event), most_in_memory, file_.get()));
        if (!buffer_.empty())
            return true;
        reads_file_ = false;
        buffer_.swap(last_);
        return !buffer_.empty();
    }
    buffer_.clear();
    return false;
}

bool EventSpool::get(Event& event) {
    if (next_ == buffer_.size() && !refill())
        return false;
    event = buffer_[next_++];
    return true;
}

}  // namespace faster::recording

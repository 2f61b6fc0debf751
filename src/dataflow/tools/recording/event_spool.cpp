#include "dataflow/tools/recording/event_spool.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "dataflow/base/input_error.hpp"

namespace dataflow::recording {

namespace {
[[noreturn]] void fail(char const* what) {
    throw HostError(std::string("temporary file of a recording: cannot ") + what + ": " + std::strerror(errno) +
                    ", expected room in the system's folder for temporary files");
}

/// A number in four bits: the item itself follows.
constexpr std::uint32_t large_item = 0xF;

/// Small numbers of either sign become small numbers without.
std::uint64_t folded(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}
std::int64_t unfolded(std::uint64_t number) {
    return static_cast<std::int64_t>(number >> 1) ^ -static_cast<std::int64_t>(number & 1U);
}
}  // namespace

void EventSpool::put(Event const& event) {
    if (at_ == nullptr) {
        buffer_.resize(buffer_size);
        at_ = buffer_.data();
        end_ = at_ + buffer_size;
    }
    if (end_ - at_ < static_cast<std::ptrdiff_t>(longest_event))
        spill();
    unsigned const item = std::min(event.item, large_item);
    *at_++ = static_cast<std::uint8_t>(static_cast<unsigned>(event.kind) << 4 | item);
    if (item == large_item)
        put_number(event.item);
    put_number(folded(static_cast<std::int64_t>(event.cycle - cycle_)));
    put_number(folded(event.value));
    if (event.kind == Event::Kind::iterate) {
        put_number(event.count);
        put_number(event.stride);
    }
    cycle_ = event.cycle;
}

void EventSpool::spill() {
    if (file_ == nullptr)
        file_.reset(std::tmpfile());
    if (file_ == nullptr)
        fail("create it");
    auto const size = static_cast<std::size_t>(at_ - buffer_.data());
    if (std::fwrite(buffer_.data(), 1, size, file_.get()) != size)
        fail("write it");
    at_ = buffer_.data();
}

void EventSpool::rewind() {
    cycle_ = 0;
    end_ = at_;
    at_ = buffer_.data();
    if (file_ == nullptr)
        return;
    last_.assign(at_, end_);
    end_ = at_;
    std::rewind(file_.get());
}

/// Moves what is left to the front, and reads on: first the file, then what was put after it.
void EventSpool::refill() {
    auto const left = static_cast<std::size_t>(end_ - at_);
    std::memmove(buffer_.data(), at_, left);
    at_ = buffer_.data();
    end_ = at_ + left;
    std::size_t const read = std::fread(end_, 1, buffer_size - left, file_.get());
    if (std::ferror(file_.get()) != 0)
        fail("read it");
    end_ += read;
    if (read > 0)
        return;
    buffer_.insert(buffer_.begin() + static_cast<std::ptrdiff_t>(left), last_.begin(), last_.end());
    at_ = buffer_.data();
    end_ = at_ + left + last_.size();
    file_.reset();
}

bool EventSpool::get(Event& event) {
    if (file_ != nullptr && end_ - at_ < static_cast<std::ptrdiff_t>(longest_event))
        refill();
    if (at_ == end_)
        return false;
    std::uint8_t const head = *at_++;
    event.kind = static_cast<Event::Kind>(head >> 4);
    event.item = head & large_item;
    if (event.item == large_item)
        event.item = static_cast<std::uint32_t>(get_number());
    cycle_ += static_cast<Cycles>(unfolded(get_number()));
    event.cycle = cycle_;
    event.value = unfolded(get_number());
    bool const iterates = event.kind == Event::Kind::iterate;
    event.count = iterates ? get_number() : 0;
    event.stride = iterates ? static_cast<std::uint32_t>(get_number()) : 0;
    return true;
}

}  // namespace dataflow::recording

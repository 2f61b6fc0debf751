#include "dataflow/core/time/ports.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <stdexcept>

namespace dataflow::timing {

namespace {

/// Those that are no masks. What is in it stays, so that reading needs no lock.
class KeptSets {
  public:
    static KeptSets& of_program() {
        static KeptSets sets;
        return sets;
    }

    Ports::Number number_of(std::vector<unsigned> const& ports) {
        std::lock_guard<std::mutex> const lock(mutex_);
        auto const [place, is_new] = numbers_.emplace(ports, next_);
        if (!is_new)
            return place->second;
        if (next_ == Ports::numbers) {
            numbers_.erase(place);
            throw std::logic_error("more than 1792 different sets of ports, with others than the first eight in them");
        }
        lists_.at(next_ - Ports::masks) = &place->first;
        return next_++;
    }
    bool has_room_for(std::vector<unsigned> const& ports) {
        constexpr Ports::Number reserved = 256;  // for the program itself
        std::lock_guard<std::mutex> const lock(mutex_);
        return next_ < Ports::numbers - reserved || numbers_.count(ports) != 0;
    }
    bool knows(std::uint64_t number) const {
        return number < Ports::numbers && lists_[static_cast<std::size_t>(number) - Ports::masks] != nullptr;
    }
    std::vector<unsigned> const& operator[](Ports::Number number) const {
        return *lists_.at(static_cast<std::size_t>(number) - Ports::masks).load();
    }

  private:
    std::mutex mutex_;
    std::map<std::vector<unsigned>, Ports::Number> numbers_;
    std::array<std::atomic<std::vector<unsigned> const*>, Ports::numbers - Ports::masks> lists_{};
    Ports::Number next_ = Ports::masks;
};

}  // namespace

Ports Ports::of(std::vector<unsigned> const& ports) {
    std::vector<unsigned> sorted = ports;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (!sorted.empty() && sorted.back() >= in_masks)
        return kept(sorted);
    unsigned mask = 0;
    for (unsigned const port : sorted)
        mask |= 1U << port;
    return Ports(static_cast<Number>(mask));
}

bool Ports::has_room_for(std::vector<unsigned> const& ports) {
    return ports.back() < in_masks || KeptSets::of_program().has_room_for(ports);
}

bool Ports::is_known(std::uint64_t number) { return number < masks || KeptSets::of_program().knows(number); }

bool Ports::has(unsigned port) const {
    if (is_mask(number_))
        return port < in_masks && ((number_ >> port) & 1U) != 0;
    std::vector<unsigned> const& ports = list(number_);
    return std::binary_search(ports.begin(), ports.end(), port);
}

Ports Ports::kept(std::vector<unsigned> const& ports) { return Ports(KeptSets::of_program().number_of(ports)); }

Ports Ports::joined(Ports one, Ports other) {
    std::vector<unsigned> ports;
    for (Ports const& set : {one, other})
        set.each([&ports](unsigned port) { ports.push_back(port); });
    return of(ports);
}

std::vector<unsigned> const& Ports::list(Number number) { return KeptSets::of_program()[number]; }

}  // namespace dataflow::timing

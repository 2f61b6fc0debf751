#include <stdexcept>

#include "tb/cosim/twin_core.hpp"

namespace faster::rtl {

bool has_twin() { return false; }

std::unique_ptr<TwinCore> make_twin(TwinSettings const&, Stimulus const&, std::size_t, std::size_t) {
    throw std::logic_error("there is no twin: built without Verilator");
}

}  // namespace faster::rtl

#include "channels/own_stack.hpp"

#include <cstddef>
#include <pthread.h>

extern "C" {  // of <sanitizer/common_interface_defs.h>; null in a program without sanitizer
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the sanitizer's names
[[gnu::weak]] void __sanitizer_start_switch_fiber(void** saved, void const* bottom, std::size_t size);
[[gnu::weak]] void __sanitizer_finish_switch_fiber(void* saved, void const** bottom, std::size_t* size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}

namespace dataflow {

void back_on_own_stack() {
    if (__sanitizer_start_switch_fiber == nullptr)
        return;
    pthread_attr_t attributes;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0)
        return;
    void* bottom = nullptr;
    std::size_t size = 0;
    pthread_attr_getstack(&attributes, &bottom, &size);
    pthread_attr_destroy(&attributes);
    void* saved = nullptr;
    __sanitizer_start_switch_fiber(&saved, bottom, size);
    __sanitizer_finish_switch_fiber(saved, nullptr, nullptr);
}

}  // namespace dataflow

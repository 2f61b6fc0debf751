#include "functions.hpp"

#include <faster_hls.h>

void reader(hls::stream<std::uint32_t>& number, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(fetch, 1, 3);
        number.write(i);
    }
}

void scaler(hls::stream<std::uint32_t>& number, hls::stream<std::uint32_t>& product, unsigned numbers) {
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(scale, 2, 4);
        product.write(3 * number.read());
    }
}

std::uint32_t writer(hls::stream<std::uint32_t>& product, unsigned numbers) {
    std::uint32_t sum = 0;
    for (unsigned i = 0; i < numbers; ++i) {
        FASTER_PIPELINE(store, 1);
        sum += product.read();
    }
    return sum;
}

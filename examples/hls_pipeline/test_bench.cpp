// C simulation: the functions as plain C++, as the HLS tool runs them first.
#include <cstdio>

#include "functions.hpp"

int main() {
    unsigned const count = 1000;
    hls::stream<std::uint32_t> number("number");
    hls::stream<std::uint32_t> product("product");
    reader(number, count);
    scaler(number, product, count);
    std::uint32_t const sum = writer(product, count);
    std::printf("sum %u\n", sum);
    return sum == 3 * (count * (count - 1) / 2) && product.empty() ? 0 : 1;
}

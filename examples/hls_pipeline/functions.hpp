// What goes through the HLS tool: three functions over streams.
#pragma once
#include <cstdint>
#include <hls_stream.h>

void reader(hls::stream<std::uint32_t>& number, unsigned numbers);
void scaler(hls::stream<std::uint32_t>& number, hls::stream<std::uint32_t>& product, unsigned numbers);
std::uint32_t writer(hls::stream<std::uint32_t>& product, unsigned numbers);

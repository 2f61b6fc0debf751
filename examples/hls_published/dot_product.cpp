// VecDotProduct of the public RL-SOC-Tutorial-Vitis as functions: two readers, a multiplier, a tree of adders, an
// accumulator and a writer. A word of its streams is 16 numbers.
#include <array>
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

struct Row {
    std::array<std::int32_t, 16> numbers;
};
using Rows = hls::stream<Row, 16>;
using Numbers32 = hls::stream<std::int32_t, 16>;

void read_rows(Rows& out, int rows, int factor) {
    for (int i = 0; i < rows; ++i) {
        FASTER_PIPELINE(read, 1, 3);
        Row row;
        for (int k = 0; k < 16; ++k)
            row.numbers[static_cast<std::size_t>(k)] = factor * ((i + k) % 8);
        out.write(row);
    }
}

void multiply_rows(Rows& a, Rows& b, Rows& products, int rows) {
    for (int i = 0; i < rows; ++i) {
        FASTER_PIPELINE(multiply, 1, 2);
        Row const left = a.read();
        Row const right = b.read();
        Row product;
        for (std::size_t k = 0; k < 16; ++k)
            product.numbers[k] = left.numbers[k] * right.numbers[k];
        products.write(product);
    }
}

void add_rows(Rows& products, Numbers32& sums, int rows) {
    for (int i = 0; i < rows; ++i) {
        FASTER_PIPELINE(add, 1, 3);
        std::int32_t sum = 0;
        for (std::int32_t const product : products.read().numbers)
            sum += product;
        sums.write(sum);
    }
}

void accumulate(Numbers32& sums, Numbers32& total, int rows) {
    std::int32_t sum = 0;
    for (int i = 0; i < rows; ++i) {
        FASTER_PIPELINE(accumulate, 1, 2);
        sum += sums.read();
    }
    total.write(sum);
}

void write_total(Numbers32& total, std::int32_t& out) {
    FASTER_STATES(answer, 19);  // its state, and those until the memory has answered
    out = total.read();
}

struct DotProduct : dataflow::HlsDesign {
    Rows a{"a"};
    Rows b{"b"};
    Rows products{"products"};
    Numbers32 sums{"sums"};
    Numbers32 total{"sum"};
    std::int32_t result = 0;

    explicit DotProduct(dataflow::Numbers const& numbers) {
        int const rows = static_cast<int>(numbers["workload.words"]);
        process("reader_a", [this, rows] { read_rows(a, rows, 1); });
        process("reader_b", [this, rows] { read_rows(b, rows, 2); });
        process("multiplier", [this, rows] { multiply_rows(a, b, products, rows); });
        process("tree", [this, rows] { add_rows(products, sums, rows); });
        process("accumulator", [this, rows] { accumulate(sums, total, rows); });
        process("writer", [this] { write_total(total, result); });
    }
    dataflow::Counters results() const override { return {static_cast<std::uint64_t>(result)}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_dot_product",
                {{"workload.words", 10'000, "Words of a vector."}},
                {{"sum", "-", dataflow::Tells::result, "of all products"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(DotProduct, "Six processes that multiply and add up")

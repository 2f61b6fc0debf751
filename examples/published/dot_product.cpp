// Six processes in a row, the first two side by side: VecDotProduct of the public RL-SOC-Tutorial-Vitis. A reader's
// loop begins behind the states that ask for a burst, and behind the latency of the memory.
#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

using Word = std::uint64_t;
char const* const latency_key = "accelerator.memory_read_latency";
char const* const answer_key = "accelerator.memory_write_answer";

/// One that moves words, a loop iteration each.
class Mover : public SimpleModule {
  public:
    Mover(char const* name, SimpleCore& core) : SimpleModule(name, core), core_(core) {}

  protected:
    ClockedFifo<Word>& fifo(char const* name) const { return core_.fifo<Word>(name); }
    std::uint64_t words() const { return number("workload.words"); }

  private:
    SimpleCore& core_;
};

class Reader : public Mover {
  public:
    static ModuleDescription describe(std::string const& name, std::string const& fifo) {
        ModuleDescription module(name);
        module.writes_to(fifo).carries("words of the memory").of_bits(512).leaves("read", 2);
        module.loop("read").does("reads one word per iteration").of_depth(3);
        return module;
    }
    Reader(char const* name, SimpleCore& core, char const* out) : Mover(name, core), out_(out) {}

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1 + 7 + number(latency_key));
        clock_.pipeline("read", words(), [&](std::uint64_t i) { fifo(out_).write(i); });
    }
    char const* out_;
};

class Multiplier : public Mover {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("multiplier");
        module.reads_from("a").taken("multiply", 1);
        module.reads_from("b").taken("multiply", 1);
        module.writes_to("products").carries("products").of_bits(512).leaves("multiply", 1);
        module.loop("multiply").does("multiplies words").of_depth(2);
        return module;
    }
    using Mover::Mover;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1);
        clock_.pipeline("multiply", words(),
                        [&](std::uint64_t) { fifo("products").write(fifo("a").read() * fifo("b").read()); });
    }
};

class Tree : public Mover {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("tree");
        module.reads_from("products").taken("add", 1);
        module.writes_to("sums").carries("sums of the products of a word").of_bits(32).leaves("add", 2);
        module.loop("add").does("adds up the products of a word").of_depth(3);
        return module;
    }
    using Mover::Mover;

  private:
    void work(std::size_t /*sample*/) override {
        clock_.advance(1);
        clock_.pipeline("add", words(), [&](std::uint64_t) { fifo("sums").write(fifo("products").read()); });
    }
};

class Accumulator : public Mover {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("accumulator");
        module.reads_from("sums").taken("accumulate", 1);
        module.loop("accumulate").does("adds up sums").of_depth(2);
        module.writes_to("sum").carries("the sum").of_bits(32);
        return module;
    }
    using Mover::Mover;

  private:
    void work(std::size_t /*sample*/) override {
        Word sum = 0;
        clock_.advance(1);
        clock_.pipeline("accumulate", words(), [&](std::uint64_t) { sum += fifo("sums").read(); });
        fifo("sum").write(sum);
        clock_.advance(1);
    }
};

class Writer : public Mover {
  public:
    static ModuleDescription describe() {
        ModuleDescription module("writer");
        module.reads_from("sum");
        return module;
    }
    Writer(char const* name, SimpleCore& core) : Mover(name, core) {}

  private:
    void work(std::size_t /*sample*/) override {
        Word const sum = fifo("sum").read();
        clock_.advance(7 + number(answer_key));
        add_result({sum});
    }
};

class DotProduct : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        return core_of({Reader::describe("reader_a", "a"), Reader::describe("reader_b", "b"), Multiplier::describe(),
                        Tree::describe(), Accumulator::describe(), Writer::describe()});
    }
    explicit DotProduct(SimpleCoreParts const& parts) : SimpleCore(parts) {
        for (char const* const fifo : {"a", "b", "products", "sums", "sum"})
            make_fifo<Word>(fifo);
    }

  private:
    Reader reader_a_{"reader_a", *this, "a"};
    Reader reader_b_{"reader_b", *this, "b"};
    Multiplier multiplier_{"multiplier", *this};
    Tree tree_{"tree", *this};
    Accumulator accumulator_{"accumulator", *this};
    Writer writer_{"writer", *this};
};

SimpleSimulation<DotProduct> const& dot_product() {
    static SimpleSimulation<DotProduct> const one(
        {"dot_product",
         {{"workload.words", 10'000, "Words of a vector."},
          {latency_key, 64, "Cycles from asking the memory for a burst to its first word.", {0, 1'000'000}},
          {answer_key, 12, "Cycles from the last word written to the memory's answer.", {0, 1'000'000}}},
         {{"sum", "-", Tells::result, "of all products"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return dot_product(); }
SimulatedDesign const& dataflow::simulated_design() { return dot_product(); }

int sc_main(int argc, char** argv) {
    return run_tool({"dot_product", "Six processes that multiply and add up", "1.0"}, standard_commands(), argc, argv);
}

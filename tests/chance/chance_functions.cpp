#include "chance/chance_functions.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace faster::chance {

namespace {

/// What a function has still to do, and does, a random part at a time.
class FunctionMaker {
  public:
    FunctionMaker(Design& design, std::size_t number, std::vector<std::uint64_t> const& tokens, std::mt19937_64& dice)
        : process_(design.processes[number]), dice_(dice) {
        for (std::size_t fifo = 0; fifo < design.fifos.size(); ++fifo)
            if (design.fifos[fifo].writer == number || design.fifos[fifo].reader == number)
                left_.push_back({fifo, tokens[fifo]});
    }

    void make() {
        std::size_t const loops = below(4);
        for (std::size_t i = 0; i < loops; ++i)
            add_loop("loop" + std::to_string(i));
        while (has_more())
            below(4) == 0 || loops == 0 ? add_access() : add_run(below(loops));
        remove_unused_loops();
        begin();
    }

  private:
    struct Left {
        std::size_t fifo;
        std::uint64_t tokens;
    };

    std::uint64_t below(std::uint64_t end) { return dice_() % end; }
    bool has_more() const {
        return std::any_of(left_.begin(), left_.end(), [](Left const& one) { return one.tokens > 0; });
    }

    void add_loop(std::string name) {
        Loop loop;
        loop.name = std::move(name);
        loop.depth = 1 + below(6);
        loop.is_pipelined = below(2) == 0;
        if (loop.is_pipelined)
            loop.ii = 1 + below(3);
        else if (below(2) == 0)
            loop.entry = loop.exit = 1;
        process_.loops.push_back(loop);
    }
    /// Of those without states around them an iteration is a block of its own.
    bool is_block(std::size_t loop) const {
        return !process_.loops[loop].is_pipelined && process_.loops[loop].entry == 0;
    }

    void add_access() {
        std::size_t const first = below(left_.size());
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (Left& one = left_[(first + i) % left_.size()]; one.tokens > 0) {
                --one.tokens;
                Segment segment;
                segment.kind = Segment::Kind::step;
                segment.step = {one.fifo};
                note(segment.step);
                process_.program.push_back(segment);
                return;
            }
    }

    /// Iterations of a loop in which something else lies between are other entries of it.
    void add_run(std::size_t loop) {
        if (!process_.program.empty() && process_.program.back().kind == Segment::Kind::loop &&
            process_.program.back().loop == loop)
            return add_access();
        Segment segment;
        segment.kind = Segment::Kind::loop;
        segment.loop = loop;
        for (std::uint64_t i = is_block(loop) ? 1 : 1 + below(12); i > 0; --i)
            segment.iterations.push_back(iteration());
        process_.program.push_back(segment);
    }
    Accesses iteration() {
        Accesses accesses;
        for (Left& one : left_)
            if (one.tokens > 0 && below(3) > 0) {
                --one.tokens;
                accesses.push_back(one.fifo);
            }
        std::shuffle(accesses.begin(), accesses.end(), dice_);
        note(accesses);
        return accesses;
    }

    void remove_unused_loops() {
        for (std::size_t loop = process_.loops.size(); loop-- > 0;) {
            auto const is_of_it = [loop](Segment const& segment) {
                return segment.kind == Segment::Kind::loop && segment.loop == loop;
            };
            if (std::any_of(process_.program.begin(), process_.program.end(), is_of_it))
                continue;
            process_.loops.erase(process_.loops.begin() + static_cast<std::ptrdiff_t>(loop));
            for (Segment& segment : process_.program)
                segment.loop -= segment.kind == Segment::Kind::loop && segment.loop > loop ? 1U : 0U;
        }
    }

    /// The cycle in which a function starts, unless its first loop has a state for that.
    void begin() {
        Segment const& first = process_.program.front();
        if (first.kind == Segment::Kind::loop && process_.loops[first.loop].entry > 0)
            return;
        Segment start;
        start.cycles = 1;
        process_.program.insert(process_.program.begin(), start);
    }

    /// The description has the FIFOs in the order in which they are first accessed. Iterations keep it, so that it is
    /// clear which one a stuck process is said to wait for.
    void note(Accesses const& accesses) {
        for (std::size_t const fifo : accesses)
            if (place_of(fifo) == process_.ends.end())
                process_.ends.push_back(fifo);
    }
    Accesses::const_iterator place_of(std::size_t fifo) const {
        return std::find(process_.ends.begin(), process_.ends.end(), fifo);
    }

    Process& process_;
    std::mt19937_64& dice_;
    std::vector<Left> left_;
};

/// The last one, of several loops that of the shortest.
Cycles write_stage(Design const& design, std::size_t fifo) {
    Process const& process = design.processes[design.fifos[fifo].writer];
    Cycles depth = 0;
    for (Segment const& segment : process.program)
        for (Accesses const& iteration : segment.iterations)
            if (std::find(iteration.begin(), iteration.end(), fifo) != iteration.end())
                depth =
                    std::min(depth == 0 ? process.loops[segment.loop].depth : depth, process.loops[segment.loop].depth);
    return depth == 0 ? 0 : depth - 1;
}

}  // namespace

Design random_functions(std::uint64_t seed) {
    std::mt19937_64 dice(seed);
    auto const below = [&dice](std::uint64_t end) { return dice() % end; };
    Design design;
    design.samples = 1 + below(4);
    design.cores = 1 + below(2);
    design.calls = below(3) == 0 ? CallOrder::in_turn : CallOrder::overlapped;
    design.processes.resize(2 + below(4));
    std::vector<std::uint64_t> tokens;
    auto const connect = [&](std::size_t writer, std::size_t reader) {
        Fifo fifo;
        fifo.name = "stream" + std::to_string(design.fifos.size());
        fifo.writer = writer;
        fifo.reader = reader;
        fifo.depth = 1 + below(below(2) == 0 ? 3 : 40);
        design.fifos.push_back(fifo);
        tokens.push_back(1 + below(20));
    };
    for (std::size_t i = 1; i < design.processes.size(); ++i)
        connect(below(i), i);
    for (std::uint64_t more = below(4); more > 0; --more) {
        std::size_t const reader = 1 + below(design.processes.size() - 1);
        connect(below(reader), reader);
    }
    for (std::size_t i = 0; i < design.processes.size(); ++i) {
        design.processes[i].name = "function" + std::to_string(i);
        design.processes[i].starts = below(3) == 0 ? below(5) : 0;
        FunctionMaker(design, i, tokens, dice).make();
    }
    for (std::size_t fifo = 0; fifo < design.fifos.size(); ++fifo)
        design.fifos[fifo].write_stage = write_stage(design, fifo);
    return design;
}

}  // namespace faster::chance

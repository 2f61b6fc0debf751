#include "retiming/scripted_run.hpp"

#include "modules/core_shapes.hpp"
#include "timing/phrase_cutter.hpp"

namespace faster::retiming {

namespace {

using timing::Group;
using timing::Operation;
using timing::OperationLog;
using timing::Phrase;

constexpr std::size_t most_phrases = std::size_t{1} << 26;

/// Cuts samples on a core whose processes' logs hold what is left to be cut.
class SampleCutter {
  public:
    SampleCutter(RecordedRun const& run, Parts const& parts, timing::PhraseBook& book)
        : run_(run),
          core_(run.blueprint->blank_copy()),
          group_(*core_, rasterizer_and_followers(parts)),
          phrase_cutter_(*core_, rasterizer_and_followers(parts)),
          book_(book) {}

    ScriptedSample cut(std::size_t sample) {
        ScriptedSample cut;
        run_.tape.read(sample, *core_, cut.before);
        cut.after.resize(cut.before.size());
        for (unsigned m = 0; m < group_.members().size(); ++m)
            if (m != group_.supplier())
                open(m, cut);
        open_driver(cut);
        while (phrase_.read(group_, 1U << group_.supplier()) == Phrase::Reading::complete) {
            cut.phrases.push_back(number_of_phrase());
            cut.script.due += book_[cut.phrases.back()].due;
            phrase_.consume();
        }
        for (unsigned m = 0; m < group_.members().size(); ++m)
            if (m != group_.supplier())
                close(m, cut);
        return cut;
    }

  private:
    timing::PhraseBook::Number number_of_phrase() {
        std::size_t const known = book_.size();
        timing::PhraseBook::Number const number = book_.number_of(phrase_, group_);
        if (number >= known)
            phrase_cutter_.cut(book_, number);
        return number;
    }

    OperationLog& log(unsigned member) { return group_.members()[member].process->log(); }
    unsigned index(unsigned member) const { return group_.members()[member].process->index(); }

    /// Leaves a follower's operations up to its first answer, and the driver's up to what the sample begins with.
    void open(unsigned member, ScriptedSample& cut) {
        std::vector<Operation>& before = cut.before[index(member)];
        auto const anchor = static_cast<std::uint8_t>(1U << group_.members()[member].anchor_port);
        auto first = before.begin();
        while (member != 0 && first != before.end() && (first->ports() & anchor) == 0)
            ++first;
        log(member).clear();
        for (auto operation = first; operation != before.end(); ++operation)
            log(member).append(*operation);
        if (first != before.end())
            cut.script.next_ports[member] = first->ports();
        before.erase(first, before.end());
    }

    void open_driver(ScriptedSample& cut) {
        std::uint8_t const inner = group_.members().front().inner_ports;
        OperationLog& driver = log(0);
        std::vector<Operation>& before = cut.before[index(0)];
        std::size_t begin = 0;
        for (std::size_t i = 0; i < driver.pending() && (driver.begin()[i].all_ports() & inner) == 0; ++i)
            if (driver.begin()[i].kind() == Operation::Kind::stamp || driver.begin()[i].all_ports() != 0)
                begin = i + 1;
        before.assign(driver.begin(), driver.begin() + begin);
        driver.consume(begin, 0);
    }

    void close(unsigned member, ScriptedSample& cut) {
        cut.after[index(member)].assign(log(member).begin(), log(member).begin() + log(member).pending());
        log(member).clear();
    }

    RecordedRun const& run_;
    std::unique_ptr<timing::CoreTiming> core_;
    Group group_;
    timing::PhraseCutter phrase_cutter_;
    timing::PhraseBook& book_;
    Phrase phrase_;
};

}  // namespace

ScriptedRun::ScriptedRun(RecordedRun const& run, Parts const& parts) : run_(&run) {
    SampleCutter cutter(run, parts, book_);
    std::size_t phrases = 0;
    while (samples_.size() < run.tape.samples() && phrases < most_phrases) {
        samples_.push_back(cutter.cut(samples_.size()));
        phrases += samples_.back().phrases.size();
    }
}

}  // namespace faster::retiming

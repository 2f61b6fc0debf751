#include "retiming/scripted_run.hpp"

#include "modules/core_shapes.hpp"
#include "timing/phrase_cutter.hpp"

namespace faster::retiming {

namespace {
constexpr std::size_t most_phrases = std::size_t{1} << 26;
}  // namespace

ScriptedRun::ScriptedRun(RecordedRun const& run, Parts const& parts) : run_(&run), parts_(parts) {
    LeadCore const lead(*run.blueprint, parts);
    KnownPhrases known(lead.group);
    std::size_t phrases = 0;
    while (samples_.size() < run.tape.samples() && phrases < most_phrases) {
        samples_.push_back(run.tape.read(samples_.size(), lead, known));
        phrases += samples_.back().phrases.size();
    }
    book_ = known.take_book();
    timing::PhraseCutter cutter(*lead.core, rasterizer_and_followers(parts));
    auto const whole = static_cast<timing::PhraseBook::Number>(book_.size());
    for (timing::PhraseBook::Number number = 0; number < whole; ++number)
        cutter.cut(book_, number);
}

}  // namespace faster::retiming

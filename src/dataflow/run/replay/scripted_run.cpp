#include "dataflow/run/replay/scripted_run.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/phrases/phrase_cutter.hpp"
#include "dataflow/run/replay/tape_reader.hpp"

namespace dataflow::replay {

namespace {

using timing::PhraseBook;

constexpr std::size_t most_bytes_of_run = std::size_t{1} << 28;
constexpr std::size_t samples_worth_a_thread = 16;

/// Some of the samples, with phrases of a book of their own.
struct Share {
    std::vector<ScriptedSample> samples;
    PhraseBook book;
    bool is_whole = false;  ///< nothing was left to the tape
};

std::size_t bytes_of(ScriptedSample const& sample) {
    std::size_t operations = 0;
    for (SampleOperations const* const part : {&sample.before, &sample.after})
        for (std::vector<timing::Operation> const& process : *part)
            operations += process.size();
    return operations * sizeof(timing::Operation) + sample.phrases.size() * sizeof(PhraseBook::Number);
}

Share read_share(RecordedRun const& run, std::size_t first, std::size_t end, std::size_t most_bytes) {
    TapeReader reader(run.tape, LeadCore(*run.blueprint, run.lead));
    Share share;
    std::size_t bytes = 0;
    for (; first < end && bytes < most_bytes; ++first) {
        share.samples.push_back(reader.read(first));
        bytes += bytes_of(share.samples.back());
    }
    share.is_whole = first == end;
    share.book = std::move(reader).take_book();
    return share;
}

/// Puts the phrases of a share into the book of all, and their numbers there into its samples.
void renumber(Share& share, PhraseBook& book) {
    std::vector<PhraseBook::Number> const numbers = book.numbers_of(share.book);
    for (ScriptedSample& sample : share.samples)
        sample.renumber(numbers);
}

}  // namespace

ScriptedRun::ScriptedRun(RecordedRun const& run, Uses uses, std::size_t jobs)
    : run_(&run), jobs_(jobs), forms_(uses == Uses::many ? std::make_unique<KnownForms>() : nullptr) {
    std::size_t const samples = run.unfinished.empty() ? run.tape.samples() : run.unfinished.begin()->first;
    if (jobs_ == 0)
        jobs_ = std::min(jobs_or_host_cores(0), samples / samples_worth_a_thread + 1);
    std::vector<Share> shares(jobs_);
    on_threads(jobs_, jobs_, [&](std::size_t i) {
        shares[i] = read_share(run, i * samples / jobs_, (i + 1) * samples / jobs_, most_bytes_of_run / jobs_);
    });
    book_ = std::move(shares.front().book);
    for (Share& share : shares) {
        if (&share != &shares.front())
            renumber(share, book_);
        std::move(share.samples.begin(), share.samples.end(), std::back_inserter(samples_));
        if (!share.is_whole)
            break;  // the tape has all that follow
    }
    timing::PhraseCutter(*run.blueprint, run.lead).cut_from(book_, 0);
}

std::shared_ptr<ScriptSource const> ScriptedRun::samples_for(timing::PhraseCore& core, Machine const& machine) const {
    timing::PhraseCore::Form const form = forms_ ? core.form() : form_;
    if (!form.empty())
        if (std::shared_ptr<FormedSamples const> formed = forms_->find(*this, form, machine))
            return formed;
    return {std::shared_ptr<void>(), this};
}

}  // namespace dataflow::replay

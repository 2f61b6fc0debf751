#include "dataflow/run/replay/scripted_run.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/phrases/phrase_cutter.hpp"
#include "dataflow/run/replay/canonical_operations.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"
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

Share read_share(RecordedRun const& run, timing::Lead const& lead, std::size_t first, std::size_t end,
                 std::size_t most_bytes) {
    TapeReader reader(run.tape, LeadCore(*run.blueprint, lead));
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

/// Puts samples into the form of cores of the recorded machine.
class Former {
  public:
    Former(RecordedRun const& run, timing::Lead const& lead)
        : core_(timing::make_core()), lead_(*run.blueprint, lead), cutter_(*run.blueprint, lead) {
        core_->be_blank_copy_of(*run.blueprint);
        core_->let_follow(lead, timing::make_answers());
    }

    timing::PhraseCore::Form form() { return core_->form(); }

    /// None if one of the samples cannot be told so.
    std::optional<Share> formed(Share const& share) {
        Share formed;
        formed.is_whole = share.is_whole;
        for (ScriptedSample const& sample : share.samples) {
            SampleOperations operations = joined(sample, share.book, lead_.group);
            if (!put_in_form(operations))
                return std::nullopt;
            formed.samples.push_back(cutter_.cut(std::move(operations)));
            formed.samples.back().renumber(formed.book.numbers_of(cutter_.book()));
        }
        return formed;
    }

  private:
    bool put_in_form(SampleOperations& operations) {
        using Formed = timing::PhraseCore::Formed;
        for (std::size_t process = 0; process < operations.size(); ++process) {
            std::vector<timing::Operation>& told = operations[process];
            Formed const formed = core_->put_in_form(process, told);
            if (formed == Formed::impossible)
                return false;
            if (formed == Formed::anew)
                told = canonical(told.data(), told.size());
        }
        return true;
    }

    std::unique_ptr<timing::PhraseCore> core_;
    LeadCore lead_;
    SampleCutter cutter_;
};

/// All shares or none: who follows a script is told the others in its form, too. Which that is; behind a memory samples
/// stay as they were told.
timing::PhraseCore::Form put_in_form(RecordedRun const& run, timing::Lead const& lead, std::vector<Share>& shares) {
    timing::PhraseCore::Form const form = run.memory ? timing::PhraseCore::Form() : Former(run, lead).form();
    if (form.empty())
        return form;
    std::vector<std::optional<Share>> formed(shares.size());
    on_threads(shares.size(), shares.size(), [&](std::size_t i) { formed[i] = Former(run, lead).formed(shares[i]); });
    auto const is_there = [](std::optional<Share> const& share) { return share.has_value(); };
    if (!std::all_of(formed.begin(), formed.end(), is_there))
        return {};
    std::transform(formed.begin(), formed.end(), shares.begin(),
                   [](std::optional<Share>& share) { return std::move(*share); });
    return form;
}

/// Puts the phrases of a share into the book of all, and their numbers there into its samples.
void renumber(Share& share, PhraseBook& book) {
    std::vector<PhraseBook::Number> const numbers = book.numbers_of(share.book);
    for (ScriptedSample& sample : share.samples)
        sample.renumber(numbers);
}

}  // namespace

ScriptedRun::ScriptedRun(RecordedRun const& run, timing::Lead const& lead, Uses uses, std::size_t jobs)
    : run_(&run), lead_(lead) {
    std::size_t const samples = run.unfinished.empty() ? run.tape.samples() : run.unfinished.begin()->first;
    if (jobs == 0)
        jobs = std::min(jobs_or_host_cores(0), samples / samples_worth_a_thread + 1);
    std::vector<Share> shares(jobs);
    on_threads(jobs, jobs, [&](std::size_t i) {
        shares[i] = read_share(run, lead, i * samples / jobs, (i + 1) * samples / jobs, most_bytes_of_run / jobs);
    });
    if (uses == Uses::many)
        form_ = put_in_form(run, lead, shares);
    book_ = std::move(shares.front().book);
    for (Share& share : shares) {
        if (&share != &shares.front())
            renumber(share, book_);
        std::move(share.samples.begin(), share.samples.end(), std::back_inserter(samples_));
        if (!share.is_whole)
            break;  // the tape has all that follow
    }
    timing::PhraseCutter(*run.blueprint, lead).cut_from(book_, 0);
}

}  // namespace dataflow::replay

#include "dataflow/run/replay/formed_samples.hpp"

#include <algorithm>
#include <atomic>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/phrases/phrase_cutter.hpp"
#include "dataflow/run/replay/canonical_operations.hpp"
#include "dataflow/run/replay/core_variant.hpp"
#include "dataflow/run/replay/sample_cutter.hpp"
#include "dataflow/run/replay/scripted_run.hpp"

namespace dataflow::replay {

using timing::PhraseBook;

namespace {

/// Puts samples into the form of a core of a machine.
class Former {
  public:
    Former(ScriptedRun const& run, Machine const& machine)
        : run_(run),
          core_(core_variant(*run.run().blueprint, machine)),
          lead_(*run.run().blueprint, run.lead()),
          cutter_(*run.run().blueprint, run.lead()) {
        core_->let_follow(run.lead(), timing::make_answers());
    }

    /// With phrases of `book`. False: it cannot be told so.
    bool form(std::size_t sample, PhraseBook& book, ScriptedSample& formed) {
        SampleOperations operations = joined(run_[sample], run_.book(), lead_.group);
        for (std::size_t process = 0; process < operations.size(); ++process)
            if (!put_in_form(process, operations[process]))
                return false;
        formed = cutter_.cut(std::move(operations));
        formed.renumber(book.numbers_of(cutter_.book()));
        return true;
    }

  private:
    bool put_in_form(std::size_t process, std::vector<timing::Operation>& operations) {
        using Formed = timing::PhraseCore::Formed;
        Formed const formed = core_->put_in_form(process, operations);
        if (formed == Formed::anew)
            operations = canonical(operations.data(), operations.size());
        return formed != Formed::impossible;
    }

    ScriptedRun const& run_;
    std::unique_ptr<timing::PhraseCore> core_;
    LeadCore lead_;
    SampleCutter cutter_;
};

}  // namespace

std::shared_ptr<FormedSamples const> FormedSamples::of(ScriptedRun const& run, timing::PhraseCore::Form const& form,
                                                       Machine const& machine) {
    std::shared_ptr<FormedSamples> const all(new FormedSamples(form));
    std::size_t const jobs = run.jobs();
    all->samples_.resize(run.size());
    std::vector<PhraseBook> books(jobs);
    std::atomic<bool> can_be_told{true};
    on_threads(jobs, jobs, [&](std::size_t i) {
        Former former(run, machine);
        for (std::size_t sample = i * run.size() / jobs; sample < (i + 1) * run.size() / jobs && can_be_told; ++sample)
            if (!former.form(sample, books[i], all->samples_[sample]))
                can_be_told = false;
    });
    if (!can_be_told)
        return nullptr;
    for (std::size_t i = 0; i < jobs; ++i) {
        std::vector<PhraseBook::Number> const numbers = all->book_.numbers_of(books[i]);
        for (std::size_t sample = i * run.size() / jobs; sample < (i + 1) * run.size() / jobs; ++sample)
            all->samples_[sample].renumber(numbers);
    }
    timing::PhraseCutter(*run.run().blueprint, run.lead()).cut_from(all->book_, 0);
    return all;
}

std::shared_ptr<FormedSamples const> KnownForms::find(ScriptedRun const& run, timing::PhraseCore::Form const& form,
                                                      Machine const& machine) {
    std::shared_ptr<Entry> const entry = entry_of(form);
    std::call_once(entry->formed, [&] { entry->samples = FormedSamples::of(run, form, machine); });
    return entry->samples;
}

std::shared_ptr<KnownForms::Entry> KnownForms::entry_of(timing::PhraseCore::Form const& form) {
    std::lock_guard<std::mutex> const lock(mutex_);
    auto const known = std::find_if(entries_.begin(), entries_.end(),
                                    [&form](std::shared_ptr<Entry> const& entry) { return entry->form == form; });
    if (known != entries_.end()) {
        std::rotate(known, known + 1, entries_.end());
        return entries_.back();
    }
    if (entries_.size() == most)
        entries_.erase(entries_.begin());
    entries_.push_back(std::make_shared<Entry>());
    entries_.back()->form = form;
    return entries_.back();
}

}  // namespace dataflow::replay

#pragma once
#include <memory>
#include <vector>

#include "dataflow/lookup/automaton.hpp"
#include "dataflow/lookup/loops_in_steps.hpp"
#include "dataflow/lookup/steady_state.hpp"
#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::timing {

/// A core that works out as little as it can: a steady state jumps over the middle of long regular runs, and an
/// automaton, which may be shared with cores of the same shape, answers for the group of a lead.
class FollowedCore : public PhraseCore {
  public:
    /// The answers are an Automaton.
    void let_follow(Lead const& lead, std::shared_ptr<Answers> const& answers) override;

    void resume(ProcessMask processes) override;
    void take_up(Script& script) override;
    Form form() override;
    Formed put_in_form(std::size_t process, std::vector<Operation>& operations) override;
    void be_told_in_form(bool is_in_form) override;
    bool follows_script() const override { return follows_; }
    bool set_out() override;
    void let_walk() override;
    void arrive() override;
    /// Where it is with the script, having set out.
    Automaton::Walk& walk() { return walk_; }

  private:
    void go_on(bool to_the_end) override;
    ProcessMask run_ahead(ProcessTiming& process) override { return steady_state_.observe(process, own_processes()); }
    void complete_counters() override;
    void note_trail(Trail& trail) override;
    void note_connected() override;
    void look_at_logs() override;

    bool is_followed();
    bool group_has_started();
    bool let_driver_go();
    bool awaits_memory() const;
    void write_next_phrase();

    SteadyState steady_state_;
    std::vector<std::unique_ptr<LoopsInSteps>> in_steps_;  ///< of processes that have loops of steps
    bool is_group_in_steps_ = false;                       ///< members of the group
    bool is_told_in_steps_ = false;                        ///< nothing is to be put into steps
    std::shared_ptr<Automaton> automaton_;
    Automaton::Session session_;
    Automaton::Walk walk_;
    bool follows_ = false;  ///< the script at hand
    bool started_ = false;
};

}  // namespace dataflow::timing

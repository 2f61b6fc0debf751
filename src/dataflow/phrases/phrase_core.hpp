#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/core/time/lead.hpp"
#include "dataflow/phrases/group.hpp"
#include "dataflow/phrases/phrase_book.hpp"

namespace dataflow::timing {

class PhraseCore;

/// What cores of one shape remember together of what their lead groups do.
class Answers {
  public:
    virtual ~Answers() = default;
    /// Moves cores that have set out on, in turns, until one has to arrive: which.
    virtual std::size_t go_on(std::vector<PhraseCore*> const& cores) = 0;
};

/// A core whose lead group can be told what it does by a script. This one writes all of it to the logs, and works it
/// out; a core that remembers answers may know what comes of a phrase. Cycles are the same.
class PhraseCore : public CoreTiming {
  public:
    /// Who sets the pace, and answers to be shared with cores of the same shape. A lead without followers has nothing
    /// to follow: the core stays as it is. Before anything has happened.
    virtual void let_follow(Lead const& lead, std::shared_ptr<Answers> const& answers);

    // A core may put what the members of its group are told into another form, which it goes through more quickly.
    // Cycles are the same. A script can have that form already.

    /// All that the form depends on; cores with equal ones have the same. Empty: operations stay as they are.
    using Form = std::vector<std::uint64_t>;
    virtual Form form() { return {}; }
    /// What a process is told for a sample, in that form. For a core that does nothing else.
    enum class Formed {
        as_before,  ///< they stay as they are
        anew,
        impossible,  ///< they end within a loop, and what follows depends on it; or would become too many
    };
    virtual Formed put_in_form(std::size_t /*process*/, std::vector<Operation>& /*operations*/) {
        return Formed::as_before;
    }
    /// Whether what is told from here on, by script or not, has that form already.
    virtual void be_told_in_form(bool /*is_in_form*/) {}

    /// From here on, does what a script says, which goes on where the logs end: what cannot be done yet is in the logs
    /// then. There must be a lead with followers. In parts, so that cores that share answers can take turns:
    ///
    ///     core.take_up(script);
    ///     while (core.set_out()) {
    ///         answers.go_on({&core});
    ///         core.arrive();
    ///     }
    virtual void take_up(Script& script);
    /// Whether it looks phrases of a script up. Otherwise all of a script goes to the logs.
    virtual bool follows_script() const { return false; }
    /// As far as a walk; false: the script is done, or, behind a memory, the driver waits: it goes on from there once
    /// the memory has brought more.
    virtual bool set_out();
    /// Between setting out and arriving, for a core that does not take turns.
    virtual void let_walk() {}
    virtual void arrive() {}
    /// All of this, for a core that does not take turns.
    void walk_through();

  protected:
    void note_connected() override;
    Lead const& lead() const { return lead_; }
    /// Of the lead. Once connected; null: there are no followers.
    Group const* group() const { return group_.get(); }
    Script* script() const { return script_; }

  private:
    Lead lead_;
    std::unique_ptr<Group> group_;
    Script* script_ = nullptr;
};

/// The quickest core that there is in this build, and what cores share who are told to follow the same lead. A build
/// with lookup has cores that remember; any other works everything out, and shares nothing.
std::unique_ptr<PhraseCore> make_core();
std::shared_ptr<Answers> make_answers();

}  // namespace dataflow::timing

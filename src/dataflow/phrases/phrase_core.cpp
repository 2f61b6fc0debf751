#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::timing {

void PhraseCore::let_follow(Lead const& lead, std::shared_ptr<Answers> const& /*answers*/) {
    if (!lead.followers.empty())
        lead_ = lead;
}

void PhraseCore::note_connected() {
    if (!lead_.followers.empty())
        group_ = std::make_unique<Group>(*this, lead_);
}

void PhraseCore::take_up(Script& script) {
    connect();
    script_ = &script;
}

bool PhraseCore::set_out() {
    while (!script_->done())
        write_next(*group_, *script_);
    return false;
}

void PhraseCore::walk_through() {
    while (set_out()) {
        let_walk();
        arrive();
    }
}

}  // namespace dataflow::timing

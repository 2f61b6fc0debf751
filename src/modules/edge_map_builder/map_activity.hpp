#pragma once
#include "faster/config/edge_map_algorithm.hpp"
#include "modules/core/window_activity.hpp"

namespace faster {

/// Which words of its maps the EdgeMapBuilder accesses, and who reads a second buffer out for it (thesis A.2).
class MapActivity : public WindowActivity {
  public:
    MapActivity(AcceleratorConfig const& config, Machine const& machine);

    void token_read(recording::TokenRead const& read) override;

  private:
    /// What an iteration of a loop does to the maps.
    enum class Work { nothing, clear, take_token, read_out };
    /// What a branch of the token loop accesses, seen from the token's pixel.
    struct Branch {
        explicit Branch(PerMap const& touches);
        AccessPattern edge_map, object_map;
    };

    void access_for(recording::LoopIteration const& iteration) override;
    void clear_maps(std::int64_t iteration);
    void take_token(Cycles cycle);
    void read_out(std::int64_t iteration);
    Branch const& branch_at(Cycles cycle) const;
    Token token_of(recording::TokenValues const& fields) const;

    EdgeMapConfig maps_;
    Branch edge_, object_, second_;
    std::int64_t lanes_;
    std::size_t edge_token_, edge_map_, object_map_;  // numbers of the machine's parts
    std::vector<Work> works_;                         // by loop

    Token token_;  // that the edge map builder works on; in the end a region's first corner
    Token next_;   // read ahead; in the end its last corner
    Cycles token_read_ = 0;
};

}  // namespace faster

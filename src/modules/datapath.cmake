faster_add_library(datapath
  SOURCES
    edge_extraction.cpp triangle_setup.cpp untimed_scorer.cpp valid_depth_table.cpp vertex_transform.cpp window_sweep.cpp
    edge_map/edge_map_policy.cpp edge_map/edge_maps.cpp
  PUBLIC faster::base faster::common)

#pragma once
#include <cstddef>

#include "dataflow/base/write_distances.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::datapath {

/// Told which words of the two maps the iterations of the token loop read and write, a word per pixel, row by row. Of a
/// map that nobody wants to know about, nothing is told.
struct MapWatch {
    WriteDistances* edge_map = nullptr;
    WriteDistances* object_map = nullptr;

    void next_iteration() const {
        for (WriteDistances* const map : {edge_map, object_map})
            if (map != nullptr)
                map->next_iteration();
    }
    void reads_edge(std::size_t word) const {
        if (edge_map != nullptr)
            edge_map->read(word);
    }
    void writes_edge(std::size_t word) const {
        if (edge_map != nullptr)
            edge_map->write(word);
    }
    void reads_object(std::size_t word) const {
        if (object_map != nullptr)
            object_map->read(word);
    }
    void writes_object(std::size_t word) const {
        if (object_map != nullptr)
            object_map->write(word);
    }
};

/// Nobody wants to know.
struct NoMapWatch {
    void next_iteration() const {}
    void reads_edge(std::size_t /*word*/) const {}
    void writes_edge(std::size_t /*word*/) const {}
    void reads_object(std::size_t /*word*/) const {}
    void writes_object(std::size_t /*word*/) const {}
};

}  // namespace faster::datapath

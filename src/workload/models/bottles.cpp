#include "workload/models/primitives/loft.hpp"
#include "workload/models/shape.hpp"

namespace faster::models {
namespace {

/// A waisted flat bottle with a round collar and a conical nozzle.
Mesh mustard_bottle(double edge_length) {
    return loft({{0.0, 45.0, 26.0, 4.0},
                 {4.0, 47.5, 28.5, 4.0},
                 {32.0, 48.0, 29.1, 3.5},
                 {56.0, 43.0, 28.5, 3.0},
                 {72.0, 38.0, 28.0, 3.0},
                 {90.0, 37.0, 27.5, 3.0},
                 {106.0, 42.0, 28.0, 3.0},
                 {124.0, 47.0, 28.5, 2.8},
                 {138.0, 45.0, 27.5, 2.5},
                 {150.0, 34.0, 23.0, 2.2},
                 {157.0, 20.0, 17.0},
                 {158.0, 20.0, 20.0},
                 {169.0, 19.5, 19.5},
                 {171.0, 11.0, 11.0},
                 {191.3, 6.5, 6.5}},
                edge_length);
}

/// A bottle that leans to its straight back (+x), with a waist to grip below the shoulder and a round cap.
Mesh bleach_cleanser(double edge_length) {
    return loft({{0.0, 49.0, 32.0, 4.0},
                 {4.0, 51.2, 33.8, 4.0},
                 {14.0, 51.2, 33.8, 4.0},
                 {18.0, 48.0, 33.0, 4.0, 3.0},
                 {80.0, 44.5, 29.5, 3.5, 6.0},
                 {140.0, 40.5, 26.0, 3.2, 9.5},
                 {175.0, 34.0, 21.0, 2.8, 16.0},
                 {187.0, 31.0, 20.0, 2.5, 17.0},
                 {194.0, 35.0, 25.0, 2.3, 14.0},
                 {212.0, 37.0, 25.0, 2.2, 12.0},
                 {226.0, 29.0, 20.0, 2.0, 14.0},
                 {232.0, 15.0, 15.0, 2.0, 10.0},
                 {250.6, 15.0, 15.0, 2.0, 10.0}},
                edge_length);
}

}  // namespace

std::vector<Shape> bottles() {
    return {
        {"bleach_cleanser", {102.4, 67.7, 250.6}, bleach_cleanser},
        {"mustard_bottle", {95.9, 58.2, 191.3}, mustard_bottle},
    };
}

}  // namespace faster::models

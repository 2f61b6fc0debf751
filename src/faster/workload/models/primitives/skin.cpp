#include "faster/workload/models/primitives/skin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "dataflow/base/portable_math.hpp"

namespace faster::models {

namespace {

/// Direction of the way at station i: from its predecessor to its successor.
Eigen::Vector3d direction(std::vector<Station> const& stations, std::size_t i, Ends ends) {
    std::size_t const last = stations.size() - 1;
    bool const joined = ends == Ends::joined;
    std::size_t const before = i > 0 ? i - 1 : (joined ? last : 0);
    std::size_t const after = i < last ? i + 1 : (joined ? 0 : last);
    return (stations[after].centre - stations[before].centre).normalized();
}

constexpr double row_height = 0.866;  // of an equilateral triangle with edge 1

using Outline = std::vector<Eigen::Vector3d>;

bool is_pole(Section const& section) { return section.u.isZero() && section.v.isZero(); }

Section pole_of(Section const& section) {
    return {section.centre, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), section.exponent};
}

Section weighted(Section const& a, double wa, Section const& b, double wb) {
    return {wa * a.centre + wb * b.centre, wa * a.u + wb * b.u, wa * a.v + wb * b.v, wa * a.exponent + wb * b.exponent};
}

/// Mean way of the four points on the axes from one section to the next.
double distance(Section const& a, Section const& b) {
    Eigen::Vector3d const c = b.centre - a.centre;
    Eigen::Vector3d const u = b.u - a.u;
    Eigen::Vector3d const v = b.v - a.v;
    return ((c + u).norm() + (c - u).norm() + (c + v).norm() + (c - v).norm()) / 4.0;
}

/// Catmull-Rom spline from b (t = 0) to c (t = 1) with the neighbours a and d.
Section on_spline(Section const& a, Section const& b, Section const& c, Section const& d, double t) {
    double const t2 = t * t;
    double const t3 = t2 * t;
    Section const outer = weighted(a, (-t + 2.0 * t2 - t3) / 2.0, d, (t3 - t2) / 2.0);
    Section const inner = weighted(b, (2.0 - 5.0 * t2 + 3.0 * t3) / 2.0, c, (t + 4.0 * t2 - 3.0 * t3) / 2.0);
    return weighted(outer, 1.0, inner, 1.0);
}

/// The sections with as many in between as the edge length asks for.
std::vector<Section> subdivided(std::vector<Section> const& given, double edge_length, Between between, Ends ends) {
    std::size_t const count = given.size();
    bool const joined = ends == Ends::joined;
    auto const before = [&](std::size_t i) { return i > 0 ? i - 1 : (joined ? count - 1 : 0); };
    auto const after = [&](std::size_t i) { return i + 1 < count ? i + 1 : (joined ? 0 : count - 1); };
    std::vector<Section> result;
    for (std::size_t i = 0; i + (joined ? 0 : 1) < count; ++i) {
        Section const& from = given[i];
        Section const& to = given[after(i)];
        int const steps = std::max(1, static_cast<int>(std::lround(distance(from, to) / (edge_length * row_height))));
        for (int step = 0; step < steps; ++step) {
            double const t = static_cast<double>(step) / steps;
            result.push_back(between == Between::straight
                                 ? weighted(from, 1.0 - t, to, t)
                                 : on_spline(given[before(i)], from, to, given[after(after(i))], t));
        }
    }
    if (!joined) {
        result.push_back(given.back());
    }
    return result;
}

/// Closes open ends with flat lids.
std::vector<Section> capped(std::vector<Section> sections, double edge_length) {
    auto const lid = [&](Section const& from, Section const& to) {
        return subdivided({from, to}, edge_length, Between::straight, Ends::capped);
    };
    if (!is_pole(sections.front())) {
        std::vector<Section> const rows = lid(pole_of(sections.front()), sections.front());
        sections.insert(sections.begin(), rows.begin(), rows.end() - 1);
    }
    if (!is_pole(sections.back())) {
        std::vector<Section> const rows = lid(sections.back(), pole_of(sections.back()));
        sections.insert(sections.end(), rows.begin() + 1, rows.end());
    }
    return sections;
}

/// The section's outline as four fine polylines: from u to v, from there to -u, and so on.
std::array<Outline, 4> fine_quarters(Section const& section) {
    constexpr int pieces = 32;
    Eigen::Vector3d const axes[] = {section.u, section.v, -section.u, -section.v};
    std::array<Outline, 4> quarters;
    for (int i = 0; i <= pieces; ++i) {
        // The ends of a quarter are exact, so the four quarters meet in the same points.
        double const angle = dataflow::portable::pi / 2.0 * i / pieces;
        double const c = i == pieces ? 0.0 : std::pow(std::cos(angle), 2.0 / section.exponent);
        double const s = std::pow(std::sin(angle), 2.0 / section.exponent);
        for (std::size_t quarter = 0; quarter < quarters.size(); ++quarter)
            quarters[quarter].emplace_back(section.centre + c * axes[quarter] + s * axes[(quarter + 1) % 4]);
    }
    return quarters;
}

double length(Outline const& polyline) {
    double sum = 0.0;
    for (std::size_t i = 1; i < polyline.size(); ++i) {
        sum += (polyline[i] - polyline[i - 1]).norm();
    }
    return sum;
}

/// `count` points at equal distances along the polyline, its first point included and its last left out.
void append_evenly(Outline& outline, Outline const& polyline, int count) {
    double const spacing = length(polyline) / count;
    double walked = 0.0;
    std::size_t piece = 1;
    for (int i = 0; i < count; ++i) {
        double const target = spacing * i;
        while (walked + (polyline[piece] - polyline[piece - 1]).norm() < target) {
            walked += (polyline[piece] - polyline[piece - 1]).norm();
            ++piece;
        }
        Eigen::Vector3d const step = polyline[piece] - polyline[piece - 1];
        outline.emplace_back(polyline[piece - 1] + step * ((target - walked) / step.norm()));
    }
}

/// The section as a polygon of four equal quarters, at least an octagon; or one point for a pole.
Outline outline_of(Section const& section, double edge_length) {
    if (is_pole(section)) {
        return {section.centre};
    }
    std::array<Outline, 4> const quarters = fine_quarters(section);
    double perimeter = 0.0;
    for (Outline const& quarter : quarters) {
        perimeter += length(quarter);
    }
    int const per_quarter = std::max(2, static_cast<int>(std::lround(perimeter / edge_length / 4.0)));
    Outline outline;
    for (Outline const& quarter : quarters) {
        append_evenly(outline, quarter, per_quarter);
    }
    return outline;
}

/// A polygon inside the mesh: its first vertex and how many follow each other.
struct Ring {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t vertex(std::uint32_t i) const { return first + i % count; }
};

Ring append_ring(Mesh& mesh, Outline const& outline) {
    Ring const ring{static_cast<std::uint32_t>(mesh.vertices.size()), static_cast<std::uint32_t>(outline.size())};
    mesh.vertices.insert(mesh.vertices.end(), outline.begin(), outline.end());
    return ring;
}

/// Fills the band between two rings, walking round both at the same pace whatever their counts.
void stitch(Mesh& mesh, Ring const& lower, Ring const& upper) {
    std::uint32_t const lower_steps = lower.count > 1 ? lower.count : 0;
    std::uint32_t const upper_steps = upper.count > 1 ? upper.count : 0;
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    while (i < lower_steps || j < upper_steps) {
        bool const lower_next = j == upper_steps || (i < lower_steps && (i + 1) * upper.count <= (j + 1) * lower.count);
        if (lower_next) {
            mesh.faces.push_back({lower.vertex(i), lower.vertex(i + 1), upper.vertex(j)});
            ++i;
        } else {
            mesh.faces.push_back({lower.vertex(i), upper.vertex(j + 1), upper.vertex(j)});
            ++j;
        }
    }
}

}  // namespace

Mesh loft(std::vector<Level> const& levels, double edge_length) {
    std::vector<Section> sections;
    sections.reserve(levels.size());
    for (Level const& level : levels) {
        sections.push_back(
            {{level.centre_x, 0.0, level.height}, {level.half_x, 0.0, 0.0}, {0.0, level.half_y, 0.0}, level.exponent});
    }
    return skin(sections, edge_length);
}

Mesh revolution(std::vector<ProfilePoint> const& profile, double edge_length) {
    std::vector<Section> sections;
    sections.reserve(profile.size());
    for (ProfilePoint const& point : profile) {
        sections.push_back({{0.0, 0.0, point.height}, {point.radius, 0.0, 0.0}, {0.0, point.radius, 0.0}});
    }
    return skin(sections, edge_length);
}

Mesh tube(std::vector<Station> const& stations, Eigen::Vector3d const& up, double edge_length, Between between,
          Ends ends) {
    std::vector<Section> sections;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        Station const& station = stations[i];
        Eigen::Vector3d const forward = direction(stations, i, ends);
        Eigen::Vector3d const sideways = up.cross(forward).normalized();
        sections.push_back({station.centre, station.half_width * sideways,
                            station.half_height * forward.cross(sideways), station.exponent});
    }
    return skin(sections, edge_length, between, ends);
}

Mesh skin(std::vector<Section> const& sections, double edge_length, Between between, Ends ends) {
    std::vector<Section> rows = subdivided(sections, edge_length, between, ends);
    if (ends == Ends::capped) {
        rows = capped(std::move(rows), edge_length);
    }
    Mesh mesh;
    std::vector<Ring> rings;
    rings.reserve(rows.size());
    for (Section const& row : rows) {
        rings.push_back(append_ring(mesh, outline_of(row, edge_length)));
    }
    for (std::size_t i = 1; i < rings.size(); ++i) {
        stitch(mesh, rings[i - 1], rings[i]);
    }
    if (ends == Ends::joined) {
        stitch(mesh, rings.back(), rings.front());
    }
    return mesh;
}

}  // namespace faster::models

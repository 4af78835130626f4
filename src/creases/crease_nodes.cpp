// SPDX-License-Identifier: MIT
#include "creases/crease_nodes.h"

#include "curves/edge_halving.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides.
constexpr double meeting_tolerance = 1e-9; // of a place where sheets meet
constexpr double on_surface = 1e-3;        // that place's distance from the whole surface
constexpr double aside = 1e-3;             // to either side of it, where f is looked at
constexpr double farthest_meeting = 1.5;   // from the edge
constexpr double least_sine = 0.02;        // of half the angle between sheets: below it curvature may be more
constexpr double equal = 1e-7;             // sheets that are no farther apart, and as parallel, are one there
constexpr double beside_surface = 0.02;    // a place's distance from it where a crease goes on through a seam
constexpr double sharp_sine = 0.1;         // of half the angle: 11 degrees, below which none goes on so

} // namespace

// In sides.
double CreaseNodes::off_surface(const glm::dvec3& place) const {
    double value = 0.0;
    glm::dvec3 g(0.0);
    implicit_.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&g.x, &g.y, &g.z}, {}});
    return std::abs(value) / (mesh_.side * glm::length(g));
}

// Whether f is the larger or the lesser of both sheets around the place.  Beyond a corner it may be 0 where both are,
// and one of them: where they differ most, it has then opposite signs to either side, and the edge passes a third
// sheet.  far: where f is looked at, to either side.
bool CreaseNodes::folds(const CreaseNode& at, const std::array<glm::dvec3, 2>& gradient, double far) const {
    const glm::dvec3 across = glm::normalize(gradient[0]) - glm::normalize(gradient[1]);
    const double sine = 0.5 * glm::length(across); // of half the angle between them: f aside is that share of the way
    if (!(sine > least_sine)) return true;
    const glm::dvec3 way = far * mesh_.side / (2.0 * sine) * across;
    const std::array<glm::dvec3, 2> beside{at.position + way, at.position - way};
    std::array<double, 2> off{};
    for (std::size_t k = 0; k < 2; ++k) {
        surface::SheetValue f;
        implicit_.evaluate({&beside[k].x, &beside[k].y, &beside[k].z, 1},
                           {&f.value, {&f.gradient.x, &f.gradient.y, &f.gradient.z}, {}});
        off[k] = f.value / glm::length(f.gradient);
    }
    const double least = 0.5 * sine * far * mesh_.side;
    return !(off[0] * off[1] < 0.0 && std::min(std::abs(off[0]), std::abs(off[1])) > least);
}

// Whether there is such a fold as near as `beside_surface`, seen from so far that it makes no difference where.
bool CreaseNodes::folds_beside(const EdgeNode& node) const {
    const double sine = 0.5 * glm::distance(glm::normalize(node.gradient[0]), glm::normalize(node.gradient[1]));
    return sine > sharp_sine && folds(node.at, node.gradient, 2.0 * beside_surface / sine);
}

// From where the difference of both sheets is 0 as it is linear along the edge.
void CreaseNodes::look_at(EdgeNode& node) const {
    const std::array<std::int32_t, 2> end{start_of(mesh_, node.edge), end_of(mesh_, node.edge)};
    const std::array<glm::dvec3, 2> place{mesh_.position[end[0]], mesh_.position[end[1]]};
    std::array<double, 2> off{}; // of either end from the other's sheet
    node.alike = true;
    for (std::size_t k = 0; k < 2; ++k) {
        const surface::SheetValue other = surface::sheet_at(sheets_, sheet_[end[1 - k]], place[k]);
        const double slope = glm::length(other.gradient);
        off[k] = other.value / slope;
        const glm::dvec3 own = glm::normalize(mesh_.gradient[end[k]]);
        const double turned = glm::distance(own, other.gradient / slope);
        node.equal[k] = std::abs(off[k]) <= equal * mesh_.side && turned <= equal;
        node.alike = node.alike && std::abs(off[k]) <= alike_sheets * mesh_.side && turned <= alike_sheets;
    }
    double share = off[0] / (off[0] + off[1]);
    if (!(share > 0.0 && share < 1.0)) share = 0.5;
    surface::Meeting meeting;
    for (const std::int32_t vertex : end) meeting.add(sheet_[vertex]);
    const glm::dvec3 from = glm::mix(place[0], place[1], share);
    const double reach = farthest_meeting * std::min(mesh_.side, 2.0 * glm::distance(place[0], place[1]));
    const surface::MeetingPlace found =
        surface::find_meeting(sheets_, meeting, from, meeting_tolerance * mesh_.side, reach);
    node.at.position = found.found ? found.position : from;
    node.meet = found.found;
    node.gradient = {found.gradient[0], found.gradient[1]};
    const double away = found.found ? off_surface(found.position) : beside_surface;
    node.at.exact = away <= on_surface && folds(node.at, node.gradient, aside);
    node.near = !node.at.exact && away < beside_surface && folds_beside(node);
}

void CreaseNodes::look_at(CornerNode& node, const glm::dvec3& middle) const {
    surface::Meeting meeting;
    for (std::int64_t k = 3 * node.triangle; k < 3 * node.triangle + 3; ++k) meeting.add(sheet_[mesh_.corner[k]]);
    const surface::MeetingPlace found =
        surface::find_meeting(sheets_, meeting, middle, meeting_tolerance * mesh_.side, farthest_meeting * mesh_.side);
    node.at.corner = true;
    node.at.position = found.found ? found.position : middle;
    node.gradient = found.gradient;
    node.at.exact = found.found && off_surface(found.position) <= on_surface;
}

// Two of its sheets may be parts of one patch, nearly one beside their seam, and meet nowhere there.  A crease comes to
// such a seam on one of them and goes on along the other: it does both where the third and one of these meet.
bool CreaseNodes::place_at_seam(CornerNode& node, const EdgeNode& beside) const {
    surface::Meeting meeting;
    for (const std::int32_t vertex : {start_of(mesh_, beside.edge), end_of(mesh_, beside.edge)})
        meeting.add(sheet_[vertex]);
    const surface::MeetingPlace found = surface::find_meeting(
        sheets_, meeting, node.at.position, meeting_tolerance * mesh_.side, farthest_meeting * mesh_.side);
    node.at.exact = found.found && off_surface(found.position) < beside_surface;
    if (node.at.exact) node.at.position = found.position;
    return node.at.exact;
}

} // namespace hrbfnpr::curves

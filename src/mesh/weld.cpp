// SPDX-License-Identifier: MIT
// The steps of weld(), in order:
//
//   read_triangles            checks the indices and the coordinates
//   join_vertices             merges vertices at the same place
//   join_borders              merges border vertices that differ by rounding only
//   split_slivers             replaces a face without area by half of its neighbour
//   leave_out_faces           drops faces without area, and repeated ones
//   leave_out_walls           drops pairs of faces that are a wall between two solids
//   separate_solids_at_edges  gives solids that touch in an edge or a corner vertices of their own there
#include "mesh/weld.h"

#include "base/bits.h"
#include "base/status.h"
#include "geometry/point_grid.h"
#include "mesh/edges.h"
#include "mesh/tuning.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace hrbfnpr::mesh {
namespace {

// ---- Reading

[[nodiscard]] glm::dvec3 vertex_at(const base::InView& vertices, std::int64_t i) noexcept {
    // Adding 0.0 turns -0 into 0, so that both are the same place.
    return {vertices.get(i, 0) + 0.0, vertices.get(i, 1) + 0.0, vertices.get(i, 2) + 0.0};
}

void check_vertex(const glm::dvec3& p, std::int64_t vertex, std::int64_t face) {
    for (glm::length_t c = 0; c < 3; ++c)
        if (!(std::abs(p[c]) <= largest_coordinate))
            fail(Status::invalid_argument,
                 "vertices[%lld], a corner of triangles[%lld], has the coordinate %g; coordinates must be finite and "
                 "at most 1e60: remove the face, or scale the mesh",
                 static_cast<long long>(vertex), static_cast<long long>(face), p[c]);
}

// Returns the triangles with the caller's vertex indices.
[[nodiscard]] base::Array<Triangle> read_triangles(const base::Work& work, const MeshInput& input) {
    const std::int64_t vertices = input.vertices.count;
    base::Array<Triangle> triangle(work.memory);
    triangle.resize_for_overwrite(input.triangles.count);
    work.for_chunks(triangle.size(), mesh_tuning.at_once, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::int64_t index = input.triangles.get_integer(face, k);
                if (index < 0 || index >= vertices)
                    fail(Status::invalid_argument,
                         "triangles[%lld] has the index %lld; there are %lld vertices, numbered from 0 to %lld",
                         static_cast<long long>(face), static_cast<long long>(index), static_cast<long long>(vertices),
                         static_cast<long long>(vertices - 1));
                triangle[face][k] = static_cast<std::int32_t>(index);
                check_vertex(vertex_at(input.vertices, index), index, face);
            }
    });
    return triangle;
}

// ---- Vertices at the same place

[[nodiscard]] std::uint64_t hash_of(std::uint64_t bits) noexcept { // Mixes the bits, as MurmurHash3 does at its end.
    bits = (bits ^ bits >> 33U) * 0xff51afd7ed558ccdU;
    bits = (bits ^ bits >> 33U) * 0xc4ceb9fe1a85ec53U;
    return bits ^ bits >> 33U;
}

// A hash table that assigns the indices 0, 1, 2 and so on to different items, in the order in which they are added.
class HashNumbering {
public:
    HashNumbering(base::Memory& memory, std::int64_t most)
        : place_(memory, static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * most + 16)))) {}

    // Returns the index of an item. If the item is in the table, this is the index for which same(index) is true. A new
    // item gets the index `next`.
    template <class Same>
    [[nodiscard]] std::int64_t find_or_add(std::uint64_t hash, std::int64_t next, Same&& same) noexcept {
        const auto mask = static_cast<std::uint64_t>(place_.size() - 1);
        for (std::uint64_t at = hash & mask;; at = (at + 1) & mask) {
            std::int32_t& number = place_[static_cast<std::int64_t>(at)];
            if (number == 0) {
                number = static_cast<std::int32_t>(next + 1);
                return next;
            }
            if (same(number - 1)) return number - 1;
        }
    }

private:
    base::Array<std::int32_t> place_; // for each slot of the table: an index plus 1, or 0 if the slot is free
};

void join_vertices(const base::InView& given, Welded& welded, MeshReport& report, const base::Progress& progress) {
    base::Memory& memory = welded.vertex.memory();
    base::Array<std::int32_t> number(memory, given.count);
    for (const Triangle& t : welded.triangle)
        for (const std::int32_t corner : t) number[corner] = 1; // marks the vertex as used
    progress.check();
    HashNumbering numbers(memory, given.count);
    std::int64_t used = 0;
    for (const std::int64_t i : progress.over(given.count)) {
        if (number[i] == 0) continue;
        ++used;
        const glm::dvec3 p = vertex_at(given, i);
        std::uint64_t hash = hash_of(base::bit_cast<std::uint64_t>(p.x));
        hash = hash_of(hash ^ base::bit_cast<std::uint64_t>(p.y));
        hash = hash_of(hash ^ base::bit_cast<std::uint64_t>(p.z));
        const std::int64_t next = welded.vertex.size();
        const std::int64_t found =
            numbers.find_or_add(hash, next, [&](std::int64_t k) { return welded.vertex[k] == p; });
        if (found == next) welded.vertex.push_back(p);
        number[i] = static_cast<std::int32_t>(found);
    }
    report.welded_vertices = used - welded.vertex.size();
    for (Triangle& t : welded.triangle)
        for (std::int32_t& corner : t) corner = number[corner];
}

// Returns whether equally many faces run through each edge in both directions, as in a closed mesh. Such a mesh has no
// borders. For a mesh with borders it is wrong with the probability 2^-64, but it is faster than sorting all edges.
[[nodiscard]] bool is_balanced(const base::Array<Triangle>& triangle) noexcept {
    std::uint64_t sum = 0;
    for (const Triangle& t : triangle)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto from = static_cast<std::uint64_t>(t[k]);
            const auto to = static_cast<std::uint64_t>(t[(k + 1) % 3]);
            sum += hash_of(from << 32U | to) - hash_of(to << 32U | from);
        }
    return sum == 0;
}

void rename_corners(UnionFind& same, Welded& welded) noexcept {
    for (Triangle& t : welded.triangle)
        for (std::int32_t& corner : t) corner = same.find(corner);
}

// Merges border vertices that are close to each other, because rounding separates corners of faces that were made
// separately. After this, a face may have the same vertex at two corners.
void join_borders(const base::Work& work, Welded& welded, MeshReport& report) {
    if (is_balanced(welded.triangle)) return;
    geometry::Bounds bounds;
    for (const glm::dvec3& p : welded.vertex) bounds.extend(p);
    const double near = mesh_tuning.border_rounding * bounds.diagonal();
    base::Array<std::uint8_t> is_border(work.memory, welded.vertex.size());
    for_edges(sides_by_edge(work, welded.triangle), work, [&](const Side* first, const Side* last) {
        if (last - first == 1) is_border[low_end(*first)] = is_border[high_end(*first)] = 1;
    });
    base::Array<std::int32_t> border(work.memory);
    geometry::VecArray place(work.memory);
    for (std::int64_t v = 0; v < welded.vertex.size(); ++v) {
        if (is_border[v] == 0) continue;
        border.push_back(static_cast<std::int32_t>(v));
        place.push_back(welded.vertex[v]);
    }
    if (border.empty() || !(near > 0.0)) return;
    const geometry::PointGrid grid(place, near, work);
    UnionFind same(work.memory, welded.vertex.size());
    for (std::int64_t i = 0; i < border.size(); ++i)
        grid.around(place[i], [&](std::int64_t at) {
            const std::int64_t j = grid.index(at);
            const glm::dvec3 way = place[j] - place[i];
            if (j > i && glm::dot(way, way) <= near * near) same.join(border[i], border[j]);
        });
    rename_corners(same, welded);
    report.welded_vertices +=
        std::count_if(border.begin(), border.end(), [&](std::int32_t v) { return same.find(v) != v; });
}

// ---- Slivers: faces whose corners lie on a line, except for rounding
//
// A sliver has a corner within its longest side. Dropping the sliver would leave a slit and open a solid. Instead the
// face across that side is cut in two at the corner, and one half replaces the sliver.

constexpr std::uint64_t no_edge = ~std::uint64_t{0};

struct Sliver {
    std::uint64_t edge; // the longest side of the sliver
    std::int32_t face;
    bool forward;             // True if the sliver runs through `edge` from the lower to the higher vertex.
    std::int32_t across = -1; // a face on the other side of the longest side, or -1
    // True if `across` runs through the side in the other direction, as a neighbour with the same orientation does.
    bool agrees = false;
};

[[nodiscard]] std::uint64_t edge_of(std::int32_t a, std::int32_t b) noexcept {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    return low << 32U | static_cast<std::uint64_t>(std::max(a, b));
}

// Returns which side of a sliver is the longest (0, 1 or 2), or -1 if the face is not a sliver.
[[nodiscard]] int sliver_side(const Welded& welded, const Triangle& t, double rounding) noexcept {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return -1;
    const std::array<glm::dvec3, 3> p{welded.vertex[t[0]], welded.vertex[t[1]], welded.vertex[t[2]]};
    int longest = 0;
    double length = 0.0;
    for (int k = 0; k < 3; ++k) {
        const auto from = static_cast<std::size_t>(k);
        const double one = glm::distance(p[from], p[(from + 1) % 3]);
        if (one <= length) continue;
        length = one;
        longest = k;
    }
    const double height = glm::length(doubled_area(p)) / length;
    return height <= std::min(rounding, mesh_tuning.flattest * length) ? longest : -1;
}

// Merges the two ends of a sliver's side if the side is no longer than the rounding error.
void join_ends(Welded& welded, double rounding) {
    UnionFind places(welded.vertex.memory(), welded.vertex.size());
    for (const Triangle& t : welded.triangle)
        for (std::size_t k = 0; k < 3 && sliver_side(welded, t, rounding) >= 0; ++k)
            if (glm::distance(welded.vertex[t[k]], welded.vertex[t[(k + 1) % 3]]) <= rounding)
                places.join(t[k], t[(k + 1) % 3]);
    rename_corners(places, welded);
}

// Keeps the better of two faces across the longest side of a sliver. A face with the same orientation as the sliver is
// better. Otherwise the face whose index is closer to the sliver's index is better: where solids touch, several faces
// share the side, and in most files the faces of a solid have consecutive indices.
void take_across(Sliver& sliver, std::int32_t face, bool forward) noexcept {
    if (sliver.face == face) return;
    const bool agrees = forward != sliver.forward;
    const auto off = [&](std::int32_t other) { return std::abs(std::int64_t{other} - sliver.face); };
    const bool better =
        sliver.across < 0 || (agrees && !sliver.agrees) || (agrees == sliver.agrees && off(face) < off(sliver.across));
    if (!better) return;
    sliver.across = face;
    sliver.agrees = agrees;
}

// Returns the slivers, sorted by longest side. Sets `longest` of each face to its longest side, or to no_edge if the
// face is not a sliver.
[[nodiscard]] base::Array<Sliver> find_slivers(const Welded& welded, double rounding,
                                               base::Array<std::uint64_t>& longest, const base::Progress& progress) {
    base::Array<Sliver> found(welded.vertex.memory());
    for (const auto face : progress.over(static_cast<std::int32_t>(welded.triangle.size()))) {
        const Triangle& t = welded.triangle[face];
        const int side = sliver_side(welded, t, rounding);
        longest[face] = no_edge;
        if (side < 0) continue;
        const auto k = static_cast<std::size_t>(side);
        longest[face] = edge_of(t[k], t[(k + 1) % 3]);
        found.push_back({longest[face], face, t[k] < t[(k + 1) % 3]});
    }
    std::sort(found.begin(), found.end(),
              [](const Sliver& a, const Sliver& b) { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
    for (std::int32_t face = 0; face < welded.triangle.size() && !found.empty(); ++face) {
        progress.check();
        const Triangle& t = welded.triangle[face];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t edge = edge_of(t[k], t[(k + 1) % 3]);
            auto at = std::lower_bound(found.begin(), found.end(), edge,
                                       [](const Sliver& one, std::uint64_t wanted) { return one.edge < wanted; });
            for (; at != found.end() && at->edge == edge; ++at) take_across(*at, face, t[k] < t[(k + 1) % 3]);
        }
    }
    return found;
}

// Cuts the faces across the longest sides of slivers. Returns the number of faces that were cut.
[[nodiscard]] std::int64_t split_across(const base::Array<Sliver>& slivers, const base::Array<std::uint64_t>& longest,
                                        Welded& welded) {
    base::Array<std::uint8_t> changed(welded.vertex.memory(), welded.triangle.size());
    std::int64_t split = 0;
    for (const Sliver& sliver : slivers) {
        if (sliver.across < 0 || changed[sliver.face] != 0 || changed[sliver.across] != 0) continue;
        // If the face across is a sliver with another longest side, it must be cut at that side first. Otherwise the
        // two slivers would be cut for ever.
        if (longest[sliver.across] != no_edge && longest[sliver.across] != sliver.edge) continue;
        const auto a = static_cast<std::int32_t>(sliver.edge >> 32U);
        const auto b = static_cast<std::int32_t>(sliver.edge & 0xFFFFFFFFU);
        const Triangle& flat = welded.triangle[sliver.face];
        const std::int32_t middle =
            *std::find_if(flat.begin(), flat.end(), [&](std::int32_t v) { return v != a && v != b; });
        const Triangle whole = welded.triangle[sliver.across];
        // The sliver lies on the face across, so no cut is needed.
        if (std::find(whole.begin(), whole.end(), middle) != whole.end()) continue;
        const auto half_with_middle_for = [&](std::int32_t end) {
            Triangle half = whole;
            std::replace(half.begin(), half.end(), end, middle);
            return half;
        };
        welded.triangle[sliver.across] = half_with_middle_for(a);
        welded.triangle[sliver.face] = half_with_middle_for(b);
        welded.given_face[sliver.face] = welded.given_face[sliver.across];
        changed[sliver.face] = changed[sliver.across] = 1;
        ++split;
    }
    return split;
}

void split_slivers(double rounding, Welded& welded, MeshReport& report, const base::Progress& progress) {
    join_ends(welded, rounding);
    base::Array<std::uint64_t> longest(welded.vertex.memory(), welded.triangle.size());
    // Each round makes the longest sides shorter.
    for (int round = 0; round < mesh_tuning.most_sliver_rounds; ++round) {
        const base::Array<Sliver> slivers = find_slivers(welded, rounding, longest, progress);
        const std::int64_t split = split_across(slivers, longest, welded);
        report.degenerate_faces += split;
        if (split == 0) return;
    }
}

// ---- Faces without area, and repeated faces

// Counts the given faces that have the same corners as a kept face.
struct Repeated {
    std::int32_t balance = 0; // the number of equal faces with one orientation, minus the number with the other
    std::int32_t last = -1;   // the index of the last given face with these corners
};

[[nodiscard]] Triangle sorted(Triangle t) noexcept {
    std::sort(t.begin(), t.end());
    return t;
}

// Returns 1 if the corners are an even permutation of their sorted order, else -1.
[[nodiscard]] std::int32_t sense(const Triangle& t) noexcept {
    const int turns = (t[0] > t[1] ? 1 : 0) + (t[1] > t[2] ? 1 : 0) + (t[0] > t[2] ? 1 : 0);
    return turns % 2 == 0 ? 1 : -1;
}

[[nodiscard]] base::Array<Repeated> leave_out_faces(Welded& welded, MeshReport& report,
                                                    const base::Progress& progress) {
    base::Array<Repeated> repeated(welded.vertex.memory());
    HashNumbering numbers(welded.vertex.memory(), welded.triangle.size());
    std::int64_t kept = 0;
    for (const std::int64_t face : progress.over(welded.triangle.size())) {
        const Triangle t = welded.triangle[face];
        const glm::dvec3 area = doubled_area({welded.vertex[t[0]], welded.vertex[t[1]], welded.vertex[t[2]]});
        // A face also has no normal if the square of its area is too small for a double.
        if (!(glm::dot(area, area) >= std::numeric_limits<double>::min())) {
            ++report.degenerate_faces;
            continue;
        }
        const Triangle key = sorted(t);
        const std::uint64_t hash =
            hash_of(hash_of(static_cast<std::uint64_t>(key[0]) << 32U | static_cast<std::uint64_t>(key[1])) ^
                    static_cast<std::uint64_t>(key[2]));
        const std::int64_t found =
            numbers.find_or_add(hash, kept, [&](std::int64_t k) { return sorted(welded.triangle[k]) == key; });
        if (found != kept) {
            repeated[found].balance += sense(t);
            repeated[found].last = welded.given_face[face];
            ++report.repeated_faces;
            continue;
        }
        repeated.push_back({sense(t)});
        welded.triangle[kept] = t;
        welded.given_face[kept++] = welded.given_face[face];
    }
    welded.triangle.resize(kept);
    welded.given_face.resize(kept);
    return repeated;
}

// ---- The faces about an edge

struct FaceAtEdge {
    const Side* side;
    // The angle about the edge, measured from the first face, in units of 1 / parts_of_radian radians, above -pi and up
    // to pi.
    std::int64_t angle;
    double rounding; // the largest error of the angle
};

constexpr double parts_of_radian = 1e7;

// Converts an angle in radians to units of 1 / parts_of_radian radians. -pi becomes pi, which is the same direction.
[[nodiscard]] std::int64_t in_parts(double angle) noexcept {
    const std::int64_t half = std::llround(parts_of_radian * std::numbers::pi);
    const std::int64_t parts = std::llround(parts_of_radian * angle);
    return parts <= -half ? half : parts;
}

void measure_about(const Welded& welded, double rounding, const Side* first, const Side* last,
                   base::Array<FaceAtEdge>& about) {
    const glm::dvec3 from = welded.vertex[low_end(*first)];
    const glm::dvec3 axis = glm::normalize(welded.vertex[high_end(*first)] - from);
    about.clear();
    glm::dvec3 zero(0.0);
    for (const Side* side = first; side != last; ++side) {
        const std::int64_t number = number_of(welded.triangle, *side);
        const glm::dvec3 way =
            welded.vertex[welded.triangle[side->face][static_cast<std::size_t>((number + 2) % 3)]] - from;
        const glm::dvec3 up = way - glm::dot(way, axis) * axis;
        const double height = glm::length(up);
        const glm::dvec3 off = up / height;
        if (side == first) zero = off;
        about.push_back({side, in_parts(std::atan2(glm::dot(glm::cross(axis, zero), off), glm::dot(zero, off))),
                         parts_of_radian * std::min(rounding / height, mesh_tuning.most_angle_rounding)});
    }
}

// Returns whether both faces have the same angle about the edge, up to rounding.
[[nodiscard]] bool lie_on_each_other(const FaceAtEdge& a, const FaceAtEdge& b) noexcept {
    const std::int64_t half = in_parts(std::numbers::pi);
    const std::int64_t apart = half - std::abs(half - std::abs(a.angle - b.angle));
    return static_cast<double>(apart) <= a.rounding + b.rounding;
}

// Returns the difference between the angle of two faces and a straight angle.
[[nodiscard]] std::int64_t bend(const FaceAtEdge& a, const FaceAtEdge& b) noexcept {
    return std::abs(std::abs(a.angle - b.angle) - in_parts(std::numbers::pi));
}

// ---- Walls: faces that two solids share, as two boxes do that stand side by side

enum class OppositeFace : std::uint8_t {
    none = 0, // neither a wall nor a contact
    wall = 1,
    contact = 2 // solids touch here and in the faces beyond
};

// Returns the kind of each face. Faces that were given equally often in both orientations are twins. Only twins can be
// walls or contacts. A region of connected twins is a wall if other faces meet it at edges, and if it has no free edge.
// A thin leaf with two sides, and a solid given in both orientations, meet no other faces. A region is a contact if, in
// addition, two of the other faces coincide in different triangles.
[[nodiscard]] base::Array<OppositeFace> find_walls(const base::Work& work, const Welded& welded,
                                                   const base::Array<Repeated>& repeated, double rounding) {
    constexpr unsigned ends = 1;    // The region has a free edge, with fewer than two other faces.
    constexpr unsigned meets = 2;   // The region meets two or more other faces.
    constexpr unsigned goes_on = 4; // Two of the other faces coincide and face each other.
    const std::int64_t faces = welded.triangle.size();
    const auto is_twin = [&](const Side& side) { return repeated[side.face].balance == 0; };
    UnionFind sheets(work.memory, faces);
    base::Array<FaceAtEdge> about(work.memory);
    base::Array<std::uint8_t> at(work.memory, faces);
    const auto others_touch = [&](const Side* first, const Side* last) {
        measure_about(welded, rounding, first, last, about);
        for (std::int64_t i = 0; i < about.size(); ++i)
            for (std::int64_t k = i + 1; k < about.size(); ++k) {
                const bool others = !is_twin(*about[i].side) && !is_twin(*about[k].side);
                const bool against = about[i].side->forward != about[k].side->forward;
                if (others && against && lie_on_each_other(about[i], about[k])) return true;
            }
        return false;
    };
    for_edges(sides_by_edge(work, welded.triangle), work, [&](const Side* first, const Side* last) {
        const Side* one = nullptr;
        std::int64_t twins = 0;
        for (const Side* side = first; side != last; ++side) {
            if (!is_twin(*side)) continue;
            if (one != nullptr) sheets.join(one->face, side->face);
            one = side;
            ++twins;
        }
        if (one == nullptr) return;
        const bool others = last - first - twins >= 2;
        const unsigned found = (twins == 1 && !others ? ends : 0U) | (others ? meets : 0U) |
                               (others && others_touch(first, last) ? goes_on : 0U);
        at[one->face] = static_cast<std::uint8_t>(at[one->face] | found);
    });
    base::Array<std::uint8_t> of_sheet(work.memory, faces);
    for (std::int64_t face = 0; face < faces; ++face) {
        std::uint8_t& all = of_sheet[sheets.find(static_cast<std::int32_t>(face))];
        all = static_cast<std::uint8_t>(all | at[face]);
    }
    base::Array<OppositeFace> result(work.memory, faces);
    for (std::int64_t face = 0; face < faces; ++face) {
        if (repeated[face].balance != 0) continue;
        const unsigned found = of_sheet[sheets.find(static_cast<std::int32_t>(face))];
        if ((found & meets) == 0 || (found & ends) != 0) continue;
        result[face] = (found & goes_on) != 0 ? OppositeFace::contact : OppositeFace::wall;
    }
    return result;
}

// Drops walls between solids, because they are never visible. If two solids also touch beyond their shared faces, in
// faces that coincide without being the same triangles, each solid keeps the shared faces as well.
void leave_out_walls(const base::Work& work, const base::Array<Repeated>& repeated, double rounding, Welded& welded,
                     MeshReport& report) {
    if (report.repeated_faces == 0) return;
    const base::Array<OppositeFace> kind = find_walls(work, welded, repeated, rounding);
    Welded other_sides(work.memory); // the faces on the second side of contacts
    std::int64_t kept = 0;
    for (std::int64_t face = 0; face < kind.size(); ++face) {
        if (kind[face] == OppositeFace::wall) {
            ++report.repeated_faces;
            continue;
        }
        const Triangle t = welded.triangle[face];
        if (kind[face] == OppositeFace::contact) {
            --report.repeated_faces;
            other_sides.triangle.push_back({t[0], t[2], t[1]});
            other_sides.given_face.push_back(repeated[face].last);
        }
        welded.triangle[kept] = t;
        welded.given_face[kept++] = welded.given_face[face];
    }
    welded.triangle.resize(kept);
    welded.given_face.resize(kept);
    for (const Triangle& t : other_sides.triangle) welded.triangle.push_back(t);
    for (const std::int32_t given : other_sides.given_face) welded.given_face.push_back(given);
}

// ---- Edges and corners in which solids touch

// Orders faces that have the same angle about the edge, up to rounding. The face that ends a solid then comes before
// the face that begins the next solid.
void end_before_begin(base::Array<FaceAtEdge>& about) noexcept {
    for (std::int64_t turns = 0; turns < about.size(); ++turns) {
        bool moved = false;
        for (std::int64_t i = 0; i < about.size(); ++i) {
            FaceAtEdge& one = about[i];
            FaceAtEdge& next = about[(i + 1) % about.size()];
            const bool ends = next.side->forward != 0 && one.side->forward == 0;
            if (!ends || !lie_on_each_other(one, next)) continue;
            std::swap(one.side, next.side);
            moved = true;
        }
        if (!moved) return;
    }
}

// Pairs four faces so that the edge bends least. Solids that cross each other at the edge then continue straight on, as
// flat faces do where two round solids touch along a line. Returns false if there are not two faces of each
// orientation.
[[nodiscard]] bool pair_flattest(base::Array<FaceAtEdge>& about) {
    std::sort(about.begin(), about.end(), [](const FaceAtEdge& a, const FaceAtEdge& b) {
        if (a.side->forward != b.side->forward) return a.side->forward < b.side->forward;
        return a.side->face < b.side->face;
    });
    if (about.size() != 4 || about[1].side->forward != 0 || about[2].side->forward == 0) return false;
    const bool crossed =
        bend(about[0], about[3]) + bend(about[1], about[2]) < bend(about[0], about[2]) + bend(about[1], about[3]);
    std::swap(about[1], about[crossed ? 3 : 2]);
    return true;
}

// Sorts the faces about an edge into pairs, beginning with the first face. A solid is between the faces of a pair.
// Returns false if the pairs are not clear.
[[nodiscard]] bool pair_about(base::Array<FaceAtEdge>& about) {
    std::sort(about.begin(), about.end(), [](const FaceAtEdge& a, const FaceAtEdge& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.side->face < b.side->face;
    });
    end_before_begin(about);
    for (std::int64_t i = 0; i < about.size(); ++i)
        if (about[i].side->forward == about[(i + 1) % about.size()].side->forward) return pair_flattest(about);
    // If a face runs through the edge backward, the solid beside it comes after it in the order of angles. Its partner
    // is then the next face, not the one before.
    if (about[0].side->forward != 0) std::rotate(about.begin(), about.begin() + 1, about.end());
    return true;
}

// Gives each set of corners at a vertex a separate vertex. The first set keeps the existing vertex.
void assign_vertices(UnionFind& corners, const base::Array<std::uint8_t>& parted, Welded& welded,
                     const base::Progress& progress) {
    base::Memory& memory = welded.vertex.memory();
    base::Array<std::int32_t> owner(memory, welded.vertex.size()); // for each vertex: 1 + the set that keeps it
    base::Array<std::int32_t> own(memory, 3 * welded.triangle.size());
    for (const std::int64_t corner : progress.over(own.size())) {
        std::int32_t& at = welded.triangle[corner / 3][static_cast<std::size_t>(corner % 3)];
        if (parted[at] == 0) continue;
        const std::int32_t set = corners.find(static_cast<std::int32_t>(corner));
        if (owner[at] == 0) owner[at] = set + 1;
        if (owner[at] == set + 1) continue;
        if (own[set] == 0) {
            own[set] = static_cast<std::int32_t>(welded.vertex.size());
            welded.vertex.push_back(welded.vertex[at]);
        }
        at = own[set];
    }
}

// Separates solids that share an edge or a vertex. Where an edge has four or more faces, the two faces of each solid
// get a separate edge, with new vertices at the same places, so that each solid is closed. Solids that share only a
// vertex also get separate vertices, unless a border passes there. The solids are then separate components, and later
// steps test whether they touch.
void separate_solids_at_edges(const base::Work& work, double rounding, Welded& welded) {
    const base::Array<Side> sides = sides_by_edge(work, welded.triangle);
    UnionFind corners(work.memory, 3 * welded.triangle.size()); // the sets of corners that share a vertex
    base::Array<std::uint8_t> parted(work.memory, welded.vertex.size());
    std::fill(parted.begin(), parted.end(), std::uint8_t{1});
    for_edges(sides, work, [&](const Side* first, const Side* last) {
        if (last - first == 1) parted[low_end(*first)] = parted[high_end(*first)] = 0;
    });
    const auto join = [&](const Side& a, const Side& b) {
        for (const std::int32_t end : {low_end(a), high_end(a)})
            corners.join(static_cast<std::int32_t>(corner_at(welded.triangle, a.face, end)),
                         static_cast<std::int32_t>(corner_at(welded.triangle, b.face, end)));
    };
    base::Array<FaceAtEdge> about(work.memory);
    for_edges(sides, work, [&](const Side* first, const Side* last) {
        if (last - first >= 4) {
            measure_about(welded, rounding, first, last, about);
            if (pair_about(about)) {
                for (std::int64_t i = 0; i < about.size(); i += 2) join(*about[i].side, *about[i + 1].side);
                parted[low_end(*first)] = parted[high_end(*first)] = 1;
                return;
            }
        }
        for (const Side* side = first + 1; side != last; ++side) join(*first, *side);
    });
    assign_vertices(corners, parted, welded, work);
}

} // namespace

Welded weld(const base::Work& work, const MeshInput& input, MeshReport& report) {
    Welded welded(work.memory);
    report.given_vertices = input.vertices.count;
    report.given_faces = input.triangles.count;
    welded.triangle = read_triangles(work, input);
    welded.given_face.resize_for_overwrite(welded.triangle.size());
    std::iota(welded.given_face.begin(), welded.given_face.end(), 0);
    join_vertices(input.vertices, welded, report, work);
    join_borders(work, welded, report);
    double largest = 0.0;
    for (const glm::dvec3& p : welded.vertex)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double rounding = mesh_tuning.coordinate_rounding * largest;
    split_slivers(rounding, welded, report, work);
    const base::Array<Repeated> repeated = leave_out_faces(welded, report, work);
    leave_out_walls(work, repeated, rounding, welded, report);
    separate_solids_at_edges(work, rounding, welded);
    if (welded.triangle.empty())
        fail(Status::invalid_argument, "triangles has %lld faces, but none has an area; give at least one that has",
             static_cast<long long>(report.given_faces));
    return welded;
}

} // namespace hrbfnpr::mesh

// SPDX-License-Identifier: MIT
// find_groups() first labels the connected parts of a mesh. Two faces are connected if they share an edge that no third
// face uses. Then it joins all closed parts into one part, and joins open parts that have a common seam. Last, it finds
// parts that are near each other, and puts them into different groups.
#include "picture/apart.h"

#include "api/mesh.h"
#include "base/assert.h"
#include "base/random.h"
#include "mesh/edges.h"
#include "mesh/plan.h"
#include "picture/tuning_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::picture {
namespace {

using Pair = std::array<std::int64_t, 2>;

const glm::dvec3& corner_of(const Points& points, const Triangle& face, std::size_t k) noexcept {
    return points[static_cast<std::size_t>(face[k])];
}

// ---- Labels

// The connected component of each element. Components are numbered from 0 in the order of their first elements.
struct Labels {
    Vector<std::int64_t> of;
    std::int64_t count;
};

Labels labels_of(const Vector<Pair>& joined, std::int64_t count, Pool& pool) {
    mesh::UnionFind sets(pool.memory(), count);
    for (const Pair& pair : joined) sets.join(static_cast<std::int32_t>(pair[0]), static_cast<std::int32_t>(pair[1]));
    Labels labels{Vector<std::int64_t>(&pool), 0};
    labels.of.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t least = sets.find(static_cast<std::int32_t>(i));
        labels.of.push_back(least == i ? labels.count++ : labels.of[static_cast<std::size_t>(least)]);
    }
    return labels;
}

std::size_t label_at(const Labels& labels, std::size_t i) noexcept { return static_cast<std::size_t>(labels.of[i]); }

// Labels the connected components of the faces. Two faces are connected if they share an edge of exactly two faces.
// Edges of three or more faces connect nothing, because surfaces cross there.
Labels labels_of_faces(const FaceEdges& edges, Pool& pool) {
    Vector<Pair> joined(&pool);
    for (const PlainEdge& plain : plain_edges(edges, pool))
        joined.push_back({static_cast<std::int64_t>(plain.one), static_cast<std::int64_t>(plain.other)});
    return labels_of(joined, edges.faces, pool);
}

// The number of faces and the area of each part.
struct Sizes {
    Vector<std::int64_t> faces;
    Vector<double> area;
};

Sizes sizes_of(const Labels& labels, const Vector<double>& areas, Pool& pool) {
    const auto count = static_cast<std::size_t>(labels.count);
    Sizes sizes{Vector<std::int64_t>(count, 0, &pool), Vector<double>(count, 0.0, &pool)};
    for (std::size_t f = 0; f < areas.size(); ++f) {
        ++sizes.faces[label_at(labels, f)];
        sizes.area[label_at(labels, f)] += areas[f];
    }
    return sizes;
}

// Returns 1 for each part that is too small for a separate surface.
Vector<std::uint8_t> small_parts(const Sizes& sizes, Pool& pool) {
    const double area = sum_in_pairs(sizes.area);
    Vector<std::uint8_t> little(&pool);
    for (std::size_t part = 0; part < sizes.area.size(); ++part)
        little.push_back(mesh::is_flap(sizes.faces[part], sizes.area[part], area) ? 1 : 0);
    return little;
}

// ---- Parts near each other

// Places on a mesh, each with the part that it lies on.
struct PlacesOnParts {
    explicit PlacesOnParts(Pool& pool) : place(&pool), part(&pool) {}

    Points place;
    Vector<std::int64_t> part;
};

struct CellPlace {
    std::array<std::int64_t, 3> cell;
    std::size_t place;
};

std::int64_t cell_number(double x) noexcept {
    constexpr double limit = 9e18; // Cell indices below this magnitude fit in 64 bits.
    const double lower = std::floor(x);
    return std::abs(lower) < limit ? static_cast<std::int64_t>(lower) : std::numeric_limits<std::int64_t>::min();
}

// Calls visit(span of CellPlace) with the places of each grid cell that holds places of several parts. There are eight
// grids of cubes whose edges have the length `side`. Each grid is shifted by 0 or half an edge along each axis. So any
// two places that are less than half an edge apart lie in one cube of at least one grid.
template <class Visit>
void for_meetings(const PlacesOnParts& places, double side, Pool& pool, Visit&& visit) {
    Vector<CellPlace> cells(places.place.size(), CellPlace{}, &pool);
    for (int shift = 0; shift < 8; ++shift) {
        const glm::dvec3 offset = 0.5 * glm::dvec3(shift & 1, shift >> 1 & 1, shift >> 2);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const glm::dvec3 at_cell = places.place[i] / side + offset;
            cells[i] = {{cell_number(at_cell.x), cell_number(at_cell.y), cell_number(at_cell.z)}, i};
        }
        std::sort(cells.begin(), cells.end(), [](const CellPlace& a, const CellPlace& b) {
            return a.cell < b.cell || (a.cell == b.cell && a.place < b.place);
        });
        for (auto begin = cells.begin(); begin != cells.end();) {
            auto end = begin;
            bool several = false;
            for (; end != cells.end() && end->cell == begin->cell; ++end)
                several = several || places.part[end->place] != places.part[begin->place];
            if (several) visit(std::span<const CellPlace>(&*begin, static_cast<std::size_t>(end - begin)));
            begin = end;
        }
    }
}

// A set of pairs of parts. The order of a pair does not matter.
class PairsOfParts {
public:
    PairsOfParts(std::int64_t count, Pool& pool)
        : count_(static_cast<std::size_t>(count)), is_pair_(count_ * count_, 0, &pool) {}

    void add(std::int64_t a, std::int64_t b) noexcept { is_pair_[index(a, b)] = is_pair_[index(b, a)] = 1; }
    [[nodiscard]] bool has(std::size_t a, std::size_t b) const noexcept { return is_pair_[a * count_ + b] != 0; }

private:
    [[nodiscard]] std::size_t index(std::int64_t a, std::int64_t b) const noexcept {
        return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b);
    }

    std::size_t count_;
    Vector<std::uint8_t> is_pair_;
};

// Lists the parts that have places in a cell, each part once.
void list_parts(std::span<const CellPlace> cell, const PlacesOnParts& places, Vector<std::int64_t>& parts) {
    parts.clear();
    for (const CellPlace& one : cell) parts.push_back(places.part[one.place]);
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
}

// Spreads random places over all faces: at least one on each face, and more on larger faces.
PlacesOnParts spread_places(const Points& points, const Vector<Triangle>& faces, const Vector<double>& areas,
                            const Labels& labels, Pool& pool) {
    constexpr std::uint64_t seed = 1;
    constexpr double least_area = 1e-300;
    const double area = std::max(sum_in_pairs(areas), least_area);
    PlacesOnParts places(pool);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto count = 1 + static_cast<std::int64_t>(std::floor(apart_tuning.places * areas[f] / area));
        const glm::dvec3& a = corner_of(points, faces[f], 0);
        for (std::int64_t i = 0; i < count; ++i) {
            const auto random = base::uniform4(seed, places.place.size(), base::Purpose::probe);
            const bool outside = random[0] + random[1] > 1.0;
            const double u = outside ? 1.0 - random[0] : random[0];
            const double v = outside ? 1.0 - random[1] : random[1];
            places.place.push_back(a + u * (corner_of(points, faces[f], 1) - a) +
                                   v * (corner_of(points, faces[f], 2) - a));
            places.part.push_back(labels.of[f]);
        }
    }
    return places;
}

// Returns the pairs of parts whose distance is less than `reach`. Some pairs at distances up to 3.5 times `reach` are
// included too.
PairsOfParts near_parts(const PlacesOnParts& places, std::int64_t count, double reach, Pool& pool) {
    PairsOfParts near(count, pool);
    Vector<std::int64_t> parts(&pool);
    for_meetings(places, 2.0 * reach, pool, [&](std::span<const CellPlace> cell) {
        list_parts(cell, places, parts);
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) near.add(parts[i], parts[j]);
    });
    return near;
}

// ---- Seams

// Places along the borders of all parts.
struct BorderPlaces {
    explicit BorderPlaces(Pool& pool) : on(pool), normal(&pool), inward(&pool), weight(&pool) {}

    PlacesOnParts on;
    Points normal;         // The normal of the face at each place.
    Points inward;         // The direction into the face, perpendicular to the border.
    Vector<double> weight; // The length of border that each place represents.
    double step = 0.0;     // The approximate distance between neighbouring places.
};

struct BorderEdge {
    std::size_t edge;
    std::size_t face; // The first face that has the edge.
};

Vector<BorderEdge> border_edges(const FaceEdges& edges, Pool& pool) {
    Vector<BorderEdge> border(&pool);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (!edges.is_plain(e)) border.push_back({e, edges.face(edges.sides_of(e).front())});
    return border;
}

BorderPlaces places_on_borders(const Points& points, const Vector<Triangle>& faces, const FaceEdges& edges,
                               const Vector<BorderEdge>& border, const Labels& labels, double reach, Pool& pool) {
    BorderPlaces places(pool);
    Vector<double> length(&pool);
    const auto end_of = [&](const BorderEdge& one, std::size_t k) -> const glm::dvec3& {
        return points[static_cast<std::size_t>(edges.ends[one.edge][k])];
    };
    for (const BorderEdge& one : border) length.push_back(glm::length(end_of(one, 1) - end_of(one, 0)));
    places.step = std::max(reach / 2.0, sum_in_pairs(length) / apart_tuning.places);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const double count = std::max(1.0, std::ceil(length[i] / places.step));
        const Triangle& face = faces[border[i].face];
        const glm::dvec3 normal = unit_or_zero(doubled_area_of(points, face));
        const glm::dvec3 middle =
            (corner_of(points, face, 0) + corner_of(points, face, 1) + corner_of(points, face, 2)) / 3.0;
        const glm::dvec3 along = unit_or_zero(end_of(border[i], 1) - end_of(border[i], 0));
        const glm::dvec3 in = middle - end_of(border[i], 0);
        const glm::dvec3 inward = unit_or_zero(in - glm::dot(in, along) * along);
        for (double k = 0.0; k < count; k += 1.0) {
            const glm::dvec3& from = end_of(border[i], 0);
            places.on.place.push_back(from + (k + 0.5) / count * (end_of(border[i], 1) - from));
            places.on.part.push_back(labels.of[border[i].face]);
            places.normal.push_back(normal);
            places.inward.push_back(inward);
            places.weight.push_back(length[i] / count);
        }
    }
    return places;
}

// A place on the border of the part `part`, close to the border of the part `other`.
struct BorderNeighbour {
    std::int64_t part, other;
    std::size_t place;
    [[nodiscard]] auto operator<=>(const BorderNeighbour&) const = default;
};

void add_border_neighbours(std::span<const CellPlace> cell, const BorderPlaces& places,
                           Vector<BorderNeighbour>& found) {
    for (const CellPlace& one : cell) {
        const std::int64_t part = places.on.part[one.place];
        // The neighbouring part that was added last. It is not added again, which saves time: consecutive places of a
        // cell often lie on one part.
        std::int64_t last = part;
        for (const CellPlace& two : cell) {
            const std::int64_t other = places.on.part[two.place];
            if (other == part || other == last) continue;
            const double alike = glm::dot(places.normal[one.place], places.normal[two.place]);
            if (!(std::abs(alike) > apart_tuning.seam_cosine)) continue;
            // The skins of a wall face away from each other, and lie on the same side of their borders. Neither of them
            // continues the other.
            if (alike < 0.0 && glm::dot(places.inward[one.place], places.inward[two.place]) > 0.0) continue;
            found.push_back({part, other, one.place});
            last = other;
        }
    }
}

// Returns the pairs of parts that have a common seam: a large share of the first part's border runs along the border of
// the second part. Two such parts are one surface that was cut.
Vector<Pair> seams_between(const BorderPlaces& places, std::int64_t count, double reach, Pool& pool) {
    Vector<double> border(static_cast<std::size_t>(count), 0.0, &pool); // The border length of each part.
    for (std::size_t i = 0; i < places.weight.size(); ++i)
        border[static_cast<std::size_t>(places.on.part[i])] += places.weight[i];
    Vector<BorderNeighbour> beside(&pool);
    for_meetings(places.on, 2.0 * std::max(reach, places.step), pool,
                 [&](std::span<const CellPlace> cell) { add_border_neighbours(cell, places, beside); });
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    Vector<Pair> seams(&pool);
    for (auto begin = beside.begin(); begin != beside.end();) {
        double length = 0.0;
        auto end = begin;
        for (; end != beside.end() && end->part == begin->part && end->other == begin->other; ++end)
            length += places.weight[end->place];
        if (length > apart_tuning.seam_share * border[static_cast<std::size_t>(begin->part)])
            seams.push_back({begin->part, begin->other});
        begin = end;
    }
    return seams;
}

// ---- Groups

// Joins all closed parts. Closed parts that cross are solids, and one function can represent their union.
void join_solids(const Vector<BorderEdge>& border, const Labels& labels, Vector<Pair>& joined, Pool& pool) {
    Vector<std::uint8_t> is_open(static_cast<std::size_t>(labels.count), 0, &pool);
    for (const BorderEdge& one : border) is_open[label_at(labels, one.face)] = 1;
    std::int64_t first = -1;
    for (std::int64_t part = 0; part < labels.count; ++part) {
        if (is_open[static_cast<std::size_t>(part)] != 0) continue;
        if (first < 0)
            first = part;
        else
            joined.push_back({first, part});
    }
}

// Assigns a group to each part, from the largest part to the smallest. A part joins the first group whose parts are all
// far from this part, or the last allowed group. Parts marked in `little` join the first group.
Vector<std::int64_t> groups_of_parts(const Vector<double>& area, const PairsOfParts& near,
                                     const Vector<std::uint8_t>& little, Pool& pool) {
    Vector<std::size_t> order(area.size(), 0, &pool);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return area[a] > area[b]; });
    Vector<std::int64_t> group(area.size(), -1, &pool);
    Vector<std::uint8_t> taken(area.size() + 1, 0, &pool);
    for (const std::size_t part : order) {
        std::fill(taken.begin(), taken.end(), std::uint8_t{0});
        for (std::size_t other = 0; other < area.size() && little[part] == 0; ++other)
            if (near.has(part, other) && little[other] == 0 && group[other] >= 0)
                taken[static_cast<std::size_t>(group[other])] = 1;
        const auto free = std::find(taken.begin(), taken.end(), std::uint8_t{0}) - taken.begin();
        group[part] = std::min<std::int64_t>(free, apart_tuning.most_groups - 1);
    }
    return group;
}

double area_of_group(const FaceNumbers& group, const Vector<double>& areas, Pool& pool) {
    Vector<double> some(&pool);
    for (const std::int64_t face : group) some.push_back(areas[static_cast<std::size_t>(face)]);
    return sum_in_pairs(some);
}

Vector<FaceNumbers> faces_of_groups(const Vector<std::int64_t>& group, const Labels& labels,
                                    const Vector<double>& areas, Pool& pool) {
    const std::int64_t count = *std::max_element(group.begin(), group.end()) + 1;
    Vector<FaceNumbers> faces(static_cast<std::size_t>(count), &pool);
    for (std::size_t f = 0; f < areas.size(); ++f)
        faces[static_cast<std::size_t>(group[label_at(labels, f)])].push_back(static_cast<std::int64_t>(f));
    Vector<std::pair<double, std::size_t>> by_area(&pool);
    for (std::size_t i = 0; i < faces.size(); ++i) by_area.emplace_back(-area_of_group(faces[i], areas, pool), i);
    std::sort(by_area.begin(), by_area.end());
    Vector<FaceNumbers> sorted(&pool);
    sorted.reserve(faces.size());
    for (const auto& [area, i] : by_area) sorted.push_back(std::move(faces[i]));
    return sorted;
}

} // namespace

std::optional<FaceGroups> find_groups(const Mesh& mesh, Pool& pool) {
    if (!mesh::may_be_grouped(mesh.get()->mesh.report, mesh.get()->mesh.faces())) return std::nullopt;
    const Points points = vertices_of(mesh, pool);
    const Vector<Triangle> faces = triangles_of(mesh, pool);
    const FaceEdges edges = find_edges(faces, points.size(), pool);
    Labels labels = labels_of_faces(edges, pool);
    if (labels.count < 2 || labels.count > apart_tuning.most_parts) return std::nullopt;
    const double across = box_diagonal_of(points);
    const Vector<BorderEdge> border = border_edges(edges, pool);
    const double seam = apart_tuning.seam * across;
    Vector<Pair> joined =
        seams_between(places_on_borders(points, faces, edges, border, labels, seam, pool), labels.count, seam, pool);
    join_solids(border, labels, joined, pool);
    const Labels part = labels_of(joined, labels.count, pool);
    for (std::int64_t& label : labels.of) label = part.of[static_cast<std::size_t>(label)];
    labels.count = part.count;
    const Vector<double> areas = areas_of(points, faces, pool);
    const PairsOfParts near =
        near_parts(spread_places(points, faces, areas, labels, pool), labels.count, apart_tuning.near * across, pool);
    const Sizes sizes = sizes_of(labels, areas, pool);
    const Vector<std::int64_t> group = groups_of_parts(sizes.area, near, small_parts(sizes, pool), pool);
    FaceGroups found{faces_of_groups(group, labels, areas, pool), labels.count};
    if (found.groups.size() < 2) return std::nullopt;
    return found;
}

FaceNumbers find_flaps(const Mesh& mesh, Pool& pool) {
    FaceNumbers flaps(&pool);
    if (info_of(mesh).nonmanifold_edges == 0) return flaps;
    const Points points = vertices_of(mesh, pool);
    const Vector<Triangle> faces = triangles_of(mesh, pool);
    const FaceEdges edges = find_edges(faces, points.size(), pool);
    const Labels labels = labels_of_faces(edges, pool);
    const Vector<std::uint8_t> little = small_parts(sizes_of(labels, areas_of(points, faces, pool), pool), pool);
    Vector<std::uint8_t> hangs(little.size(), 0, &pool);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges.sides_of(e);
        const auto part_of = [&](std::int64_t side) { return label_at(labels, edges.face(side)); };
        const auto is_part = [&](std::int64_t side) { return little[part_of(side)] == 0; };
        if (sides.size() <= 2 || std::none_of(sides.begin(), sides.end(), is_part)) continue;
        for (const std::int64_t side : sides) hangs[part_of(side)] = 1;
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (little[label_at(labels, f)] != 0 && hangs[label_at(labels, f)] != 0)
            flaps.push_back(static_cast<std::int64_t>(f));
    return flaps;
}

LostParts find_lost_parts(const Mesh& mesh, Pool& pool) {
    LostParts lost{FaceNumbers(&pool), 0};
    const hrbfnpr_mesh_info info = info_of(mesh);
    if (info.components - info.left_out_components < 2) return lost;
    const Points points = vertices_of(mesh, pool);
    const Vector<Triangle> faces = triangles_of(mesh, pool);
    const Vector<std::int32_t> part = numbers_of(mesh, HRBFNPR_MESH_ATTRIBUTE_COMPONENT, pool);
    const auto part_of = [&](std::size_t face) { return static_cast<std::size_t>(part[face]); };
    const std::size_t parts = static_cast<std::size_t>(*std::max_element(part.begin(), part.end())) + 1;
    Vector<double> area(parts, 0.0, &pool); // Twice the area of each part; 0 for parts that the mesh left out.
    for (std::size_t f = 0; f < faces.size(); ++f) area[part_of(f)] += glm::length(doubled_area_of(points, faces[f]));
    const double whole = sum_in_pairs(area);
    Vector<std::uint8_t> is_crumb(&pool);
    for (const double one : area) is_crumb.push_back(mesh::is_crumb(one, whole) ? 1 : 0);
    double of_crumbs = 0.0;
    for (std::size_t one = 0; one < parts; ++one) of_crumbs += is_crumb[one] != 0 ? area[one] : 0.0;
    if (!mesh::is_crumb(of_crumbs, whole)) return lost;
    geometry::Bounds kept;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3 && is_crumb[part_of(f)] == 0; ++k) kept.extend(corner_of(points, faces[f], k));
    if (kept.empty()) return lost;
    Vector<double> nearest(parts, std::numeric_limits<double>::infinity(), &pool);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        glm::dvec3 beyond(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& corner = corner_of(points, faces[f], k);
            beyond = glm::max(beyond, glm::max(kept.min - corner, corner - kept.max));
        }
        nearest[part_of(f)] = std::min(nearest[part_of(f)], glm::length(beyond));
    }
    Vector<std::uint8_t> is_lost(&pool);
    Vector<std::uint8_t> is_there(parts, 0, &pool);
    for (std::size_t one = 0; one < parts; ++one)
        is_lost.push_back(is_crumb[one] != 0 && mesh::is_lost(nearest[one] / kept.diagonal()) ? 1 : 0);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (is_lost[part_of(f)] == 0) continue;
        lost.faces.push_back(static_cast<std::int64_t>(f));
        if (std::exchange(is_there[part_of(f)], std::uint8_t{1}) == 0) ++lost.parts;
    }
    return lost;
}

} // namespace hrbfnpr::picture

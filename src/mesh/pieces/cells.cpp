// SPDX-License-Identifier: MIT
// The steps of make_cells(), in order:
//
//   SignedDistances   finds signed distances from the mesh
//   decide_cell       decides about a cell: without surface, with a tree over its sheets, or to be split
//     gather_tests    chooses places in the cell, and what f should be there
//     choose_tree     chooses the tree over the cell's sheets that fails the fewest tests
//   add_level         stores the cells of one level; those that are split make the next level
//   continue_surface  gives cells beyond the borders of an open mesh the trees of the nearest cells with surface
#include "mesh/pieces/cells.h"

#include "base/list.h"
#include "base/random.h"
#include "geometry/segment.h"
#include "mesh/edges.h"
#include "mesh/fit/outer.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hrbfnpr::mesh {
namespace {

using implicit::SheetTreeData;
using FaceList = base::Array<std::int32_t>;

// ---- The trees

struct Program {
    std::int32_t code[2 * ReadOnceTrees::most] = {};
    std::int32_t size = 0;

    void add(const Program& other) noexcept {
        for (std::int32_t i = 0; i < other.size; ++i) code[size++] = other.code[i];
    }
};
using Programs = base::Array<Program>;

// Adds to `to` all trees over a set of functions whose root is a maximum (`top` = 0) or a minimum (`top` = 1). Each bit
// of `set` is a function. topped(set, top) returns the trees over a smaller set; a single function counts as a tree
// with either root. The root joins two subtrees. The first subtree contains the lowest function; it is this function
// alone, or a tree with the opposite root. The second subtree is a single function, or a tree with either root.
template <class Topped>
void add_trees(std::uint32_t set, std::uint32_t top, Topped&& topped, Programs& to) {
    const std::uint32_t lowest = set & (~set + 1U);
    const std::uint32_t others = set & ~lowest;
    if (others == 0) {
        Program alone;
        while ((set >> static_cast<unsigned>(alone.code[0])) != 1U) ++alone.code[0];
        alone.size = 1;
        return to.push_back(alone);
    }
    const auto join = [&](const Program& a, const Program& b) {
        Program joined = a;
        joined.add(b);
        joined.code[joined.size++] = top == 0 ? SheetTreeData::maximum : SheetTreeData::minimum;
        to.push_back(joined);
    };
    for (std::uint32_t with = (others - 1) & others;; with = (with - 1) & others) {
        const std::uint32_t rest = others & ~with;
        for (const Program& part : topped(lowest | with, 1 - top)) {
            for (const Program& one : topped(rest, 1 - top)) join(part, one);
            if ((rest & (rest - 1)) == 0) continue;
            for (const Program& several : topped(rest, top)) join(part, several);
        }
        if (with == 0) return;
    }
}

// ---- Signed distances from the mesh

// The place on the mesh that is nearest to a given place.
struct NearestPlace {
    double distance = 0.0; // signed distance; below 0 is inside
    std::int64_t face = -1;
    glm::dvec3 place{0.0};
    bool inner = false; // true if the place is inside its face, not on an edge
};

// Finds whether places of a box are inside a solid. Rays find the winding numbers of three places of the box. Another
// place of the box has the same number, plus the signs of the faces between the two. These are found faster than the
// faces along a whole ray. The majority of the three decides, because a line may pass through an edge or a gap.
class InsideOfBox {
public:
    InsideOfBox(const FaceTree& faces, const glm::dvec3& centre, double half) noexcept : faces_(faces), reference_{} {
        constexpr double off_centre = 0.37; // in half sides of the box
        for (std::size_t k = 0; k < reference_.size(); ++k)
            reference_[k].place = centre + off_centre * half * ray_directions[k];
    }
    [[nodiscard]] const FaceTree& faces() const noexcept { return faces_; }
    [[nodiscard]] bool contains(const glm::dvec3& place) noexcept { return contains_free(place, 0.0); }
    // The same for a place from which the mesh is `free` away. Such a place is on the side of the last such place if no
    // face can be between the two.
    [[nodiscard]] bool contains(const glm::dvec3& place, double free) noexcept {
        if (!(glm::distance(place, last_) < 0.99 * std::max(free, last_free_)))
            last_inside_ = contains_free(place, free);
        last_ = place;
        last_free_ = free;
        return last_inside_;
    }

private:
    struct Reference {
        glm::dvec3 place{0.0};
        std::optional<int> winding; // found when it is needed
    };
    [[nodiscard]] bool contains_free(const glm::dvec3& place, double free) noexcept {
        const bool first = is_inside(reference_[0], place, free);
        const bool second = is_inside(reference_[1], place, free);
        return first == second ? first : is_inside(reference_[2], place, free);
    }
    [[nodiscard]] bool is_inside(Reference& from, const glm::dvec3& place, double free) noexcept {
        if (!from.winding) from.winding = winding_number(faces_, from.place);
        const bool is_near = glm::distance(from.place, place) < 0.99 * free;
        return *from.winding + (is_near ? 0 : faces_.winding_beyond(place, from.place)) > 0;
    }

    const FaceTree& faces_;
    std::array<Reference, 3> reference_;
    glm::dvec3 last_{0.0};
    double last_free_ = 0.0;
    bool last_inside_ = false;
};

// Finds on which side of the mesh a place lies. Usually the normal at the nearest place decides (Baerentzen and Aanaes,
// "Signed distance computation using the angle weighted pseudonormal", 2005). Rays decide if the mesh is solid and has
// several parts or is not closed, and where faces of a solid are folded upon each other, because normals are not
// reliable there.
class SignedDistances {
public:
    SignedDistances(const base::Work& work, const Mesh& mesh, const FaceTree& tree);

    [[nodiscard]] NearestPlace nearest_place(const glm::dvec3& place) const noexcept {
        return with_sign(place, tree_.nearest(place), [&](double) { return is_inside(tree_, place); });
    }
    // The same for a place of a box. `on_mesh` is any place on the mesh; the nearer it is, the faster is the search.
    [[nodiscard]] NearestPlace nearest_place(const glm::dvec3& place, const glm::dvec3& on_mesh,
                                             InsideOfBox& box) const noexcept {
        const glm::dvec3 off = place - on_mesh;
        constexpr double rounding = 1e-9; // relative
        return with_sign(place, box.faces().nearest(place, (1.0 + rounding) * glm::dot(off, off)),
                         [&](double free) { return box.contains(place, free); });
    }
    // Returns whether a place of a box is on the outer surface of the mesh, not on a face inside another part. It is
    // the place of the mesh that is nearest to `from`.
    [[nodiscard]] bool is_outer(const NearestPlace& nearest, const glm::dvec3& from, InsideOfBox& box) const noexcept {
        if (!by_rays_) return true;
        const glm::dvec3 off = off_ * normal_[nearest.face];
        const double along = glm::dot(from - nearest.place, normal_[nearest.face]);
        if (std::abs(along) < off_) return !box.contains(nearest.place + off) || !box.contains(nearest.place - off);
        // No face is between `from` and the place beside the face on the same side.
        return nearest.distance > 0.0 || !box.contains(along > 0.0 ? nearest.place - off : nearest.place + off);
    }
    // Returns whether the mesh is solid: every place is either inside or outside.
    [[nodiscard]] bool solid() const noexcept { return solid_; }
    [[nodiscard]] const glm::dvec3& normal(std::int64_t face) const noexcept { return normal_[face]; }

private:
    // Finds the side of the mesh that a place is on. Calls by_rays(free) if the normal does not decide. The place is
    // `free` away from the mesh.
    template <class ByRays>
    [[nodiscard]] NearestPlace with_sign(const glm::dvec3& place, const FaceTree::Nearest& nearest,
                                         ByRays&& by_rays) const noexcept {
        NearestPlace result{std::sqrt(nearest.squared), nearest.face, nearest.place, false};
        const glm::dvec3 normal = pseudo_normal(nearest.face, nearest.place, result.inner);
        const Triangle& t = mesh_.triangle[nearest.face];
        const bool is_folded = folded_[t[0]] != 0 || folded_[t[1]] != 0 || folded_[t[2]] != 0;
        const bool inside = by_rays_ || (solid_ && is_folded) ? by_rays(result.distance)
                                                              : glm::dot(place - nearest.place, normal) < 0.0;
        if (inside) result.distance = -result.distance;
        return result;
    }
    [[nodiscard]] bool is_solid_by_rays(const base::Work& work, const base::Array<std::int64_t>& face) const;
    [[nodiscard]] glm::dvec3 pseudo_normal(std::int64_t face, const glm::dvec3& place, bool& inner) const noexcept;

    const Mesh& mesh_;
    const FaceTree& tree_;
    base::Array<glm::dvec3> normal_;   // for each face: its unit normal
    base::Array<glm::dvec3> edge_;     // for each side: the sum of the normals of the faces at its edge
    base::Array<glm::dvec3> vertex_;   // for each vertex: the sum of the normals of its faces, weighted by angles
    base::Array<std::uint8_t> folded_; // for each vertex: 1 if a face there is folded upon another
    double off_ = 0.0;
    bool solid_ = false;
    bool by_rays_ = false;
};

// Returns faces evenly distributed by area. An even distribution by index would be wrong: the many small faces at the
// rounded corners of a tray would make the tray look solid.
[[nodiscard]] base::Array<std::int64_t> faces_to_probe(const Mesh& mesh) {
    const auto probes = static_cast<double>(cell_tuning.probes);
    base::Array<std::int64_t> faces(mesh.vertex.memory());
    double area = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) area += glm::length(doubled_area(mesh.corners(face)));
    double passed = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        passed += glm::length(doubled_area(mesh.corners(face)));
        while (faces.size() < cell_tuning.probes && passed * probes >= area * (static_cast<double>(faces.size()) + 0.5))
            faces.push_back(face);
    }
    return faces;
}

SignedDistances::SignedDistances(const base::Work& work, const Mesh& mesh, const FaceTree& tree)
    : mesh_(mesh), tree_(tree), normal_(unit_normals(mesh, work)), edge_(work.memory, 3 * mesh.faces()),
      vertex_(work.memory, mesh.vertex.size()), folded_(work.memory, mesh.vertex.size()),
      off_(cell_tuning.off_face * mesh.bounds.diagonal()) {
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        for (std::size_t k = 0; k < 3; ++k)
            vertex_[mesh.triangle[face][k]] += angle_at(mesh.corners(face), k) * normal_[face];
    for_edges(sides_by_edge(work, mesh.triangle), work, [&](const Side* first, const Side* last) {
        glm::dvec3 sum(0.0);
        for (const Side* side = first; side != last; ++side) sum += normal_[side->face];
        const bool folded = last - first == 2 && glm::length(sum) < cell_tuning.folded;
        for (const Side* side = first; side != last; ++side) {
            edge_[number_of(mesh.triangle, *side)] = sum;
            for (const std::int32_t vertex : mesh.triangle[side->face])
                if (folded) folded_[vertex] = 1;
        }
    });
    solid_ = mesh.report.closed || is_solid_by_rays(work, faces_to_probe(mesh));
    by_rays_ = solid_ && (!mesh.report.closed || has_parts(mesh));
}

// Returns whether rays agree with the orientation of nearly all of the given faces.
bool SignedDistances::is_solid_by_rays(const base::Work& work, const base::Array<std::int64_t>& face) const {
    base::Array<std::uint8_t> right(work.memory, face.size());
    work.for_chunks(face.size(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 middle = middle_of(mesh_, face[i]);
            const glm::dvec3 off = off_ * normal_[face[i]];
            right[i] = side_of_mesh(tree_, middle + off) == MeshSide::outside &&
                       side_of_mesh(tree_, middle - off) == MeshSide::inside;
        }
    });
    const auto sum = static_cast<double>(std::count(right.begin(), right.end(), std::uint8_t{1}));
    return sum >= cell_tuning.solid_share * static_cast<double>(face.size());
}

glm::dvec3 SignedDistances::pseudo_normal(std::int64_t face, const glm::dvec3& place, bool& inner) const noexcept {
    // A place is on an edge of a face if its barycentric coordinate for the opposite corner is below this.
    constexpr double on_edge = 1e-6; // in barycentric coordinates
    const glm::dvec3 shares = shares_of(mesh_.corners(face), place);
    inner = shares.x > on_edge && shares.y > on_edge && shares.z > on_edge;
    if (inner) return normal_[face];
    for (int k = 0; k < 3; ++k)
        if (shares[k] >= 1.0 - on_edge) return vertex_[mesh_.triangle[face][static_cast<std::size_t>(k)]];
    const int without_share = shares.x <= on_edge ? 0 : shares.y <= on_edge ? 1 : 2;
    return edge_[3 * face + (without_share + 1) % 3]; // the side opposite the corner whose coordinate is 0
}

// ---- Cells and faces

// The cube in which a cell contributes to f.
struct CellBox {
    glm::dvec3 centre{0.0};
    double half = 0.0;
    [[nodiscard]] bool contains(const glm::dvec3& p) const noexcept {
        const glm::dvec3 off = glm::abs(p - centre);
        return off.x <= half && off.y <= half && off.z <= half;
    }
};

// Returns whether a triangle and a box overlap, by testing separating axes (Akenine-Moeller, "Fast 3D triangle-box
// overlap testing", 2001).
[[nodiscard]] bool meets(const CellBox& box, const std::array<glm::dvec3, 3>& corners) noexcept {
    const std::array<glm::dvec3, 3> p{corners[0] - box.centre, corners[1] - box.centre, corners[2] - box.centre};
    const auto parts = [&](const glm::dvec3& axis) {
        const double a = glm::dot(axis, p[0]);
        const double b = glm::dot(axis, p[1]);
        const double c = glm::dot(axis, p[2]);
        const double radius = box.half * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
        return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
    };
    const glm::dvec3 low = glm::min(glm::min(p[0], p[1]), p[2]);
    const glm::dvec3 high = glm::max(glm::max(p[0], p[1]), p[2]);
    for (int axis = 0; axis < 3; ++axis)
        if (low[axis] > box.half || high[axis] < -box.half) return false;
    if (parts(doubled_area(p))) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = p[(k + 1) % 3] - p[k];
        if (parts({0.0, -edge.z, edge.y}) || parts({edge.z, 0.0, -edge.x}) || parts({-edge.y, edge.x, 0.0}))
            return false;
    }
    return true;
}

// Returns the distance from a place to a triangle. It is the distance to the plane if the foot is inside the triangle,
// else to the nearest edge.
[[nodiscard]] double distance_to(const glm::dvec3& place, const std::array<glm::dvec3, 3>& corners) noexcept {
    const glm::dvec3 shares = shares_of(corners, place);
    if (shares.x >= 0.0 && shares.y >= 0.0 && shares.z >= 0.0)
        return glm::distance(place, shares.x * corners[0] + shares.y * corners[1] + shares.z * corners[2]);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
        least = std::min(least, geometry::distance_to_segment(place, corners[k], corners[(k + 1) % 3]));
    return least;
}

// ---- Tests of trees

struct CellTask {
    const base::Runtime& runtime;
    const Mesh& mesh;
    const FaceTree& tree;
    const Creases& creases;
    const SignedDistances& distances;
    const base::Array<double>& chord;
    const ReadOnceTrees& trees;
    const SheetTreeData& data;
    const double near; // the distance from the surface within which signs may be wrong
    const std::uint64_t seed;

    // Returns the distance from a face within which signs may be wrong. It is `near` plus an allowance for the distance
    // between the face and the smooth surface that it approximates.
    [[nodiscard]] double slack(std::int64_t face) const noexcept {
        const Triangle& t = mesh.triangle[face];
        return near + 1.5 * std::max({chord[t[0]], chord[t[1]], chord[t[2]]});
    }
};

struct TreeTests {
    explicit TreeTests(base::Memory& memory) noexcept : place(memory), distance(memory), slack(memory), own(memory) {}

    void add_beside(const glm::dvec3& p, double d) { add(p, d, 0.0, -1); }
    // `sheet` should pass the test. If `count` is 1, there is no other sheet, so the test is not stored.
    void add_on_surface(const glm::dvec3& p, double may_be_off, std::int64_t sheet, std::size_t count) {
        has_surface = true;
        if (count > 1) add(p, 0.0, may_be_off, static_cast<std::int32_t>(sheet));
    }
    void add(const glm::dvec3& p, double d, double may_be_off, std::int32_t sheet) {
        place.push_back(p);
        distance.push_back(d);
        slack.push_back(may_be_off);
        own.push_back(sheet);
    }
    // Returns the common sign of the distances of all places, or 0 if the signs differ or a place is on the surface.
    [[nodiscard]] double one_side() const noexcept {
        if (distance.empty() || has_surface) return 0.0;
        const double sign = std::copysign(1.0, distance[0]);
        return std::all_of(distance.begin(), distance.end(), [&](double one) { return one * sign > 0.0; }) ? sign : 0.0;
    }

    geometry::VecArray place;
    base::Array<double> distance;  // for each place: its signed distance from the mesh
    base::Array<double> slack;     // for each place: the allowed difference between f and the sheet `own`
    base::Array<std::int32_t> own; // for each place on the surface: the index of the sheet that f should equal; else -1
    bool has_surface = false;      // true if some place is on the surface
};

// Returns the distance, at most `most`, that a point can move from a place inside a face along a direction while that
// face remains the nearest part of the mesh.
[[nodiscard]] double free_distance(const FaceTree& faces, const glm::dvec3& place, const glm::dvec3& along,
                                   double most) noexcept {
    const FaceTree::Hit hit = faces.first_hit(place, 2.0 * most * along, 1e-6, 1.0);
    return hit.face < 0 ? most : 0.9 * hit.t * most;
}

// Adds two kinds of tests for the place on the mesh that is nearest to `from`. On the mesh, f should equal the sheet of
// the patch. Beside the mesh, on either side, f should have the sign of that side.
void test_on_surface(const CellTask& task, const CellBox& box, InsideOfBox& inside,
                     std::span<const std::int32_t> sheets, const NearestPlace& nearest, const glm::dvec3& from,
                     double step, TreeTests& tests) {
    if (!box.contains(nearest.place) || !task.distances.is_outer(nearest, from, inside)) return;
    const auto own = std::find(sheets.begin(), sheets.end(), task.creases.patch[nearest.face]);
    if (own == sheets.end()) return;
    const double slack = task.slack(nearest.face);
    tests.add_on_surface(nearest.place, slack - 0.5 * task.near, own - sheets.begin(), sheets.size());
    if (!nearest.inner) return;
    const glm::dvec3& normal = task.distances.normal(nearest.face);
    for (const double side : {1.0, -1.0}) {
        const double room = free_distance(inside.faces(), nearest.place, side * normal, step * box.half);
        if (room > slack) tests.add_beside(nearest.place + side * room * normal, side * room);
    }
}

// Returns tests at random places in the cell and at the nearest places on the mesh. Small faces and creases may lie
// between random places, so tests in the middles of faces and near their sides are added.
[[nodiscard]] TreeTests gather_tests(const CellTask& task, const CellBox& box, std::span<const std::int32_t> faces,
                                     std::span<const std::int32_t> sheets, std::uint64_t cell) {
    constexpr std::uint32_t stream = 78;
    TreeTests tests(task.runtime.memory);
    InsideOfBox inside(task.tree, box.centre, box.half);
    glm::dvec3 on_mesh = middle_of(task.mesh, faces[0]);
    const std::int64_t n = cell_tuning.along;
    const double spacing = 2.0 * box.half / static_cast<double>(n);
    for (std::int64_t i = 0; i < n * n * n; ++i) {
        const auto random =
            base::uniform4(task.seed, cell * 1024U + static_cast<std::uint64_t>(i), base::Purpose::mesh_sample, stream);
        const glm::dvec3 in = glm::dvec3(i % n, i / n % n, i / (n * n)) + glm::dvec3(random[0], random[1], random[2]);
        const glm::dvec3 place = box.centre - box.half + spacing * in;
        const NearestPlace nearest = task.distances.nearest_place(place, on_mesh, inside);
        on_mesh = nearest.place;
        if (std::abs(nearest.distance) > task.slack(nearest.face)) tests.add_beside(place, nearest.distance);
        if (i % 2 == 0)
            test_on_surface(task, box, inside, sheets, nearest, place,
                            i % 4 == 0 ? cell_tuning.beside_step : cell_tuning.finer_step, tests);
    }
    const std::size_t step =
        std::max<std::size_t>(1, faces.size() / static_cast<std::size_t>(cell_tuning.faces_looked_at));
    for (std::size_t i = 0; i < faces.size(); i += step) {
        const auto p = task.mesh.corners(faces[i]);
        const glm::dvec3 middle = middle_of(task.mesh, faces[i]);
        NearestPlace nearest{0.0, faces[i], middle, true};
        test_on_surface(task, box, inside, sheets, nearest, nearest.place, cell_tuning.finer_step, tests);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 side = 0.5 * (p[k] + p[(k + 1) % 3]);
            nearest.place = side + std::min(1.0, 0.1 * box.half / glm::distance(side, middle)) * 0.5 * (middle - side);
            test_on_surface(task, box, inside, sheets, nearest, nearest.place, cell_tuning.finer_step, tests);
        }
    }
    return tests;
}

struct TreeChoice {
    std::int64_t tree = -1;
    std::int64_t wrong = 0; // the number of tests that the tree fails
    double off = 0.0;       // its mean_off()
};

// The values of the sheets of a cell at the places of its tests, and of trees over these sheets. A tree is evaluated at
// `at_once` places at a time.
class TreeValues {
public:
    static constexpr std::int64_t at_once = 64;

    TreeValues(const CellTask& task, std::span<const std::int32_t> sheets, const TreeTests& tests)
        : count_(tests.distance.size()), value_(task.runtime.memory) {
        value_.resize_for_overwrite(count_ * static_cast<std::int64_t>(sheets.size()));
        for (std::size_t k = 0; k < sheets.size(); ++k)
            implicit::evaluate(task.runtime.instruction_set, task.data.sheet[sheets[k]],
                               {tests.place.x.data(), tests.place.y.data(), tests.place.z.data(), count_},
                               {value_.data() + static_cast<std::int64_t>(k) * count_, {}, {}});
    }
    [[nodiscard]] double of_sheet(std::int32_t sheet, std::int64_t i) const noexcept {
        return value_[sheet * count_ + i];
    }
    // Returns the values of a tree at the places from `begin` to end - 1. They are valid until the next call.
    [[nodiscard]] const double* of_tree(std::span<const std::int32_t> program, std::int64_t begin,
                                        std::int64_t end) noexcept {
        HRBFNPR_ASSERT(begin < end && end <= count_ && end - begin <= at_once);
        std::array<const double*, ReadOnceTrees::most + 1> stack{};
        std::size_t depth = 0;
        for (const std::int32_t code : program) {
            if (code >= 0) {
                stack[depth++] = value_.data() + code * count_ + begin;
                continue;
            }
            const double* const b = stack[--depth];
            const double* const a = stack[depth - 1];
            double* const joined = joined_[depth - 1].data();
            if (code == SheetTreeData::maximum)
                for (std::int64_t i = 0; i < end - begin; ++i) joined[i] = std::max(a[i], b[i]);
            else
                for (std::int64_t i = 0; i < end - begin; ++i) joined[i] = std::min(a[i], b[i]);
            stack[depth - 1] = joined;
        }
        HRBFNPR_ASSERT(depth == 1);
        return stack[0];
    }

private:
    std::int64_t count_;
    base::Array<double> value_;                                             // for each sheet: its value at each place
    std::array<std::array<double, at_once>, ReadOnceTrees::most> joined_{}; // for each depth of the stack of of_tree()
};

// Counts the tests that a tree fails. The count ends when it exceeds `most`, because such a tree is not chosen.
[[nodiscard]] std::int64_t count_failures(std::span<const std::int32_t> program, const TreeTests& tests,
                                          TreeValues& values, std::int64_t most) noexcept {
    const std::int64_t count = tests.distance.size();
    std::int64_t wrong = 0;
    for (std::int64_t begin = 0; begin < count && wrong <= most; begin += TreeValues::at_once) {
        const std::int64_t end = std::min(begin + TreeValues::at_once, count);
        const double* const v = values.of_tree(program, begin, end);
        for (std::int64_t i = begin; i < end; ++i) {
            const bool fails = tests.own[i] >= 0
                                   ? std::abs(v[i - begin] - values.of_sheet(tests.own[i], i)) > tests.slack[i]
                                   : !(v[i - begin] * tests.distance[i] > 0.0);
            wrong += fails ? 1 : 0;
        }
    }
    return wrong;
}

// Returns the mean relative difference between the tree's values and the distances, over the tests of signs that the
// tree passes.
[[nodiscard]] double mean_off(std::span<const std::int32_t> program, const TreeTests& tests,
                              TreeValues& values) noexcept {
    const std::int64_t count = tests.distance.size();
    double off = 0.0;
    for (std::int64_t begin = 0; begin < count; begin += TreeValues::at_once) {
        const std::int64_t end = std::min(begin + TreeValues::at_once, count);
        const double* const v = values.of_tree(program, begin, end);
        for (std::int64_t i = begin; i < end; ++i) {
            const double d = tests.distance[i];
            const double f = v[i - begin];
            if (tests.own[i] < 0 && f * d > 0.0) off += std::min(1.0, std::abs(f - d) / std::abs(d));
        }
    }
    return off / static_cast<double>(std::max<std::int64_t>(count, 1));
}

[[nodiscard]] TreeChoice choose_tree(const CellTask& task, std::span<const std::int32_t> sheets,
                                     const TreeTests& tests) {
    TreeValues values(task, sheets, tests);
    const auto functions = static_cast<std::int32_t>(sheets.size());
    TreeChoice best;
    for (std::int64_t tree = 0; tree < task.trees.count(functions); ++tree) {
        const std::span<const std::int32_t> program = task.trees.program(functions, tree);
        const std::int64_t most = best.tree < 0 ? tests.distance.size() : best.wrong;
        const std::int64_t wrong = count_failures(program, tests, values, most);
        if (wrong > most) continue;
        const double off = mean_off(program, tests, values);
        if (best.tree < 0 || wrong < best.wrong || off < best.off) best = {tree, wrong, off};
    }
    return best;
}

// ---- Cells

struct Node {
    glm::dvec3 centre;
    double half;
    std::int64_t parent; // the index of the parent node in the level above

    [[nodiscard]] CellBox box() const noexcept { return {centre, SheetTreeData::cell_reach * half}; }
};

// The decision about a node.
struct CellDecision {
    bool split = false;
    bool poor = false;
    bool surface = false;
    Program program;
    double plain[4] = {}; // for a cell without surface: the value and the gradient of its linear function
};

// Returns the patches of the cell's faces in rising order. If there are too many and the cell cannot be split, only the
// nearest are returned.
[[nodiscard]] FaceList patches_of(const CellTask& task, const Node& node, const FaceList& faces, bool may_split) {
    FaceList patches(task.runtime.memory);
    for (const std::int32_t face : faces) {
        const std::int32_t patch = task.creases.patch[face];
        if (std::find(patches.begin(), patches.end(), patch) == patches.end()) patches.push_back(patch);
    }
    std::sort(patches.begin(), patches.end());
    if (patches.size() <= ReadOnceTrees::most || may_split) return patches;
    struct Near {
        double distance;
        std::int32_t patch;
    };
    base::Array<Near> order(task.runtime.memory);
    for (const std::int32_t patch : patches) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::int32_t face : faces)
            if (task.creases.patch[face] == patch)
                least = std::min(least, distance_to(node.centre, task.mesh.corners(face)));
        order.push_back({least, patch});
    }
    std::sort(order.begin(), order.end(), [](const Near& a, const Near& b) {
        return a.distance < b.distance || (a.distance == b.distance && a.patch < b.patch);
    });
    for (std::int64_t i = 0; i < patches.size(); ++i) patches[i] = order[i].patch;
    return patches;
}

// Sets the linear function of a cell without surface. In the middle of the cell it equals the signed distance, and it
// has the same sign in the whole cell.
void make_plain(const SignedDistances& distances, const Node& node, CellDecision& found) noexcept {
    const NearestPlace nearest = distances.nearest_place(node.centre);
    const glm::dvec3 off = node.centre - nearest.place;
    const double distance = glm::length(off);
    const double far = std::sqrt(3.0) * SheetTreeData::cell_reach * node.half;
    const double slope = std::min(1.0, cell_tuning.plain_fall * distance / far);
    const glm::dvec3 gradient = distance > 0.0 ? (slope / nearest.distance) * off : glm::dvec3(0.0);
    found.plain[0] = nearest.distance;
    for (int c = 0; c < 3; ++c) found.plain[1 + c] = gradient[c];
}

// Decides what to do with a node. `faces` are the faces in the box of its cell. `cell` is a number that no other cell
// has.
[[nodiscard]] CellDecision decide_cell(const CellTask& task, const Node& node, const FaceList& faces,
                                       std::int32_t level, std::uint64_t cell, bool may_split) {
    CellDecision found;
    found.surface = !faces.empty();
    found.split = level < (found.surface ? cell_tuning.least_level : cell_tuning.least_plain_level);
    if (found.split) return found;
    if (!found.surface) {
        make_plain(task.distances, node, found);
        return found;
    }
    FaceList patches = patches_of(task, node, faces, may_split);
    found.split = patches.size() > ReadOnceTrees::most && may_split;
    if (found.split) return found;
    patches.resize(std::min<std::int64_t>(patches.size(), ReadOnceTrees::most));
    const TreeTests tests = gather_tests(task, node.box(), faces.span(), patches.span(), cell);
    if (const double side = tests.one_side(); side != 0.0) { // All faces that meet the box are inside another part.
        found.plain[0] = 0.5 * side * node.half;
        // The gradient must not be 0, because callers may need its direction.
        const glm::dvec3 along = 0.1 * side * task.distances.normal(faces[0]);
        for (int c = 0; c < 3; ++c) found.plain[1 + c] = along[c];
        return found;
    }
    const TreeChoice choice = choose_tree(task, patches.span(), tests);
    found.poor = choice.wrong > 0;
    found.split = found.poor && may_split;
    for (const std::int32_t code : task.trees.program(static_cast<std::int32_t>(patches.size()), choice.tree))
        found.program.code[found.program.size++] = code >= 0 ? patches[code] : code;
    return found;
}

// Adds the nodes of a level to the data, and the centres of leaves to `centres`. Returns the next level.
[[nodiscard]] base::Array<Node> add_level(const base::Array<Node>& nodes, const base::Array<CellDecision>& found,
                                          SheetTreeData& data, geometry::VecArray& centres, CellsReport& report) {
    const std::int64_t first = data.child.size() + nodes.size();
    base::Array<Node> next(nodes.memory());
    for (std::int64_t i = 0; i < nodes.size(); ++i) {
        if (found[i].split) {
            data.child.push_back(static_cast<std::int32_t>(first + next.size()));
            const double q = 0.5 * nodes[i].half;
            for (std::int32_t k = 0; k < 8; ++k)
                next.push_back({nodes[i].centre + SheetTreeData::child_offset(k, q), q, i});
            continue;
        }
        data.child.push_back(-1 - static_cast<std::int32_t>(data.program_begin.size()));
        data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
        for (std::int32_t k = 0; k < found[i].program.size; ++k) data.program.push_back(found[i].program.code[k]);
        for (const double number : found[i].plain) data.plain.push_back(number);
        report.surface_cells += found[i].surface ? 1 : 0;
        report.poor_cells += found[i].poor ? 1 : 0;
        centres.push_back(nodes[i].centre);
    }
    if (next.empty()) data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
    return next;
}

// If the mesh is not solid, each cell without surface gets the program of the nearest cell with surface. This continues
// the surface beyond its borders.
void continue_surface(const base::Work& work, const SignedDistances& distances, const geometry::VecArray& centres,
                      SheetTreeData& data) {
    base::Array<std::int32_t> from(work.memory, data.leaves());
    work.for_chunks(data.leaves(), 64, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t leaf = begin; leaf < end; ++leaf)
            from[leaf] = data.program_begin[leaf] < data.program_begin[leaf + 1]
                             ? static_cast<std::int32_t>(leaf)
                             : data.leaf_at(distances.nearest_place(centres[leaf]).place);
    });
    base::Array<std::int32_t> begin(work.memory);
    base::Array<std::int32_t> program(work.memory);
    for (const std::int32_t leaf : from) {
        begin.push_back(static_cast<std::int32_t>(program.size()));
        for (std::int32_t at = data.program_begin[leaf]; at < data.program_begin[leaf + 1]; ++at)
            program.push_back(data.program[at]);
    }
    begin.push_back(static_cast<std::int32_t>(program.size()));
    data.program_begin = std::move(begin);
    data.program = std::move(program);
}

} // namespace

ReadOnceTrees::ReadOnceTrees(base::Memory& memory) : first_(memory), begin_(memory), code_(memory) {
    base::List<Programs> trees(memory); // The programs of `set` with the top `top` have the index 2 set + top.
    const auto topped = [&](std::uint32_t set, std::uint32_t top) -> const Programs& { return trees[2 * set + top]; };
    for (std::uint32_t set = 0; set < 1U << most; ++set)
        for (std::uint32_t top = 0; top < 2; ++top) {
            Programs& to = trees.add(memory);
            if (set > 0) add_trees(set, top, topped, to);
        }
    first_.resize(2); // There are no trees for zero functions.
    for (std::int32_t functions = 1; functions <= most; ++functions) {
        const std::uint32_t all = (1U << static_cast<unsigned>(functions)) - 1U;
        for (std::uint32_t top = 0; top < (functions > 1 ? 2U : 1U); ++top)
            for (const Program& program : topped(all, top)) {
                begin_.push_back(code_.size());
                for (std::int32_t i = 0; i < program.size; ++i) code_.push_back(program.code[i]);
            }
        first_.push_back(begin_.size());
    }
    begin_.push_back(code_.size());
}

CellsReport make_cells(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const Creases& creases,
                       const base::Array<double>& chord, std::uint64_t seed, SheetTreeData& data) {
    HRBFNPR_ASSERT(data.sheet.size() == creases.patches && chord.size() == mesh.vertex.size());
    const SignedDistances distances(work, mesh, tree);
    const ReadOnceTrees trees(work.memory);
    const double diagonal = mesh.bounds.diagonal();
    const CellTask task{work, mesh, tree, creases, distances, chord, trees, data, cell_tuning.near * diagonal, seed};
    data.bounds = mesh.bounds;
    data.side = cell_tuning.root_side * SheetTreeData::reach * diagonal;
    data.corner = mesh.bounds.centre() - 0.5 * data.side;
    base::Array<Node> nodes(work.memory); // the nodes of one level
    nodes.push_back({mesh.bounds.centre(), 0.5 * data.side, 0});
    base::List<FaceList> above(work.memory); // for each node of the level above: the faces in its box
    FaceList& all = above.add(work.memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) all.push_back(static_cast<std::int32_t>(face));
    geometry::VecArray centres(work.memory);
    CellsReport report;
    for (std::int32_t level = 0; !nodes.empty(); ++level) {
        base::List<FaceList> faces(work.memory);
        for (std::int64_t i = 0; i < nodes.size(); ++i) faces.add(work.memory);
        base::Array<CellDecision> found(work.memory, nodes.size());
        const bool may_split =
            level < cell_tuning.most_level && data.child.size() + 8 * nodes.size() < cell_tuning.most_cells;
        work.for_each(nodes.size(), [&](std::int64_t i) {
            for (const std::int32_t face : above[nodes[i].parent])
                if (meets(nodes[i].box(), mesh.corners(face))) faces[i].push_back(face);
            const std::uint64_t cell = (static_cast<std::uint64_t>(level) << 32U) + static_cast<std::uint64_t>(i);
            found[i] = decide_cell(task, nodes[i], faces[i], level, cell, may_split);
        });
        nodes = add_level(nodes, found, data, centres, report);
        above = std::move(faces);
        work.update(static_cast<double>(level + 1) / (cell_tuning.most_level + 1));
    }
    if (!distances.solid()) continue_surface(work, distances, centres, data);
    report.cells = data.leaves();
    return report;
}

} // namespace hrbfnpr::mesh

// SPDX-License-Identifier: MIT
#include "mesh/pieces/has_creases.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hrbfnpr::mesh {
namespace {

constexpr double degrees = 57.29577951308232;
constexpr double stands_out = 6.0;
// Of real meshes: parts of machines have clear shares of 0.99 and 1, or, where faces are few, of 0.7 with a ratio of
// 20; scans and coarse figures 0.34 to 0.63 with ratios of 0.2 to 2.1.
constexpr double surely_clear = 0.9;
constexpr double maybe_clear = 0.6;
constexpr double clear_ratio = 3.0;
// Edges that bend by less than a fiftieth of what 0.9 of all edges stay below are 0.2 to 0.5 of the length of machines,
// vehicles and arms whose edges are not that clear.  Of scans, figures and animals they are 0.02 to 0.143, of 100 to
// 300 000 faces alike.
constexpr double constructed = 0.16;
constexpr double constructed_clear = 0.45;
constexpr double hardly = 0.02;
constexpr double nearly_all = 0.9;
// Faces that are that coarse at a quarter of the edges are a rock's; coarse balls, rings and figures have none.
constexpr double surely_coarse = 0.25;
constexpr double coarse_ratio = 2.0;
constexpr double shortest = 0.05; // diagonals
constexpr double far_off = 0.02;  // diagonals; a ball of 80 faces is off by 0.009, an icosahedron by 0.03
constexpr std::int64_t faces_a_check = 1024;

class Looker {
public:
    Looker(const base::Runtime& runtime, const Mesh& mesh, double angle, const base::Progress& progress)
        : mesh_(mesh), angle_(angle), progress_(progress), sides_(sides_by_edge(runtime, mesh.triangle, progress)),
          bend_(runtime.memory, 3 * mesh.faces()) {}

    // Of each component, or of all as one.
    [[nodiscard]] base::Array<CreaseEvidence> run(bool by_part) {
        measure();
        base::Array<CreaseEvidence> found(mesh_.vertex.memory(), by_part ? components() : 1);
        const base::Array<double> diagonal = diagonals(found.size());
        for_edges(sides_, [&](const Side* first, const Side* last) {
            if ((first - sides_.begin()) % faces_a_check == 0) progress_.check();
            if (last - first == 2) {
                const std::int64_t part = by_part ? mesh_.component[first->face] : 0;
                add(first[0], first[1], diagonal[part], found[part]);
            }
        });
        look_for_even(by_part, found);
        for (std::int64_t part = 0; part < found.size(); ++part) conclude(diagonal[part], found[part]);
        return found;
    }

private:
    struct Bend {
        std::int64_t part = 0;
        double bend = 0.0, length = 0.0;
    };

    void look_for_even(bool by_part, base::Array<CreaseEvidence>& found) const {
        base::Array<Bend> bends(mesh_.vertex.memory());
        for_edges(sides_, progress_, [&](const Side* first, const Side* last) {
            if (last - first != 2) return;
            const std::int64_t part = by_part ? mesh_.component[first->face] : 0;
            if (found[part].length > 0.0) bends.push_back({part, bend_[side_of(*first)], glm::length(along(*first))});
        });
        std::sort(bends.begin(), bends.end(), [](const Bend& a, const Bend& b) {
            return std::tuple(a.part, a.bend, a.length) < std::tuple(b.part, b.bend, b.length);
        });
        for (const Bend* first = bends.begin(); first != bends.end();) {
            const Bend* const last = std::find_if(first, static_cast<const Bend*>(bends.end()),
                                                  [&](const Bend& other) { return other.part != first->part; });
            found[first->part].even = even_of(first, last);
            first = last;
        }
    }

    // Of edges by how much they bend.
    [[nodiscard]] static double even_of(const Bend* first, const Bend* last) noexcept {
        double all = 0.0, below = 0.0, even = 0.0;
        for (const Bend* each = first; each != last; ++each) all += each->length;
        const Bend* large = first;
        while (large + 1 != last && below + large->length < nearly_all * all) below += (large++)->length;
        for (const Bend* each = first; each != last && each->bend <= hardly * large->bend; ++each) even += each->length;
        return even / all;
    }

    [[nodiscard]] std::int64_t components() const noexcept {
        return 1 + *std::max_element(mesh_.component.begin(), mesh_.component.end());
    }

    [[nodiscard]] base::Array<double> diagonals(std::int64_t parts) const {
        base::Array<geometry::Bounds> bounds(mesh_.vertex.memory());
        for (std::int64_t part = 0; part < parts; ++part) bounds.push_back({});
        for (std::int64_t face = 0; face < mesh_.faces(); ++face)
            for (const glm::dvec3& p : mesh_.corners(face)) bounds[parts == 1 ? 0 : mesh_.component[face]].extend(p);
        base::Array<double> diagonal(mesh_.vertex.memory());
        for (const geometry::Bounds& each : bounds) diagonal.push_back(each.diagonal());
        return diagonal;
    }

    // Lengths; `ratio`: of what bends by half the angle, and not by all of it.
    void add(const Side& left, const Side& right, double diagonal, CreaseEvidence& to) const noexcept {
        const double bend = bend_[side_of(left)];
        if (!bends_more(bend, 0.5 * angle_)) return;
        const double length = glm::length(along(left));
        if (!bends_more(bend, angle_)) {
            to.ratio += length;
            return;
        }
        to.length += length;
        to.clear += bend >= stands_out * std::min(bend_beside(left), bend_beside(right)) ? length : 0.0;
        to.coarse += std::min(bulge(left), bulge(right)) >= far_off * diagonal ? length : 0.0;
    }

    static void conclude(double diagonal, CreaseEvidence& of) noexcept {
        if (!(of.length > 0.0)) {
            of = {};
            return;
        }
        of.clear /= of.length;
        of.coarse /= of.length;
        of.ratio = of.length / std::max(of.ratio, 1e-9 * of.length);
        of.length /= diagonal;
        const bool clear_enough = of.clear >= surely_clear || (of.clear >= maybe_clear && of.ratio >= clear_ratio) ||
                                  (of.clear >= constructed_clear && of.even >= constructed);
        of.polyhedron = !clear_enough && of.coarse >= surely_coarse && of.ratio >= coarse_ratio;
        of.creases = (clear_enough || of.polyhedron) && of.length >= shortest;
    }

    [[nodiscard]] std::int64_t side_of(const Side& side) const noexcept {
        const auto low = static_cast<std::int32_t>(side.edge >> 32U);
        const auto high = static_cast<std::int32_t>(side.edge & 0xFFFFFFFFU);
        const std::int32_t from = side.forward != 0 ? low : high;
        const Triangle& t = mesh_.triangle[side.face];
        return 3 * std::int64_t{side.face} + (t[0] == from ? 0 : t[1] == from ? 1 : 2);
    }

    [[nodiscard]] glm::dvec3 along(const Side& side) const noexcept { return along(side_of(side)); }
    [[nodiscard]] glm::dvec3 along(std::int64_t side) const noexcept {
        const auto p = mesh_.corners(side / 3);
        return p[static_cast<std::size_t>((side + 1) % 3)] - p[static_cast<std::size_t>(side % 3)];
    }

    void measure() {
        base::Array<glm::dvec3> normal(mesh_.vertex.memory());
        for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
            if (face % faces_a_check == 0) progress_.check();
            normal.push_back(glm::normalize(doubled_area(mesh_.corners(face))));
        }
        for_edges(sides_, [&](const Side* first, const Side* last) {
            if ((first - sides_.begin()) % faces_a_check == 0) progress_.check();
            if (last - first != 2) return;
            const glm::dvec3 a = normal[first[0].face];
            const glm::dvec3 b = (first[0].forward != first[1].forward ? 1.0 : -1.0) * normal[first[1].face];
            const double bend = degrees * std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            bend_[side_of(first[0])] = bend_[side_of(first[1])] = bend;
        });
    }

    // By how much the mesh bends about the direction of a side at the other sides of its face.
    [[nodiscard]] double bend_beside(const Side& of) const noexcept {
        const std::int64_t side = side_of(of);
        const glm::dvec3 direction = glm::normalize(along(side));
        double most = 0.0;
        for (std::int64_t k = 1; k < 3; ++k) {
            const std::int64_t other = side / 3 * 3 + (side + k) % 3;
            most = std::max(most, bend_[other] * std::abs(glm::dot(glm::normalize(along(other)), direction)));
        }
        return most;
    }

    // How far a face is from something round that bends about the side as the mesh does, and has the face for a chord.
    [[nodiscard]] double bulge(const Side& of) const noexcept {
        const std::int64_t side = side_of(of);
        const double across = glm::length(doubled_area(mesh_.corners(of.face))) / glm::length(along(side));
        return 0.25 * across * std::tan(0.5 / degrees * std::min(bend_[side], 120.0));
    }

    const Mesh& mesh_;
    const double angle_;
    const base::Progress& progress_;
    const base::Array<Side> sides_;
    base::Array<double> bend_; // of each side, degrees
};

} // namespace

CreaseEvidence look_for_creases(const base::Runtime& runtime, const Mesh& mesh, double angle,
                                const base::Progress& progress) {
    return Looker(runtime, mesh, angle, progress).run(false)[0];
}

base::Array<CreaseEvidence> look_for_creases_of_parts(const base::Runtime& runtime, const Mesh& mesh, double angle,
                                                      const base::Progress& progress) {
    return Looker(runtime, mesh, angle, progress).run(true);
}

} // namespace hrbfnpr::mesh

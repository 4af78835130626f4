// SPDX-License-Identifier: MIT
// The steps of patch_normals(), in order:
//
//   fans_of        groups the corners at a vertex that are connected across sides without a crease
//   find_flats     finds flat regions that the mean normals of fans would make bulge
//   largest_flat   finds the flat that keeps its own normal beside smaller ones
//   is_tip         recognizes tips of cones, whose faces keep their normals
//
// sample_patch() then thins the places of the curved faces by grids, the places along creases first.
#include "mesh/pieces/patches.h"

#include "geometry/cell_set.h"
#include "geometry/point_tree.h"
#include "mesh/edges.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// Returns the distance between the middle of a side and a curve over the side with the normals `a` and `b` at its ends.
[[nodiscard]] double bulge(const glm::dvec3& side, const glm::dvec3& a, const glm::dvec3& b) noexcept {
    return std::abs(glm::dot(side, b - a)) / 8.0;
}

// ---- Fans

// Returns whether corners `a` and `b` are neighbours in a fan: the face of `b` is beyond the side that starts at `a`,
// and that side is no crease.
[[nodiscard]] bool is_same_patch_across(const Mesh& mesh, const Creases& creases, std::int64_t a,
                                        std::int64_t b) noexcept {
    const auto ahead = [&](std::int64_t corner, std::int64_t by) {
        return mesh.triangle[corner / 3][static_cast<std::size_t>((corner % 3 + by) % 3)];
    };
    return creases.cut[a] != 1 && ahead(b, 2) == ahead(a, 1);
}

using Fan = std::span<const std::int32_t>; // The corners of a fan, in rising order.

// Returns the fans: sets of corners at a vertex that are connected without crossing a crease. At a vertex with very
// many corners, each patch has one fan.
[[nodiscard]] base::Groups fans_of(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                   const base::Groups& corners) {
    base::Array<std::int32_t> name(
        // For each corner: another corner of its fan. At the end it is the same corner for the whole fan.
        runtime.memory);
    name.resize_for_overwrite(3 * mesh.faces());
    const auto root = [&](std::int32_t corner) {
        while (name[corner] != corner) corner = name[corner];
        return corner;
    };
    runtime.parallel.for_chunks(mesh.vertex.size(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) {
            const Fan at = corners[v];
            const bool many = corners.count(v) > patch_tuning.most_corners;
            for (const std::int32_t a : at)
                name[a] = !many ? a : *std::find_if(at.begin(), at.end(), [&](std::int32_t b) {
                    return creases.patch[b / 3] == creases.patch[a / 3];
                });
            if (many) continue;
            for (const std::int32_t a : at)
                for (const std::int32_t b : at)
                    if (is_same_patch_across(mesh, creases, a, b)) name[root(a)] = root(b);
        }
    });
    NumbersByFirstUse numbers(runtime.memory, name.size());
    for (std::int32_t corner = 0; corner < name.size(); ++corner) name[corner] = root(corner);
    for (std::int32_t& fan : name) fan = numbers.of(fan);
    return {runtime.memory, numbers.count(), [&](auto&& put) {
                for (std::int32_t corner = 0; corner < name.size(); ++corner) put(name[corner], corner);
            }};
}

// ---- Flats: regions of a mesh, of one face or many

struct FlatRegions {
    explicit FlatRegions(base::Memory& memory) noexcept : region(memory), area(memory), normal(memory), bulge(memory) {}

    base::Array<std::int32_t> region; // the region of each face
    base::Array<double> area;         // the area of each region
    base::Array<glm::dvec3> normal;
    base::Array<double> bulge; // for each region: the largest chord_error() of its faces with the mean normals
};

// Grows regions across edges that are no creases. It starts at the largest faces, because their normals are the most
// exact.
void grow_flats(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, FlatRegions& flats) {
    base::Memory& memory = runtime.memory;
    const base::Array<std::int64_t> beyond = sides_beyond(mesh.triangle, sides_by_edge(runtime, mesh.triangle));
    base::Array<std::int64_t> order(memory);
    base::Array<glm::dvec3> area(memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        order.push_back(face);
        area.push_back(0.5 * doubled_area(mesh.corners(face)));
    }
    // std::stable_sort would allocate memory outside of base::Memory.
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        const double of_a = glm::length(area[a]);
        const double of_b = glm::length(area[b]);
        return of_a > of_b || (of_a == of_b && a < b);
    });
    flats.region.resize_for_overwrite(mesh.faces());
    std::fill(flats.region.begin(), flats.region.end(), -1);
    base::Array<std::int64_t> todo(memory);
    for (const std::int64_t seed : order) {
        if (flats.region[seed] >= 0) continue;
        const auto region = static_cast<std::int32_t>(flats.area.size());
        const glm::dvec3 normal = glm::normalize(area[seed]);
        flats.area.push_back(0.0);
        flats.normal.push_back(normal);
        flats.region[seed] = region;
        todo.push_back(seed);
        while (!todo.empty()) {
            const std::int64_t face = todo.back();
            todo.resize(todo.size() - 1);
            flats.area[region] += glm::length(area[face]);
            for (int k = 0; k < 3; ++k) {
                const std::int64_t side = 3 * face + k, other = beyond[side] / 3;
                if (creases.cut[side] == 1 || beyond[side] < 0 || flats.region[other] >= 0) continue;
                if (glm::dot(area[other], normal) < patch_tuning.flat_cosine * glm::length(area[other])) continue;
                flats.region[other] = region;
                todo.push_back(other);
            }
        }
    }
}

// Returns the flats. Without a face that bulges by more than the tolerance, the list is empty.
[[nodiscard]] FlatRegions find_flats(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases,
                                     const base::Array<glm::dvec3>& mean, double tolerance) {
    FlatRegions flats(runtime.memory);
    base::Array<double> of_face(runtime.memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) of_face.push_back(chord_error(mesh, mean, face));
    if (std::none_of(of_face.begin(), of_face.end(), [&](double one) { return one > tolerance; })) return flats;
    grow_flats(runtime, mesh, creases, flats);
    flats.bulge.resize(flats.area.size());
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        flats.bulge[flats.region[face]] = std::max(flats.bulge[flats.region[face]], of_face[face]);
    return flats;
}

// Returns the largest flat of a fan, if it bulges and is much larger than all other flats of the fan; else -1.
[[nodiscard]] std::int32_t largest_flat(const FlatRegions& flats, const Fan& fan, double tolerance) noexcept {
    const auto region = [&](std::int32_t corner) { return flats.region[corner / 3]; };
    const std::int32_t largest = region(*std::max_element(fan.begin(), fan.end(), [&](std::int32_t a, std::int32_t b) {
        return flats.area[region(a)] < flats.area[region(b)];
    }));
    double next = 0.0;
    for (const std::int32_t corner : fan)
        if (region(corner) != largest) next = std::max(next, flats.area[region(corner)]);
    const bool keeps = flats.bulge[largest] > tolerance && flats.area[largest] >= patch_tuning.much_larger * next;
    return keeps ? largest : -1;
}

// ---- Tips of cones
//
// At a tip, the mean normal differs by an angle from the normal of each face. At the far side of the face, the vertex
// normals differ from the face normal by only a small part of this angle. On a sphere, the vertex normals at all three
// corners of a face differ from the face normal by equal angles.

[[nodiscard]] double turned_at(const Mesh& mesh, const PatchNormals& normals, std::int64_t corner,
                               std::int64_t other) noexcept {
    return glm::distance(unit_normal(mesh, corner / 3), normals.normal[other]);
}

// Returns whether the normals of a fan turn slowly from face to face, as at the tip of a cone. At an ordinary edge they
// turn all at once.
[[nodiscard]] bool turns_slowly(const Mesh& mesh, const Creases& creases, const Fan& fan) noexcept {
    double turn = 0.0;
    double step = 0.0;
    for (const std::int32_t a : fan)
        for (const std::int32_t b : fan) {
            const double angle = glm::distance(unit_normal(mesh, a / 3), unit_normal(mesh, b / 3));
            turn = std::max(turn, angle);
            if (is_same_patch_across(mesh, creases, a, b)) step = std::max(step, angle);
        }
    return step <= patch_tuning.small_step * turn;
}

[[nodiscard]] bool is_tip(const Mesh& mesh, const Creases& creases, const PatchNormals& normals,
                          const Fan& fan) noexcept {
    const auto turns = [&](std::int64_t corner) {
        return turned_at(mesh, normals, corner, corner) >= patch_tuning.least_turn;
    };
    if (std::none_of(fan.begin(), fan.end(), turns)) return false;
    double here = 0.0, beyond = 0.0, angles = 0.0;
    for (const std::int64_t corner : fan) {
        const std::int64_t first = corner - corner % 3;
        const double angle = angle_at(mesh.corners(corner / 3), static_cast<std::size_t>(corner % 3));
        const double turned = turned_at(mesh, normals, corner, corner);
        here += angle * turned;
        // The smaller turn of the two corners at the far side is used, because the other corner may be at a tip, too.
        beyond += angle * std::min(turned_at(mesh, normals, corner, first + (corner + 1) % 3),
                                   turned_at(mesh, normals, corner, first + (corner + 2) % 3));
        angles += angle;
    }
    return here >= patch_tuning.least_turn * angles && beyond <= patch_tuning.straight * here &&
           turns_slowly(mesh, creases, fan);
}

// ---- Places

[[nodiscard]] glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& other) noexcept {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : other;
}

// A cubic triangle that passes through three corners and is tangent to their tangent planes.
class CurvedFace {
public:
    CurvedFace(const std::array<glm::dvec3, 3>& p, const glm::dvec3* n) noexcept : p_(p), n_{n[0], n[1], n[2]} {
        const auto third = [&](std::size_t i, std::size_t j) {
            return (2.0 * p[i] + p[j] - glm::dot(p[j] - p[i], n[i]) * n[i]) / 3.0;
        };
        glm::dvec3 edges(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            ahead_[i] = third(i, j);
            back_[i] = third(j, i);
            edges += ahead_[i] + back_[i];
        }
        const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
        middle_ = edges / 6.0 + 0.5 * (edges / 6.0 - middle);
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& s) const noexcept {
        glm::dvec3 sum = 6.0 * s.x * s.y * s.z * middle_;
        for (std::size_t i = 0; i < 3; ++i) {
            const double a = s[static_cast<glm::length_t>(i)];
            const double b = s[static_cast<glm::length_t>((i + 1) % 3)];
            sum += a * a * a * p_[i] + 3.0 * a * a * b * ahead_[i] + 3.0 * a * b * b * back_[i];
        }
        return sum;
    }
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& s) const noexcept {
        return unit_or(s.x * n_[0] + s.y * n_[1] + s.z * n_[2], n_[0]);
    }

private:
    std::array<glm::dvec3, 3> p_, n_, ahead_, back_;
    glm::dvec3 middle_;
};

// Returns the number of pieces into which a side is divided.
[[nodiscard]] std::int64_t interval_count(double length, double spacing) noexcept {
    return static_cast<std::int64_t>(std::clamp(length / spacing, 1.0, patch_tuning.most_cuts));
}

// Returns whether the vertices of the faces, and the curved surfaces over the faces, lie within `off` of a plane.
[[nodiscard]] bool lie_in_plane(const Mesh& mesh, const PatchNormals& normals, std::span<const std::int32_t> faces,
                                double off) noexcept {
    glm::dvec3 normal(0.0);
    for (const std::int32_t face : faces) normal += doubled_area(mesh.corners(face));
    normal = unit_or(normal, glm::dvec3(0.0));
    const glm::dvec3 place = mesh.corners(faces[0])[0];
    return std::all_of(faces.begin(), faces.end(), [&](std::int32_t face) {
        const auto p = mesh.corners(face);
        const glm::dvec3* const n = normals.normal.data() + 3 * std::int64_t{face};
        const auto is_off = [&](const glm::dvec3& corner) {
            return !(std::abs(glm::dot(corner - place, normal)) <= off);
        };
        return std::none_of(p.begin(), p.end(), is_off) &&
               std::max({bulge(p[1] - p[0], n[0], normal), bulge(p[1] - p[0], n[1], normal),
                         bulge(p[2] - p[0], n[0], normal), bulge(p[2] - p[0], n[2], normal),
                         bulge(p[2] - p[1], n[1], normal), bulge(p[2] - p[1], n[2], normal)}) <= off;
    });
}

// Sets the tolerance of each place. It is larger near tips, because a sheet rounds tips.
void set_tolerances(const base::Work& work, const PatchTolerance& tolerance, std::int64_t on_creases,
                    const base::Array<glm::dvec3>& tips, double around_tip, PatchSamples& result) {
    const geometry::VecArray& position = result.samples.position;
    result.tolerance.resize(position.size());
    geometry::VecArray crease(work.memory);
    for (std::int64_t i = 0; i < on_creases; ++i) crease.push_back(position[i]);
    const geometry::PointTree tree(crease, work);
    const double ramp = std::min(tolerance.ramp, patch_tuning.ramp_share * result.samples.bounds.diagonal());
    work.for_chunks(position.size(), 512, [&](std::int64_t begin, std::int64_t end) {
        const auto any = [](std::int64_t) { return true; };
        for (std::int64_t i = begin; i < end; ++i) {
            std::int64_t found = 0;
            double share = i < on_creases ? 0.0 : 1.0;
            if (i >= on_creases && tree.nearest(position[i], 1, any, any, &found) > 0)
                share = std::min(glm::distance(position[i], tree.points()[found]) / ramp, 1.0);
            double at_tip = 0.0;
            for (const glm::dvec3& tip : tips)
                at_tip = std::max(at_tip, 1.0 - glm::distance(position[i], tip) / around_tip);
            result.tolerance[i] = std::max(tolerance.crease + share * share * (tolerance.far - tolerance.crease),
                                           at_tip * patch_tuning.tip_tolerance * tolerance.far);
        }
    });
}

} // namespace

PatchNormals patch_normals(const base::Runtime& runtime, const Mesh& mesh, const Creases& creases, double tolerance) {
    HRBFNPR_ASSERT(creases.cut.size() == 3 * mesh.faces() && creases.patch.size() == mesh.faces());
    const base::Groups corners = corners_at_vertices(mesh, {});
    base::Array<glm::dvec3> weighted(runtime.memory); // for each corner: the face normal times the area and the angle
    weighted.resize_for_overwrite(3 * mesh.faces());
    runtime.parallel.for_chunks(mesh.faces(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face) {
            const auto p = mesh.corners(face);
            for (std::size_t k = 0; k < 3; ++k)
                weighted[3 * face + static_cast<std::int64_t>(k)] = angle_at(p, k) * doubled_area(p);
        }
    });
    PatchNormals result(runtime.memory);
    result.normal.resize_for_overwrite(3 * mesh.faces());
    result.tip.resize(3 * mesh.faces());
    const base::Groups fans = fans_of(runtime, mesh, creases, corners);
    const auto for_fans = [&](auto&& visit) {
        runtime.parallel.for_chunks(fans.groups(), 4096, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t fan = begin; fan < end; ++fan) visit(fans[fan]);
        });
    };
    // At a vertex with very many corners, flats and tips are not looked for.
    const auto has_many = [&](const Fan& fan) {
        return corners.count(mesh.triangle[fan[0] / 3][static_cast<std::size_t>(fan[0] % 3)]) >
               patch_tuning.most_corners;
    };
    for_fans([&](const Fan& fan) {
        glm::dvec3 sum(0.0);
        for (const std::int32_t corner : fan) sum += weighted[corner];
        const double length = glm::length(sum);
        const bool usable = length > 0.0 && std::isfinite(length);
        for (const std::int32_t corner : fan)
            result.normal[corner] = usable ? sum / length : unit_normal(mesh, corner / 3);
    });
    if (const FlatRegions flats = find_flats(runtime, mesh, creases, result.normal, tolerance); !flats.area.empty())
        for_fans([&](const Fan& fan) {
            const std::int32_t flat = has_many(fan) ? -1 : largest_flat(flats, fan, tolerance);
            if (flat < 0) return;
            for (const std::int32_t corner : fan) result.normal[corner] = flats.normal[flat];
        });
    for_fans([&](const Fan& fan) {
        if (has_many(fan) || !is_tip(mesh, creases, result, fan)) return;
        for (const std::int32_t corner : fan) result.tip[corner] = 1;
    });
    for (std::int64_t i = 0; i < result.tip.size(); ++i)
        if (result.tip[i] != 0) result.normal[i] = unit_normal(mesh, i / 3);
    return result;
}

double chord_error(const Mesh& mesh, const base::Array<glm::dvec3>& normal, std::int64_t face) noexcept {
    HRBFNPR_ASSERT(normal.size() == 3 * mesh.faces());
    const auto p = mesh.corners(face);
    const glm::dvec3* const n = normal.data() + 3 * face;
    return std::max({bulge(p[1] - p[0], n[0], n[1]), bulge(p[2] - p[1], n[1], n[2]), bulge(p[0] - p[2], n[2], n[0])});
}

base::Array<double> chord_errors(const Mesh& mesh, const base::Array<glm::dvec3>& normal) {
    base::Array<double> error(mesh.vertex.memory(), mesh.vertex.size());
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const double off = chord_error(mesh, normal, face);
        for (const std::int32_t v : mesh.triangle[face]) error[v] = std::max(error[v], off);
    }
    return error;
}

PatchSamples sample_patch(const base::Work& work, const Mesh& mesh, const Creases& creases, const PatchNormals& normals,
                          std::span<const std::int32_t> faces, const PatchTolerance& tolerance) {
    HRBFNPR_ASSERT(!faces.empty() && tolerance.ramp > 0.0);
    const double diagonal = mesh.bounds.diagonal();
    double area = 0.0;
    for (const std::int32_t face : faces) area += 0.5 * glm::length(doubled_area(mesh.corners(face)));
    PatchSamples result(work.memory);
    result.in_plane = lie_in_plane(mesh, normals, faces, patch_tuning.in_plane * tolerance.crease);
    const double wanted = result.in_plane ? patch_tuning.places_in_plane
                                          : std::min(patch_tuning.wanted_places,
                                                     patch_tuning.places_a_face * static_cast<double>(faces.size()));
    const double spacing = std::max(std::sqrt(area / wanted), 1e-4 * diagonal);
    const auto grid_of = [&](double side) {
        return geometry::CellGrid{mesh.bounds.min - spacing, std::max(side * spacing, 1e-5 * diagonal)};
    };
    const geometry::CellGrid grid = grid_of(patch_tuning.thinned);
    const geometry::CellGrid crease_grid = grid_of(patch_tuning.thinned_crease);
    geometry::CellSet taken(work.memory), taken_crease(work.memory);
    base::Array<glm::dvec3> tips(work.memory);
    const auto add = [&](const glm::dvec3& place, const glm::dvec3& normal, bool crease) {
        const std::uint64_t cell = geometry::CellGrid::pack(grid.cell_of(place));
        if (crease && !taken_crease.insert(geometry::CellGrid::pack(crease_grid.cell_of(place)))) return;
        if (!taken.insert(cell) && !crease) return;
        result.samples.position.push_back(place);
        result.samples.normal.push_back(normal);
    };
    // A sheet has one normal at each place, but a tip has several. So the tip gets no sample, and is rounded over the
    // distance to the places around it. Rings of places around the tip, each half as wide as the one before, make this
    // distance short.
    const double least_ring = patch_tuning.tip_ring * diagonal;
    const auto add_rings = [&](std::int32_t face, std::size_t k) {
        const auto p = mesh.corners(face);
        const glm::dvec3 to_middle = 0.5 * (p[(k + 1) % 3] + p[(k + 2) % 3]) - p[k];
        const double length = glm::length(to_middle);
        const glm::dvec3 normal = unit_normal(mesh, face);
        for (double ring = 0.5 * std::min(spacing, length); ring >= least_ring; ring *= 0.5) {
            result.samples.position.push_back(p[k] + ring / length * to_middle);
            result.samples.normal.push_back(normal);
        }
    };
    const auto add_corner = [&](std::int32_t face, std::size_t k, bool crease) {
        const std::int64_t corner = 3 * std::int64_t{face} + static_cast<std::int64_t>(k);
        const glm::dvec3 place = mesh.corners(face)[k];
        if (normals.tip[corner] == 0) return add(place, normals.normal[corner], crease);
        if (!crease) add_rings(face, k);
        if (std::find(tips.begin(), tips.end(), place) == tips.end()) tips.push_back(place);
    };
    // Adds places on a side of a face that is a crease. They lie on the curved surface of this patch, so the patch on
    // the other side may have slightly different places there. The two sheets meet between these places.
    const auto add_crease = [&](std::int32_t face, int k) {
        const auto p = mesh.corners(face);
        const auto a = static_cast<std::size_t>(k);
        const std::size_t b = (a + 1) % 3;
        for (const std::size_t end : {a, b}) add_corner(face, end, true);
        const std::int64_t pieces = interval_count(glm::distance(p[a], p[b]), 0.5 * spacing);
        if (pieces == 1) return;
        const CurvedFace curved(p, normals.normal.data() + 3 * std::int64_t{face});
        for (std::int64_t i = 1; i < pieces; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(pieces);
            glm::dvec3 shares(0.0);
            shares[k] = 1.0 - t;
            shares[(k + 1) % 3] = t;
            add(curved.at(shares), curved.normal(shares), true);
        }
    };
    const auto add_face = [&](std::int32_t face) {
        const auto p = mesh.corners(face);
        for (std::size_t k = 0; k < 3; ++k) add_corner(face, k, false);
        const std::int64_t pieces = interval_count(
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])}), spacing);
        if (pieces == 1) return;
        const CurvedFace curved(p, normals.normal.data() + 3 * std::int64_t{face});
        for (std::int64_t i = 0; i <= pieces; ++i)
            for (std::int64_t j = 0; i + j <= pieces; ++j) {
                const glm::dvec3 shares = glm::dvec3(i, j, pieces - i - j) / static_cast<double>(pieces);
                if (std::max({shares.x, shares.y, shares.z}) == 1.0) continue;
                const int opposite = shares.x == 0.0 ? 1 : shares.y == 0.0 ? 2 : shares.z == 0.0 ? 0 : -1;
                if (opposite >= 0 && creases.cut[3 * std::int64_t{face} + opposite] == 1) continue;
                add(curved.at(shares), curved.normal(shares), false);
            }
    };
    for (const std::int32_t face : faces)
        for (int k = 0; k < 3; ++k)
            if (creases.cut[3 * std::int64_t{face} + k] == 1) add_crease(face, k);
    const std::int64_t on_creases = result.samples.position.size();
    for (const std::int32_t face : faces) add_face(face);
    for (std::int64_t i = 0; i < result.samples.position.size(); ++i)
        result.samples.bounds.extend(result.samples.position[i]);
    set_tolerances(work, tolerance, on_creases, tips, patch_tuning.around_tip * std::min(spacing, least_ring), result);
    return result;
}

base::Array<std::uint8_t> patches_in_contact(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                             const Creases& creases, const MeshSamples& places, double near) {
    const std::int64_t count = places.position.size();
    base::Array<std::int32_t> against(work.memory, count); // for each place: a nearby face of another component, or -1
    work.for_chunks(count, 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 normal = unit_normal(mesh, places.face[i]);
            against[i] = -1;
            const auto meet = [&](std::int32_t face, double t, int sign) {
                if (t > 1.0 || sign > 0 || mesh.component[face] == mesh.component[places.face[i]]) return;
                const glm::dvec3 there = doubled_area(mesh.corners(face));
                if (glm::dot(there, normal) < patch_tuning.most_opposite * glm::length(there))
                    against[i] = std::max(against[i], face);
            };
            tree.crossings(places.position[i] - near * normal, 2.0 * near * normal, meet);
        }
    });
    base::Array<std::uint8_t> touches(work.memory, creases.patches);
    for (std::int64_t i = 0; i < count; ++i) {
        if (against[i] < 0) continue;
        touches[creases.patch[places.face[i]]] = 1;
        touches[creases.patch[against[i]]] = 1;
    }
    return touches;
}

} // namespace hrbfnpr::mesh

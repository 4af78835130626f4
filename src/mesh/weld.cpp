// SPDX-License-Identifier: MIT
#include "mesh/weld.h"

#include "base/bits.h"
#include "base/status.h"
#include "mesh/join_borders.h"
#include "mesh/part_edges.h"
#include "mesh/split_slivers.h"
#include "mesh/walls.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace hrbfnpr::mesh {
namespace {

constexpr double rounding = 1e-6; // diagonals: vertices of borders that are no farther from each other are one
constexpr std::int64_t corners_a_task = 8192;

[[nodiscard]] std::uint64_t mixed(std::uint64_t bits) noexcept { // the end of MurmurHash3
    bits = (bits ^ bits >> 33U) * 0xff51afd7ed558ccdU;
    bits = (bits ^ bits >> 33U) * 0xc4ceb9fe1a85ec53U;
    return bits ^ bits >> 33U;
}

// Numbers of things that are different, in the order in which they come.
class Numbers {
public:
    Numbers(base::Memory& memory, std::int64_t most)
        : place_(memory, static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * most + 16)))) {}

    // The number of what `same(number)` says is the same, or `next`, which it has from now on.
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
    base::Array<std::int32_t> place_; // a number and 1, or 0
};

[[nodiscard]] glm::dvec3 vertex_at(const base::InView& vertices, std::int64_t i) noexcept {
    // -0 is the same place as 0.
    return {vertices.get(i, 0) + 0.0, vertices.get(i, 1) + 0.0, vertices.get(i, 2) + 0.0};
}

void check_vertex(const glm::dvec3& p, std::int64_t vertex, std::int64_t face) {
    for (glm::length_t c = 0; c < 3; ++c)
        if (!(std::abs(p[c]) <= largest_coordinate))
            fail(Status::invalid_argument,
                 "vertices[%lld], a corner of triangles[%lld], has the coordinate %g; coordinates must be finite and "
                 "within 1e60: leave the face out, or scale the mesh",
                 static_cast<long long>(vertex), static_cast<long long>(face), p[c]);
}

// Numbers of given vertices.
[[nodiscard]] base::Array<Triangle> read_triangles(const base::Runtime& runtime, const MeshInput& input,
                                                   const base::Progress& progress) {
    const std::int64_t vertices = input.vertices.count;
    base::Array<Triangle> triangle(runtime.memory);
    triangle.resize_for_overwrite(input.triangles.count);
    runtime.parallel.for_chunks(triangle.size(), corners_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
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

[[nodiscard]] std::uint64_t hash_of(const glm::dvec3& p) noexcept {
    std::uint64_t hash = mixed(base::bit_cast<std::uint64_t>(p.x));
    hash = mixed(hash ^ base::bit_cast<std::uint64_t>(p.y));
    return mixed(hash ^ base::bit_cast<std::uint64_t>(p.z));
}

// From given numbers of vertices to those of different places.
void join_vertices(const base::InView& given, Welded& welded, MeshReport& report, const base::Progress& progress) {
    base::Memory& memory = welded.vertex.memory();
    base::Array<std::int32_t> number(memory, given.count);
    for (const Triangle& t : welded.triangle)
        for (const std::int32_t corner : t) number[corner] = 1; // is used
    progress.check();
    Numbers numbers(memory, given.count);
    std::int64_t used = 0;
    for (std::int64_t i = 0; i < given.count; ++i) {
        if (i % corners_a_task == 0) progress.check();
        if (number[i] == 0) continue;
        ++used;
        const glm::dvec3 p = vertex_at(given, i);
        const std::int64_t next = welded.vertex.size();
        const std::int64_t found =
            numbers.find_or_add(hash_of(p), next, [&](std::int64_t k) { return welded.vertex[k] == p; });
        if (found == next) welded.vertex.push_back(p);
        number[i] = static_cast<std::int32_t>(found);
    }
    report.welded_vertices = used - welded.vertex.size();
    for (Triangle& t : welded.triangle)
        for (std::int32_t& corner : t) corner = number[corner];
}

// Whether each edge runs as often forward as backward, as those of closed meshes do, and so there are no borders: but
// for one mesh in 2^64 where it does not.  Sorting all edges takes longer.
[[nodiscard]] bool is_balanced(const base::Array<Triangle>& triangle) noexcept {
    std::uint64_t sum = 0;
    for (const Triangle& t : triangle)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto from = static_cast<std::uint64_t>(t[k]);
            const auto to = static_cast<std::uint64_t>(t[(k + 1) % 3]);
            sum += mixed(from << 32U | to) - mixed(to << 32U | from);
        }
    return sum == 0;
}

// Faces that were made apart have corners that rounding keeps apart.
void join_rounded(const base::Runtime& runtime, Welded& welded, MeshReport& report, const base::Progress& progress) {
    geometry::Bounds bounds;
    for (const glm::dvec3& p : welded.vertex) bounds.extend(p);
    const std::int64_t before = welded.vertex.size();
    join_borders(runtime, welded.vertex, welded.triangle, rounding * bounds.diagonal(), progress);
    report.welded_vertices += before - welded.vertex.size();
}

[[nodiscard]] Triangle sorted(Triangle t) noexcept {
    std::sort(t.begin(), t.end());
    return t;
}

// 1 where the corners come in an even order, else -1.
[[nodiscard]] std::int32_t sense(const Triangle& t) noexcept {
    const int turns = (t[0] > t[1] ? 1 : 0) + (t[1] > t[2] ? 1 : 0) + (t[0] > t[2] ? 1 : 0);
    return turns % 2 == 0 ? 1 : -1;
}

// What else was given with the corners of a face that is kept.
struct Repeated {
    std::int32_t balance = 0; // how many in one sense more than in the other
    std::int32_t last = -1;   // the last one's number
};

void leave_out_faces(Welded& welded, base::Array<Repeated>& repeated, MeshReport& report,
                     const base::Progress& progress) {
    Numbers numbers(welded.vertex.memory(), welded.triangle.size());
    std::int64_t kept = 0;
    for (std::int64_t face = 0; face < welded.triangle.size(); ++face) {
        if (face % corners_a_task == 0) progress.check();
        const Triangle t = welded.triangle[face];
        const glm::dvec3 area = doubled_area({welded.vertex[t[0]], welded.vertex[t[1]], welded.vertex[t[2]]});
        // Nor has it a normal where the square of its area is too small for a double.
        if (!(glm::dot(area, area) >= std::numeric_limits<double>::min())) {
            ++report.degenerate_faces;
            continue;
        }
        const Triangle key = sorted(t);
        const std::uint64_t hash =
            mixed(mixed(static_cast<std::uint64_t>(key[0]) << 32U | static_cast<std::uint64_t>(key[1])) ^
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
}

// Between solids that share them there is nothing to be seen.  Where solids touch in more than in faces that both have,
// each keeps its own.
void leave_out_walls(const base::Runtime& runtime, const base::Array<Repeated>& repeated, Welded& welded,
                     MeshReport& report, const base::Progress& progress) {
    if (report.repeated_faces == 0) return;
    const std::int64_t faces = welded.triangle.size();
    base::Array<std::uint8_t> twin(runtime.memory, faces);
    for (std::int64_t face = 0; face < faces; ++face) twin[face] = repeated[face].balance == 0 ? 1 : 0;
    const base::Array<Twin> kind = find_walls(runtime, welded.vertex, welded.triangle, twin, progress);
    base::Array<Triangle> other(runtime.memory); // sides of contacts
    base::Array<std::int32_t> given(runtime.memory);
    std::int64_t kept = 0;
    for (std::int64_t face = 0; face < faces; ++face) {
        if (kind[face] == Twin::wall) {
            ++report.repeated_faces;
            continue;
        }
        if (kind[face] == Twin::contact) {
            --report.repeated_faces;
            const Triangle& t = welded.triangle[face];
            other.push_back({t[0], t[2], t[1]});
            given.push_back(repeated[face].last);
        }
        welded.triangle[kept] = welded.triangle[face];
        welded.given_face[kept++] = welded.given_face[face];
    }
    welded.triangle.resize(kept);
    welded.given_face.resize(kept);
    for (std::int64_t i = 0; i < other.size(); ++i) {
        welded.triangle.push_back(other[i]);
        welded.given_face.push_back(given[i]);
    }
}

} // namespace

Welded weld(const base::Runtime& runtime, const MeshInput& input, MeshReport& report, const base::Progress& progress) {
    Welded welded(runtime.memory);
    report.given_vertices = input.vertices.count;
    report.given_faces = input.triangles.count;
    welded.triangle = read_triangles(runtime, input, progress);
    welded.given_face.resize_for_overwrite(welded.triangle.size());
    std::iota(welded.given_face.begin(), welded.given_face.end(), 0);
    join_vertices(input.vertices, welded, report, progress);
    if (!is_balanced(welded.triangle)) join_rounded(runtime, welded, report, progress);
    report.degenerate_faces = split_slivers(welded, progress);
    base::Array<Repeated> repeated(runtime.memory);
    leave_out_faces(welded, repeated, report, progress);
    leave_out_walls(runtime, repeated, welded, report, progress);
    part_edges(runtime, welded.vertex, welded.triangle, progress);
    if (welded.triangle.empty())
        fail(Status::invalid_argument, "triangles has %lld faces, and none has an area; give at least one that has",
             static_cast<long long>(report.given_faces));
    return welded;
}

} // namespace hrbfnpr::mesh

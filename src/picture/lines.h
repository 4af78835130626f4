// SPDX-License-Identifier: MIT
// Makes the line set of a surface. The lines of drawings come from it.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/memory.h"
#include "picture/shape.h"
#include "picture/style.h"
#include "picture/wanted_lines.h"

#include <hrbfnpr.h>

namespace hrbfnpr::picture {

using Polyline = Points;

// Lines that are found once, when a line set is made. This is a hrbfnpr_line_desc that owns its texts and lists.
struct LinesOnce {
    LinesOnce(std::uint32_t line_kind, Pool& pool)
        : kind(line_kind), name(&pool), levels(&pool), points(&pool), line_first(&pool) {}
    LinesOnce(LinesOnce&&) noexcept = default;
    LinesOnce& operator=(LinesOnce&&) = default;
    LinesOnce(const LinesOnce&) = delete; // A copy would allocate its lists outside the pool.
    LinesOnce& operator=(const LinesOnce&) = delete;

    std::uint32_t kind;
    String name;
    double lower = 0.0;
    double upper = 0.0;
    double shortest = 0.01;
    glm::dvec3 plane{0.0, 0.0, 1.0}; // For SECTION: the common normal of the planes.
    Vector<double> levels;           // For SECTION: the offsets of the planes.
    // For OWN and TANGENT_EDGE: the points of the polylines, one polyline after the other.
    Points points;
    // For OWN and TANGENT_EDGE: the index in `points` where each polyline begins, and the size of `points`.
    Vector<std::uint32_t> line_first;

    // Returns a descriptor that points to the contents of this object. It is valid until this object changes or is
    // destroyed.
    [[nodiscard]] hrbfnpr_line_desc view() const noexcept;
};

// Returns the lines that are found once, except the lines of a plate and the edges of a mesh. The lines come from the
// settings if the settings have lines and the caller names none. Otherwise they come from `wanted`.
[[nodiscard]] Vector<LinesOnce> lines_found_once(const Call& call, const hrbfnpr_model& model,
                                                 const Vector<WantedLine>& wanted);

// Makes the line set for the lines of a style and for `more` lines, such as the section of a plate. Returns a null
// handle if the picture needs no line set. `casts`: the surface of the line set casts shadows, even if there are no
// lines.
[[nodiscard]] LineSet make_lines(const Call& call, const Surface& surface, const Style& style,
                                 const Vector<WantedLine>& wanted, const Vector<LinesOnce>& more, bool casts);

// Returns the sharp edges of a mesh, joined to polylines. An edge is sharp if its faces meet at more than `angle`
// degrees, as in hrbfnpr_mesh_edges. A polyline continues through a vertex where exactly two sharp edges meet. Open
// polylines come before closed ones. Throws Error{invalid_argument} for a shape without faces.
[[nodiscard]] Vector<Polyline> mesh_creases(hrbfnpr_context& context, const Shape& shape, double angle,
                                            hrbfnpr_operation* operation, Pool& pool);

// Returns the tangent edges of a mesh, joined to polylines as those of mesh_creases(). Where a polyline bends evenly,
// it gets more points, so that arcs are round. Sharp edges are found as `angle` says, or if it is 0 as in a fit of the
// mesh.
[[nodiscard]] Vector<Polyline> mesh_tangents(hrbfnpr_context& context, const Shape& shape, double angle,
                                             hrbfnpr_operation* operation, Pool& pool);

// Returns polylines as lines to find once.
[[nodiscard]] LinesOnce as_lines_once(std::uint32_t kind, const char* name, const Vector<Polyline>& lines, Pool& pool);

// Removes the creases between the facets of a rounded shape: if the creases are short on average, only long creases are
// kept.
[[nodiscard]] Vector<Polyline> without_facets(Vector<Polyline> creases, double diagonal);

// The results of comparing the drawn pieces of lines with rays.
struct LineProof {
    std::int64_t pieces = 0, agreeing = 0, undecided = 0, repaired = 0;

    [[nodiscard]] std::int64_t decided() const noexcept { return pieces - undecided; }
    void add(const LineProof& other) noexcept {
        pieces += other.pieces;
        agreeing += other.agreeing;
        undecided += other.undecided;
        repaired += other.repaired;
    }
};
// Returns the counts in words.
[[nodiscard]] String text_of(const LineProof& proof, Pool& pool);
// Tells how many pieces agree with rays. Warns if some do not. Says nothing if no piece was compared.
void tell_proof(Report& report, const LineProof& proof);

// Warns if lines in a drawing may be wrong or incomplete.
void tell_doubts(Report& report, const hrbfnpr_drawing_info& info);

} // namespace hrbfnpr::picture

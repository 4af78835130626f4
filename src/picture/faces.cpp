// SPDX-License-Identifier: MIT
#include "picture/faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::picture {
namespace {

// A side (half-edge) of a face. It is stored in the list of its vertex with the lower index.
struct SideOfVertex {
    std::int64_t high; // The vertex with the higher index.
    std::int64_t side;
};

Edge ends_of_side(const Triangle& face, std::size_t k) noexcept {
    const std::int64_t a = face[k];
    const std::int64_t b = face[(k + 1) % 3];
    return a < b ? Edge{a, b} : Edge{b, a};
}

hrbfnpr_array mesh_view(const Mesh& mesh, std::uint32_t attribute) {
    hrbfnpr_array view{};
    call([&](hrbfnpr_error* error) { return hrbfnpr_mesh_view(mesh.get(), attribute, &view, error); });
    return view;
}

// Returns an array of a mesh as a span. The elements must be contiguous.
template <class T>
std::span<const T> dense_view(const hrbfnpr_array& view, std::uint32_t scalar, std::uint32_t components) {
    HRBFNPR_ASSERT(view.scalar == scalar && view.components == components);
    HRBFNPR_ASSERT(view.stride == 0 || view.stride == static_cast<std::int64_t>(sizeof(T)));
    return {static_cast<const T*>(view.data), static_cast<std::size_t>(view.count)};
}

} // namespace

FaceEdges find_edges(const Vector<Triangle>& triangles, std::size_t vertices, Pool& pool) {
    const std::size_t faces = triangles.size();
    FaceEdges edges(pool);
    edges.faces = static_cast<std::int64_t>(faces);
    Vector<std::size_t> begin(vertices + 1, 0, &pool);
    for (std::size_t k = 0; k < 3; ++k)
        for (const Triangle& face : triangles) {
            const Edge ends = ends_of_side(face, k);
            HRBFNPR_ASSERT(ends[0] >= 0 && static_cast<std::size_t>(ends[1]) < vertices);
            ++begin[static_cast<std::size_t>(ends[0]) + 1];
        }
    for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    Vector<SideOfVertex> there(3 * faces, SideOfVertex{}, &pool);
    {
        Vector<std::size_t> next(begin.begin(), begin.end() - 1, &pool);
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t f = 0; f < faces; ++f) {
                const Edge ends = ends_of_side(triangles[f], k);
                there[next[static_cast<std::size_t>(ends[0])]++] = {ends[1], static_cast<std::int64_t>(k * faces + f)};
            }
    }
    edges.sides.reserve(there.size());
    edges.of_side.resize(there.size());
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto from = there.begin() + static_cast<std::ptrdiff_t>(begin[v]);
        const auto to = there.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
        std::sort(from, to, [](const SideOfVertex& a, const SideOfVertex& b) {
            return a.high < b.high || (a.high == b.high && a.side < b.side);
        });
        for (auto side = from; side != to; ++side) {
            if (side == from || side->high != (side - 1)->high) {
                edges.first.push_back(static_cast<std::int64_t>(edges.sides.size()));
                edges.ends.push_back({static_cast<std::int64_t>(v), side->high});
            }
            edges.sides.push_back(side->side);
            edges.of_side[static_cast<std::size_t>(side->side)] = static_cast<std::int64_t>(edges.ends.size()) - 1;
        }
    }
    edges.first.push_back(static_cast<std::int64_t>(edges.sides.size()));
    return edges;
}

Vector<PlainEdge> plain_edges(const FaceEdges& edges, Pool& pool) {
    Vector<PlainEdge> plain(&pool);
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (edges.is_plain(e)) {
            const auto sides = edges.sides_of(e);
            plain.push_back({e, edges.face(sides[0]), edges.face(sides[1])});
        }
    return plain;
}

glm::dvec3 unit_or_zero(const glm::dvec3& vector) noexcept {
    constexpr double least = 1e-300;
    return vector / std::max(glm::length(vector), least);
}

Vector<double> areas_of(const Points& points, const Vector<Triangle>& faces, Pool& pool) {
    Vector<double> areas(&pool);
    areas.reserve(faces.size());
    for (const Triangle& face : faces) areas.push_back(glm::length(doubled_area_of(points, face)) / 2.0);
    return areas;
}

double box_diagonal_of(const Points& points) noexcept {
    if (points.empty()) return 0.0;
    glm::dvec3 low = points.front();
    glm::dvec3 high = low;
    for (const glm::dvec3& p : points)
        for (int axis = 0; axis < 3; ++axis) {
            if (std::isnan(p[axis])) return std::numeric_limits<double>::quiet_NaN();
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    return glm::length(high - low);
}

double sum_in_pairs(std::span<const double> numbers) noexcept {
    constexpr std::size_t lanes = 8;
    constexpr std::size_t at_once = 128;
    const std::size_t count = numbers.size();
    if (count < lanes) {
        double sum = 0.0;
        for (const double x : numbers) sum += x;
        return sum;
    }
    if (count > at_once) {
        const std::size_t half = count / 2 - count / 2 % lanes;
        return sum_in_pairs(numbers.first(half)) + sum_in_pairs(numbers.subspan(half));
    }
    std::array<double, lanes> sum{};
    std::copy_n(numbers.begin(), lanes, sum.begin());
    std::size_t i = lanes;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k) sum[k] += numbers[i + k];
    double all = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
    for (; i < count; ++i) all += numbers[i];
    return all;
}

double percentile(Vector<double>& numbers, double percent) {
    HRBFNPR_ASSERT(percent >= 0.0 && percent <= 100.0);
    if (numbers.empty()) return 0.0;
    const auto is_nan = [](double x) { return std::isnan(x); };
    if (std::any_of(numbers.begin(), numbers.end(), is_nan)) return std::numeric_limits<double>::quiet_NaN();
    const double at = percent / 100.0 * static_cast<double>(numbers.size() - 1);
    const auto below = numbers.begin() + static_cast<std::ptrdiff_t>(std::floor(at));
    std::nth_element(numbers.begin(), below, numbers.end());
    if (below + 1 == numbers.end()) return *below;
    const double low = *below;
    const double high = *std::min_element(below + 1, numbers.end());
    const double share = at - std::floor(at);
    return share >= 0.5 ? high - (high - low) * (1.0 - share) : low + (high - low) * share;
}

hrbfnpr_mesh_info info_of(const Mesh& mesh) {
    auto info = defaults<hrbfnpr_mesh_info>(hrbfnpr_mesh_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_mesh_get_info(mesh.get(), &info, error); });
    return info;
}

Points vertices_of(const Mesh& mesh, Pool& pool) {
    const auto view = dense_view<glm::dvec3>(mesh_view(mesh, HRBFNPR_MESH_ATTRIBUTE_VERTEX), HRBFNPR_SCALAR_FLOAT64, 3);
    return {view.begin(), view.end(), &pool};
}

Vector<Triangle> triangles_of(const Mesh& mesh, Pool& pool) {
    using Given = std::array<std::int32_t, 3>;
    Vector<Triangle> triangles(&pool);
    const auto view = dense_view<Given>(mesh_view(mesh, HRBFNPR_MESH_ATTRIBUTE_TRIANGLE), HRBFNPR_SCALAR_INT32, 3);
    triangles.reserve(view.size());
    for (const Given& face : view) triangles.push_back({face[0], face[1], face[2]});
    return triangles;
}

Vector<std::int32_t> numbers_of(const Mesh& mesh, std::uint32_t attribute, Pool& pool) {
    HRBFNPR_ASSERT(attribute == HRBFNPR_MESH_ATTRIBUTE_COMPONENT || attribute == HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE);
    const auto view = dense_view<std::int32_t>(mesh_view(mesh, attribute), HRBFNPR_SCALAR_INT32, 1);
    return {view.begin(), view.end(), &pool};
}

} // namespace hrbfnpr::picture

// SPDX-License-Identifier: MIT
#include "picture/sources.h"

#include "api/checks.h"
#include "api/lists.h"
#include "api/views.h"
#include "base/utf8.h"

#include <algorithm>
#include <cstring>

namespace hrbfnpr::picture {
namespace {

constexpr std::int64_t most_sources = 10'000;
constexpr std::size_t longest_name = 4096;

// The name of a field, such as "picture_desc.sources[2].points". It is used in messages.
struct FieldName {
    FieldName(const char* owner, const char* field) noexcept {
        std::snprintf(text, sizeof text, "%.90s.%s", owner, field);
    }
    char text[128];
};

Points read_points(const hrbfnpr_array& array, const char* owner, const char* field, Pool& pool) {
    const base::InView view = api::in_view(array, FieldName(owner, field).text, api::points_type);
    Points points(&pool);
    points.reserve(static_cast<std::size_t>(view.count));
    for (std::int64_t i = 0; i < view.count; ++i) points.emplace_back(view.get(i, 0), view.get(i, 1), view.get(i, 2));
    return points;
}

// Reads tuples of point indices.
template <std::size_t size>
Vector<std::array<std::int64_t, size>> read_indices(const hrbfnpr_array& array, std::size_t points, const char* owner,
                                                    const char* field, const char* what, Pool& pool) {
    const base::InView view = api::in_view(array, FieldName(owner, field).text, {size, api::index_types});
    Vector<std::array<std::int64_t, size>> tuples(&pool);
    tuples.reserve(static_cast<std::size_t>(view.count));
    for (std::int64_t i = 0; i < view.count; ++i) {
        std::array<std::int64_t, size>& tuple = tuples.emplace_back();
        for (std::uint32_t k = 0; k < size; ++k) {
            tuple[k] = view.get_integer(i, k);
            if (tuple[k] < 0 || tuple[k] >= static_cast<std::int64_t>(points))
                fail(Status::invalid_argument, "%s: %s %lld names vertex %lld, but there are only %zu vertices",
                     FieldName(owner, field).text, what, static_cast<long long>(i), static_cast<long long>(tuple[k]),
                     points);
        }
    }
    return tuples;
}

std::optional<glm::dvec3> given_up(const double (&given)[3], const char* owner) {
    const glm::dvec3 direction(given[0], given[1], given[2]);
    if (direction == glm::dvec3(0.0)) return std::nullopt;
    const double length = glm::length(direction);
    if (!(length > 1e-100 && length < 1e100))
        fail(Status::invalid_argument, "%s.up is (%g, %g, %g); it must have a direction, or be 0, 0, 0", owner,
             given[0], given[1], given[2]);
    return direction;
}

void read_text(const char* text, String& to, const char* owner, const char* field) {
    if (text == nullptr) return;
    const std::size_t size = strnlen(text, longest_name + 1);
    if (size > longest_name || !base::is_utf8({text, size}))
        fail(Status::invalid_argument, "%s must be UTF-8 of at most %zu bytes", FieldName(owner, field).text,
             longest_name);
    to.assign(text, size);
}

void check_finite(const double (&numbers)[3], const char* owner, const char* field) {
    for (const double number : numbers) api::Checks(owner).finite(field, number);
}

// Checks that the points of an image are as many as its pixels.
void check_image(const Shape& shape, const char* owner) {
    if (shape.columns == 0 && shape.rows == 0) return;
    const auto count = static_cast<std::int64_t>(shape.points.size());
    if (shape.columns < 1 || shape.rows < 1 || count / shape.rows != shape.columns || count % shape.rows != 0)
        fail(Status::invalid_argument, "%s.columns is %lld and rows is %lld; there are %lld points", owner,
             static_cast<long long>(shape.columns), static_cast<long long>(shape.rows), static_cast<long long>(count));
}

Shape read_shape(const hrbfnpr_picture_source& given, const char* owner, Pool& pool) {
    Shape shape(pool);
    shape.points = read_points(given.points, owner, "points", pool);
    if (shape.points.empty())
        fail(Status::invalid_argument, "%s has no points, no model and no point set; give one of them", owner);
    shape.triangles = read_indices<3>(given.triangles, shape.points.size(), owner, "triangles", "face", pool);
    if (!shape.is_mesh()) shape.normals = read_points(given.normals, owner, "normals", pool);
    if (!shape.normals.empty() && shape.normals.size() != shape.points.size())
        fail(Status::invalid_argument, "%s.normals has %zu elements and points has %zu; give one for each, or none",
             owner, shape.normals.size(), shape.points.size());
    shape.has_sharp_edges = (given.flags & HRBFNPR_SOURCE_HAS_SHARP_EDGES) != 0 && shape.is_mesh();
    if (shape.has_sharp_edges)
        shape.sharp_edges = read_indices<2>(given.sharp_edges, shape.points.size(), owner, "sharp_edges", "edge", pool);
    shape.up = given_up(given.up, owner);
    read_text(given.up_by, shape.up_by, owner, "up_by");
    if ((given.flags & HRBFNPR_SOURCE_HAS_VIEWPOINT) != 0) {
        check_finite(given.viewpoint, owner, "viewpoint");
        shape.viewpoint = glm::dvec3(given.viewpoint[0], given.viewpoint[1], given.viewpoint[2]);
    }
    shape.is_photo = (given.flags & HRBFNPR_SOURCE_IS_PHOTO) != 0;
    shape.columns = given.columns;
    shape.rows = given.rows;
    check_image(shape, owner);
    return shape;
}

void read_source(const hrbfnpr_picture_source& given, const char* owner, Pool& pool, Source& source) {
    api::Checks(owner).flags("flags", given.flags,
                             HRBFNPR_SOURCE_HAS_SHARP_EDGES | HRBFNPR_SOURCE_HAS_VIEWPOINT | HRBFNPR_SOURCE_IS_PHOTO);
    read_text(given.name, source.name, owner, "name");
    const bool has_arrays = given.points.count != 0 || given.triangles.count != 0 || given.normals.count != 0;
    if (given.model == nullptr && given.point_set == nullptr) {
        source.shape.emplace(read_shape(given, owner, pool));
        source.values = read_source_values(given, *source.shape, owner, pool);
        return;
    }
    if (has_arrays)
        fail(Status::invalid_argument, "%s has points and a %s; give one of them", owner,
             given.model != nullptr ? "model" : "point_set");
    if (given.field_count != 0)
        fail(Status::invalid_argument, "%s.field_count is %lld, but only points and meshes have fields; give 0", owner,
             static_cast<long long>(given.field_count));
    if (given.model != nullptr) source.model = Model::shared(given.model);
    if (given.point_set != nullptr) source.marks = PointSet::shared(given.point_set);
}

} // namespace

Source read_source(const hrbfnpr_picture_source* given, Pool& pool) {
    Source source(pool);
    read_source(api::read_struct(given, "picture_source"), "picture_source", pool, source);
    return source;
}

Vector<Source> read_sources(const hrbfnpr_picture_desc& desc, Pool& pool) {
    const api::List<hrbfnpr_picture_source> list(desc.sources, desc.source_count, desc.source_stride, most_sources,
                                                 "picture_desc.sources");
    if (list.count() == 0) fail(Status::invalid_argument, "picture_desc.source_count is 0; give at least one source");
    Vector<Source> sources(&pool);
    sources.reserve(static_cast<std::size_t>(list.count()));
    for (std::int64_t i = 0; i < list.count(); ++i)
        read_source(list[i], list.name(i).text, pool, sources.emplace_back(pool));
    const auto is_set = [](const Source& source) { return !source.shape && !source.model; };
    if (sources.size() > 1 && std::any_of(sources.begin(), sources.end(), is_set))
        fail(Status::invalid_argument,
             "picture_desc.sources has a point set and other sources; draw the point set alone");
    return sources;
}

} // namespace hrbfnpr::picture

// SPDX-License-Identifier: MIT
// Casts rays on a model, and finds which points are inside it.
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/line_set.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/queries.h"
#include "curves/mesh_rays.h"
#include "surface/cast_rays.h"
#include "surface/ray_range.h"
#include "surface/region.h"

using namespace hrbfnpr;

static_assert(static_cast<int>(surface::RayStatus::hit) == HRBFNPR_RAY_HIT);
static_assert(static_cast<int>(surface::RayStatus::miss) == HRBFNPR_RAY_MISS);
static_assert(static_cast<int>(surface::RayStatus::truncated) == HRBFNPR_RAY_TRUNCATED);
static_assert(static_cast<int>(surface::RayStatus::evaluation_limit) == HRBFNPR_RAY_EVALUATION_LIMIT);
static_assert(static_cast<int>(surface::RayStatus::not_finite) == HRBFNPR_RAY_NOT_FINITE);

namespace hrbfnpr::api {

namespace {

using Cast = hrbfnpr_cast_desc;
using surface::RaySettings;

constexpr std::int32_t most_hits = 256;

constexpr auto cast_fields() noexcept {
    return FieldTable{
        field("maximum_hits", &Cast::maximum_hits, &RaySettings::maximum_hits, rule::Between{1.0, most_hits}),
        field("evaluation_limit", &Cast::evaluation_limit, &RaySettings::evaluation_limit,
              rule::Between{1.0, 1000000.0}),
        reserved("reserved", &Cast::reserved),
        field("t_min", &Cast::t_min, &RaySettings::t_min, rule::Finite{}),
        field("t_max", &Cast::t_max, &RaySettings::t_max, rule::Any{}),
        field("lipschitz", &Cast::lipschitz, &RaySettings::lipschitz, rule::not_negative),
        field("smallest_step", &Cast::smallest_step, &RaySettings::smallest_step, rule::PositiveUpTo{0.1}),
        field("tolerance", &Cast::tolerance, &RaySettings::tolerance, rule::Positive{}),
        field("line_set", &Cast::line_set, rule::Any{}),
        field("refine", &Cast::refine, rule::Any{}),
        reserved("reserved2", &Cast::reserved2)};
}
static_assert(cast_fields().covers<Cast>());

} // namespace

template <>
hrbfnpr_cast_desc defaults() noexcept {
    hrbfnpr_cast_desc desc{};
    cast_fields().set_defaults(RaySettings{}, desc);
    desc.refine = 1;
    return desc;
}

template <>
hrbfnpr_ray_hits defaults() noexcept {
    return {};
}

namespace {

// The largest number of points in a block; for rays, the largest number of hits in a block.
constexpr std::int64_t rays_at_once = 65536;

RaySettings checked(const hrbfnpr_cast_desc& desc, const hrbfnpr_model& model) {
    cast_fields().check("cast_desc", desc);
    Checks("cast_desc").zero_or_one("refine", desc.refine);
    if (desc.line_set != nullptr && &desc.line_set->model != &model)
        fail(Status::invalid_argument, "cast_desc.line_set was made for another model; give a line set of this model");
    if (!(desc.t_max >= desc.t_min))
        fail(Status::invalid_argument, "cast_desc.t_max is %g; it must be at least t_min, which is %g", desc.t_max,
             desc.t_min);
    RaySettings settings;
    cast_fields().copy(desc, settings);
    return settings;
}

struct RayOutputs {
    RayOutputs(const hrbfnpr_ray_hits& given, std::uint32_t room, std::int64_t rays)
        : count(out_view(&given.count, "ray_hits.count", {1, uint32_only}, rays)),
          t(out_view(&given.t, "ray_hits.t", {room, float_types}, rays)),
          position(out_view(&given.position, "ray_hits.position", {3 * room, float_types}, rays)),
          normal(out_view(&given.normal, "ray_hits.normal", {3 * room, float_types}, rays)),
          entering(out_view(&given.entering, "ray_hits.entering", {room, uint8_only}, rays)),
          status(out_view(&given.status, "ray_hits.status", {1, uint8_or_uint32}, rays)) {
        Checks("ray_hits").zero("reserved", given.reserved);
    }
    base::OutView count, t, position, normal, entering, status;
};

// Writes the hits of a ray. Ray i of the block is ray first + i of the outputs.
void write_ray(const surface::RayHits& block, std::int64_t i, std::int64_t maximum_hits, const RayOutputs& out,
               std::int64_t first) {
    if (out.count) out.count.set(first + i, 0, static_cast<double>(block.count[i]));
    if (out.status) out.status.set(first + i, 0, static_cast<double>(block.status[i]));
    for (std::int64_t h = 0; h < maximum_hits; ++h) {
        const std::int64_t at = i * maximum_hits + h;
        const auto component = static_cast<std::uint32_t>(h);
        if (h < block.count[i] && !std::isfinite(block.t[at]))
            fail(Status::invalid_argument, "directions[%lld] is so short that t overflows; make it longer",
                 static_cast<long long>(first + i));
        if (out.t) CheckedOutput("ray_hits.t").set(out.t, first + i, component, block.t[at]);
        if (out.position)
            CheckedOutput("ray_hits.position").set(out.position, first + i, block.position[at], 3 * component);
        if (out.normal) set_vector(out.normal, first + i, block.normal[at], 3 * component);
        if (out.entering) out.entering.set(first + i, component, static_cast<double>(block.entering[at]));
    }
}

// Casts rays without a mesh.
class RaySearch {
public:
    RaySearch(const hrbfnpr_model& model, const surface::RaySettings& settings) noexcept
        : model_(model), settings_(settings) {}

    // Prepares the search for a number of rays, unless it is prepared.
    void prepare(std::int64_t rays, const base::Progress& progress) {
        if (prepared_ || rays == 0) return;
        prepared_ = true;
        // A caller who gives a bound asks for steps of |f| / L.
        if (settings_.lipschitz > 0.0) return;
        cells_ = model_.ray_cells_for(rays, progress);
        if (cells_ == nullptr)
            settings_.lipschitz = surface::lipschitz_estimate({model_.runtime(), progress}, model_.implicit());
    }
    void cast(const base::Work& work, const surface::Rays& rays, surface::RayHits& hits) const {
        if (cells_ != nullptr)
            surface::cast_rays(work, *cells_, model_.implicit(), settings_, rays, hits);
        else
            surface::cast_rays(work, model_.implicit(), settings_, rays, hits);
    }

private:
    const hrbfnpr_model& model_;
    surface::RaySettings settings_;
    const surface::RayCells* cells_ = nullptr;
    bool prepared_ = false;
};

// Casts rays on the mesh of a line set, and those that it leaves without the mesh.
class MeshSearch {
public:
    MeshSearch(const hrbfnpr_model& model, const hrbfnpr_line_set& lines, const curves::MeshRaySettings& settings,
               RaySearch& rest, std::int64_t rays, const base::Progress& progress)
        : settings_(settings), rest_(rest), rays_(rays), mesh_(lines.ray_mesh(progress)),
          implicit_(model.implicit_for(settings.refine ? evaluations * static_cast<double>(rays) : 0.0, progress)) {}

    void cast(const base::Work& work, const surface::Rays& rays, surface::RayHits& hits) const {
        const base::Array<std::int32_t> left = curves::cast_rays(work, implicit_, mesh_, settings_, rays, hits);
        if (left.empty()) return;
        rest_.prepare(rays_, work.without_progress());
        surface::Rays some(work.memory);
        for (const std::int32_t ray : left) {
            some.origin.push_back(rays.origin[ray]);
            some.direction.push_back(rays.direction[ray]);
        }
        surface::RayHits found(work.memory);
        rest_.cast(work.without_progress(), some, found);
        for (std::int64_t i = 0; i < left.size(); ++i) surface::copy_ray(found, i, left[i], settings_.rays, hits);
    }

private:
    static constexpr double evaluations = 4.0; // the usual number of evaluations of a ray

    curves::MeshRaySettings settings_;
    RaySearch& rest_;
    std::int64_t rays_;
    const curves::RayMesh& mesh_;
    const implicit::Implicit& implicit_;
};

// Casts rays in blocks by cast(work, rays, hits) and writes their hits. Returns the number of rays that have a hit.
template <class Cast>
std::int64_t cast_blocks(const base::Runtime& runtime, const Queries& origins, const Queries& directions,
                         std::int64_t maximum_hits, const RayOutputs& out, const base::Progress& progress,
                         Cast&& cast) {
    surface::Rays rays(runtime.memory);
    surface::RayHits block(runtime.memory);
    std::int64_t hit_rays = 0;
    for_blocks(origins.count(), rays_at_once / maximum_hits, progress,
               [&](std::int64_t begin, std::int64_t end, const base::Progress& part) {
                   origins.read(begin, end, rays.origin);
                   directions.read(begin, end, rays.direction);
                   cast(base::Work(runtime, part), rays, block);
                   for (std::int64_t i = 0; i < end - begin; ++i) {
                       write_ray(block, i, maximum_hits, out, begin);
                       hit_rays += block.count[i] > 0 ? 1 : 0;
                   }
               });
    return hit_rays;
}

std::int64_t cast_rays(const hrbfnpr_model& model, const Queries& origins, const Queries& directions,
                       const hrbfnpr_cast_desc& desc, const surface::RaySettings& settings, const RayOutputs& out,
                       const base::Progress& progress) {
    const std::int64_t count = origins.count();
    RaySearch search(model, settings);
    const auto cast_all = [&](auto& way) {
        return cast_blocks(model.runtime(), origins, directions, settings.maximum_hits, out, progress.part(0.1, 1.0),
                           [&](const base::Work& work, const surface::Rays& rays, surface::RayHits& hits) {
                               way.cast(work, rays, hits);
                           });
    };
    if (desc.line_set == nullptr) {
        search.prepare(count, progress.part(0.0, 0.1));
        return cast_all(search);
    }
    const MeshSearch on_mesh(model, *desc.line_set, {settings, desc.refine == 1}, search, count,
                             progress.part(0.0, 0.1));
    return cast_all(on_mesh);
}

// Tests whether points are inside. Returns the number of points inside.
std::int64_t contains(const hrbfnpr_model& model, const Queries& queries, const base::OutView& out,
                      const base::Progress& progress) {
    geometry::VecArray points(model.runtime().memory);
    base::Array<std::uint8_t> block(model.runtime().memory);
    std::int64_t inside = 0;
    for_blocks(queries.count(), rays_at_once, progress,
               [&](std::int64_t begin, std::int64_t end, const base::Progress& part) {
                   queries.read(begin, end, points);
                   surface::contains({model.runtime(), part}, model.implicit(), points, block);
                   for (std::int64_t i = 0; i < end - begin; ++i) {
                       if (out) out.set(begin + i, 0, static_cast<double>(block[i]));
                       inside += block[i];
                   }
               });
    return inside;
}

void check_one_for_each(const Queries& origins, const Queries& directions) {
    if (directions.count() != origins.count())
        fail(Status::invalid_argument,
             "directions has %lld elements, but origins has %lld; give one direction for each origin",
             static_cast<long long>(directions.count()), static_cast<long long>(origins.count()));
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_cast_desc_init(hrbfnpr_cast_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_ray_hits_init(hrbfnpr_ray_hits* hits, uint32_t struct_size) {
    return api::init_struct(hits, struct_size);
}

hrbfnpr_status hrbfnpr_model_cast_rays(const hrbfnpr_model* model, const hrbfnpr_array* origins,
                                       const hrbfnpr_array* directions, const hrbfnpr_cast_desc* desc,
                                       hrbfnpr_ray_hits* hits, hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        const hrbfnpr_cast_desc given = api::read_optional_struct(desc, "cast_desc");
        const surface::RaySettings settings = api::checked(given, handle);
        const api::Queries from(handle.runtime(), origins, "origins");
        const api::Queries along(handle.runtime(), directions, "directions");
        api::check_one_for_each(from, along);
        const api::RayOutputs out(api::read_struct(hits, "ray_hits"), static_cast<std::uint32_t>(settings.maximum_hits),
                                  from.count());
        from.check_finite();
        along.check_finite();
        along.check_not_zero();
        const api::OperationUse use(operation);
        const std::int64_t hit_rays = api::cast_rays(handle, from, along, given, settings, out, use.progress());
        use.finish();
        api::write_number(hits, &hrbfnpr_ray_hits::hit_rays, hit_rays);
    });
}

hrbfnpr_status hrbfnpr_model_lipschitz(const hrbfnpr_model* model, double* lipschitz, hrbfnpr_operation* operation,
                                       hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::require_pointer(lipschitz, "lipschitz");
        const api::OperationUse use(operation);
        const double estimate = surface::lipschitz_estimate({handle.runtime(), use.progress()}, handle.implicit());
        use.finish();
        *lipschitz = estimate;
    });
}

hrbfnpr_status hrbfnpr_model_contains(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                      const hrbfnpr_array_out* inside, int64_t* inside_count,
                                      hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        const api::Queries queries(handle.runtime(), points, "points");
        const base::OutView out = api::out_view(inside, "inside", {1, api::uint8_only}, queries.count());
        queries.check_finite();
        const api::OperationUse use(operation);
        const std::int64_t found = api::contains(handle, queries, out, use.progress());
        use.finish();
        if (inside_count != nullptr) *inside_count = found;
    });
}

} // extern "C"

// SPDX-License-Identifier: MIT
// Surfaces: fitted as the command line does, or loaded.
#include "readers/shape.h"
#include "scene.h"

#include <algorithm>
#include <limits>

namespace viewer {

namespace {

constexpr std::int64_t most_samples = 4096; // a fit of more takes longer than a drawing is worth waiting for
constexpr std::int64_t on_mesh = 60000;     // places on a mesh that tell where its surface ends
constexpr double off_mesh = 0.009;          // diagonals from it that are none of it
constexpr std::int64_t probe_marks = 2000;
constexpr char saved_magic[] = "\x89HRB\r\n\x1a\n";

using Mesh = std::shared_ptr<hrbfnpr_mesh>;

void find_bounds(Surface& surface) {
    surface.low = surface.high = surface.places.front();
    for (const Vec& place : surface.places)
        for (std::size_t k = 0; k < 3; ++k) {
            surface.low[k] = std::min(surface.low[k], place[k]);
            surface.high[k] = std::max(surface.high[k], place[k]);
        }
}

void add_places(Surface& surface, const PointSet& marks) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    checked([&](auto* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        hrbfnpr_array view;
        checked([&](auto* error) {
            return hrbfnpr_point_set_view(marks.get(), layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, error);
        });
        const auto* const at = static_cast<const float*>(view.data);
        for (std::int64_t i = 0; i < view.count; ++i)
            surface.places.push_back(
                {info.origin[0] + at[3 * i], info.origin[1] + at[3 * i + 1], info.origin[2] + at[3 * i + 2]});
    }
    surface.area = info.spacing * info.spacing * static_cast<double>(info.marks);
}

// A few marks tell where it is and how large.
void look_at(Surface& surface, Work& work) {
    auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    auto desc = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    layer.budget = probe_marks;
    desc.layers = &layer;
    desc.layer_count = 1;
    hrbfnpr_point_set* marks = nullptr;
    work.stage("probe", [&](auto* operation, auto* error) {
        return hrbfnpr_point_set_generate(work.context.get(), surface.model.get(), &desc, operation, &marks, error);
    });
    add_places(surface, PointSet(marks, hrbfnpr_point_set_release));
    find_bounds(surface);
    work.stage("steepness", [&](auto* operation, auto* error) {
        return hrbfnpr_model_lipschitz(surface.model.get(), &surface.lipschitz, operation, error);
    });
    auto trim = defaults<hrbfnpr_trim_info>(hrbfnpr_trim_info_init);
    checked([&](auto* error) { return hrbfnpr_model_get_trim_info(surface.model.get(), &trim, error); });
    surface.is_trimmed = trim.is_trimmed != 0;
}

Model keep(hrbfnpr_model* model) { return Model(model, hrbfnpr_model_release); }

// Where the samples end the surface does; one that cannot be told goes on.
Model trimmed(const Model& model, const hrbfnpr_trim_desc& desc, Work& work) {
    hrbfnpr_model* ended = nullptr;
    try {
        work.stage("end", [&](auto* operation, auto* error) {
            return hrbfnpr_model_trim(model.get(), &desc, operation, &ended, error);
        });
    } catch (const Failure& failure) {
        if (failure.status != HRBFNPR_STATUS_NOT_CONVERGED) throw;
        work.notes.push_back(std::string("where the surface ends was not found: ") + failure.what());
        return model;
    }
    return keep(ended);
}

Mesh mesh_of(const Shape& shape, Work& work) {
    auto desc = defaults<hrbfnpr_mesh_desc>(hrbfnpr_mesh_desc_init);
    desc.vertices = view_of(shape.points);
    desc.triangles = {shape.triangles.data(), static_cast<std::int64_t>(shape.triangles.size()), 0,
                      HRBFNPR_SCALAR_INT32, 3};
    hrbfnpr_mesh* mesh = nullptr;
    work.stage("mesh", [&](auto* operation, auto* error) {
        return hrbfnpr_mesh_create(work.context.get(), &desc, operation, &mesh, error);
    });
    return Mesh(mesh, hrbfnpr_mesh_release);
}

Model fit_mesh(const Shape& shape, const Settings& settings, Work& work) {
    const Mesh mesh = mesh_of(shape, work);
    auto mesh_info = defaults<hrbfnpr_mesh_info>(hrbfnpr_mesh_info_init);
    checked([&](auto* error) { return hrbfnpr_mesh_get_info(mesh.get(), &mesh_info, error); });
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init); // what a fit to a mesh takes of it
    fit.kernel = settings.fit.kernel;
    fit.kernel_radius = settings.fit.kernel_radius;
    fit.polynomial_degree = settings.fit.polynomial_degree;
    fit.regularization = settings.fit.regularization;
    fit.solver = settings.fit.solver;
    fit.trim = HRBFNPR_TRIM_NEVER;
    auto info = defaults<hrbfnpr_mesh_fit_info>(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* made = nullptr;
    work.stage("fit", [&](auto* operation, auto* error) {
        return hrbfnpr_model_fit_mesh(mesh.get(), &settings.mesh_fit, &fit, &info, operation, &made, error);
    });
    Model model = keep(made);
    if (!info.reached) work.notes.push_back("the surface is not within its tolerance of the mesh everywhere");
    if (settings.fit.trim == HRBFNPR_TRIM_NEVER || (info.sheets > 1 && mesh_info.closed)) return model;
    std::vector<Vec> places(on_mesh);
    auto sample = defaults<hrbfnpr_sample_desc>(hrbfnpr_sample_desc_init);
    sample.candidates = on_mesh;
    const hrbfnpr_array_out room = room_in(places);
    work.stage("end", [&](auto* operation, auto* error) {
        return hrbfnpr_mesh_sample(mesh.get(), &sample, &room, nullptr, operation, error);
    });
    auto trim = defaults<hrbfnpr_trim_desc>(hrbfnpr_trim_desc_init);
    trim.hole = trim.closest = off_mesh;
    trim.points = view_of(places);
    return trimmed(model, trim, work);
}

// At most so many points, each as far as can be from those before it.
void choose(std::vector<Vec>& points, std::vector<Vec>& normals, Work& work) {
    std::vector<std::int64_t> chosen(static_cast<std::size_t>(most_samples));
    const hrbfnpr_array all = view_of(points);
    const hrbfnpr_array_out room = {chosen.data(), most_samples, 0, HRBFNPR_SCALAR_INT64, 1};
    work.stage("sample", [&](auto* operation, auto* error) {
        return hrbfnpr_farthest_points(work.context.get(), &all, &room, nullptr, operation, error);
    });
    const auto pick = [&](std::vector<Vec>& from) {
        std::vector<Vec> some;
        for (const std::int64_t i : chosen) some.push_back(from[static_cast<std::size_t>(i)]);
        from = std::move(some);
    };
    work.notes.push_back(std::to_string(points.size()) + " points, of which " + std::to_string(most_samples) +
                         " are used");
    pick(points);
    if (!normals.empty()) pick(normals);
}

// Normals of unit length; points that have none are left out.
void make_unit(std::vector<Vec>& points, std::vector<Vec>& normals, Work& work) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double size = length(normals[i]);
        if (!std::isfinite(size) || size == 0) continue;
        points[count] = points[i];
        for (std::size_t k = 0; k < 3; ++k) normals[count][k] = normals[i][k] / size;
        ++count;
    }
    if (count < normals.size())
        work.notes.push_back(std::to_string(normals.size() - count) + " points without a usable normal are left out");
    if (!normals.empty()) points.resize(count), normals.resize(count);
    if (points.empty()) throw Failure("no point has a normal that is not zero");
}

Model fitted(const hrbfnpr_fit_desc& fit, Work& work) {
    hrbfnpr_model* made = nullptr;
    work.stage("fit", [&](auto* operation, auto* error) {
        return hrbfnpr_model_fit(work.context.get(), &fit, operation, &made, error);
    });
    return keep(made);
}

// Whether some of the normals that a fit was given point the other way than their neighbours', or all inward.
bool looks_wrong(const Model& model) {
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    checked([&](auto* error) { return hrbfnpr_model_get_info(model.get(), &info, error); });
    return info.normals_inward != 0 || info.flipped_found > 0;
}

// Most normals are right, which a fit shows sooner than looking for others; nullptr if they are not.
Model fitted_as_given(hrbfnpr_fit_desc fit, Work& work) {
    fit.normal_mode = HRBFNPR_NORMALS_GIVEN;
    try {
        Model model = fitted(fit, work);
        return looks_wrong(model) ? nullptr : model;
    } catch (const Failure& failure) { // such as samples that contradict each other
        if (failure.status == HRBFNPR_STATUS_CANCELLED) throw;
        return nullptr;
    }
}

Model fit_points(const Shape& shape, const Settings& settings, Work& work) {
    std::vector<Vec> points = shape.points, normals = shape.normals;
    make_unit(points, normals, work);
    const bool chooses = settings.fit.tolerance > 0 || settings.fit.maximum_centres > 0; // the fit itself does
    if (static_cast<std::int64_t>(points.size()) > most_samples && !chooses) choose(points, normals, work);
    hrbfnpr_fit_desc fit = settings.fit;
    fit.points = view_of(points);
    fit.normals = view_of(normals);
    if (normals.empty()) fit.normals = {}, fit.normal_mode = HRBFNPR_NORMALS_NONE;
    fit.trim = HRBFNPR_TRIM_NEVER;
    Model model;
    if (fit.normal_mode == HRBFNPR_NORMALS_AUTO) model = fitted_as_given(fit, work);
    if (model == nullptr) model = fitted(fit, work);
    if (normals.empty()) work.notes.push_back("the points have no normals: they are made");
    if (settings.fit.trim == HRBFNPR_TRIM_NEVER) return model;
    auto trim = defaults<hrbfnpr_trim_desc>(hrbfnpr_trim_desc_init);
    trim.points = view_of(shape.points);
    return trimmed(model, trim, work);
}

// A saved model, or saved marks.
Surface saved_surface(const std::string& path, const std::string& data, Work& work) {
    Surface surface;
    const auto size = static_cast<std::int64_t>(data.size());
    hrbfnpr_model* model = nullptr;
    Error error;
    work.own_stage("load", [&] {
        const auto status = hrbfnpr_model_load_memory(work.context.get(), data.data(), size, &model, error);
        if (status == HRBFNPR_STATUS_OK) return;
        hrbfnpr_point_set* marks = nullptr;
        Error other;
        if (hrbfnpr_point_set_load_memory(work.context.get(), data.data(), size, &marks, other) == HRBFNPR_STATUS_OK)
            surface.marks = PointSet(marks, hrbfnpr_point_set_release);
        else
            throw Failure(path + ": " + static_cast<hrbfnpr_error*>(error)->message);
    });
    if (model != nullptr) {
        surface.model = keep(model);
        look_at(surface, work);
        return surface;
    }
    add_places(surface, surface.marks);
    find_bounds(surface);
    return surface;
}

// Up is z where that is the shortest side of what stands on z = 0, as of terrains; else y, as of most meshes.
Vec up_of(const Surface& surface) {
    const Vec side = surface.high - surface.low;
    return side[2] < 0.45 * std::min(side[0], side[1]) ? Vec{0, 0, 1} : Vec{0, 1, 0};
}

} // namespace

Surface surface_of_samples(const Shape& shape, const Settings& settings, Work& work) {
    Surface surface;
    Settings with = settings;
    with.fit.normal_mode = HRBFNPR_NORMALS_GIVEN; // a formula's are right
    surface.model = fit_points(shape, with, work);
    look_at(surface, work);
    return surface;
}

Surface surface_of_model(const Model& model, Work& work) {
    Surface surface;
    surface.model = model;
    look_at(surface, work);
    return surface;
}

Surface surface_of_file(const std::string& path, const Settings& settings, Work& work) {
    Surface surface;
    std::string data;
    work.own_stage("read", [&] { data = read_file(path); });
    if (data.compare(0, sizeof saved_magic - 1, saved_magic) == 0) {
        surface = saved_surface(path, data, work);
    } else {
        Shape shape;
        work.own_stage("read", [&] { shape = read_shape(path); });
        try {
            surface.model =
                shape.triangles.empty() ? fit_points(shape, settings, work) : fit_mesh(shape, settings, work);
        } catch (const Failure& failure) {
            if (failure.status == HRBFNPR_STATUS_CANCELLED) throw;
            throw Failure(path + ": " + failure.what(), failure.status);
        }
        look_at(surface, work);
    }
    surface.name = path.substr(path.find_last_of('/') + 1);
    surface.up = up_of(surface);
    surface.timings = work.timings;
    surface.notes = work.notes;
    return surface;
}

} // namespace viewer

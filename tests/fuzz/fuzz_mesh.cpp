// SPDX-License-Identifier: MIT
// Makes meshes of any triangles, samples them, compares models with them, and fits models to them.
#include "arrays.h"
#include "fields.h"
#include "limits.h"
#include "samples.h"
#include "scenes.h"

#include <numeric>

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_OUT_OF_MEMORY,      HRBFNPR_STATUS_SINGULAR_SYSTEM,
    HRBFNPR_STATUS_NOT_CONVERGED,    HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_CANCELLED};

// A grid of triangles that closes to a torus, closes to a tube or stays open; a few corners of faces then point
// anywhere.
struct Triangles {
    std::vector<double> places;
    std::vector<std::int64_t> corners;

    explicit Triangles(Input& input) {
        const std::int64_t rows = 1 + static_cast<std::int64_t>(input.below(12));
        const std::int64_t columns = 1 + static_cast<std::int64_t>(input.below(12));
        const std::size_t form = input.below(6);
        const double scale = input.once_in(6) ? odd_float(1.0, 1e30, input) : 1.0;
        for (std::int64_t i = 0; i < rows * columns; ++i)
            add_place(i / columns, i % columns, rows, columns, form, scale);
        for (std::int64_t i = 0; i < rows * columns; ++i) add_faces(i / columns, i % columns, rows, columns, form);
        for (std::size_t odd = input.once_in(2) ? input.below(6) : 0; odd > 0; --odd) make_odd(input);
    }

private:
    void add_place(std::int64_t row, std::int64_t column, std::int64_t rows, std::int64_t columns, std::size_t form,
                   double scale) {
        const double a = 6.283185307 * static_cast<double>(row) / static_cast<double>(rows);
        const double b = 6.283185307 * static_cast<double>(column) / static_cast<double>(columns);
        const double r = form % 2 == 0 ? 1.0 + 0.4 * std::cos(b) : std::sin(0.5 * b);
        const double z = form % 2 == 0 ? 0.4 * std::sin(b) : std::cos(0.5 * b);
        if (form < 4)
            places.insert(places.end(), {scale * r * std::cos(a), scale * r * std::sin(a), scale * z});
        else
            places.insert(places.end(), {scale * a, scale * b, form == 4 ? 0.0 : scale * 0.3 * std::sin(a)});
    }
    void add_faces(std::int64_t row, std::int64_t column, std::int64_t rows, std::int64_t columns, std::size_t form) {
        if (form != 0 && (column + 1 == columns || (form > 3 && row + 1 == rows))) return;
        const std::int64_t up = (row + 1) % rows;
        const std::int64_t right = (column + 1) % columns;
        const std::int64_t a = row * columns + column;
        const std::int64_t b = up * columns + column;
        const std::int64_t c = up * columns + right;
        const std::int64_t d = row * columns + right;
        corners.insert(corners.end(), {a, b, c, a, c, d});
    }
    void make_odd(Input& input) {
        if (corners.empty() || places.empty()) return;
        std::int64_t& corner = corners[input.below(corners.size())];
        double& place = places[input.below(places.size())];
        switch (input.below(6)) {
        case 0: corner = static_cast<std::int64_t>(input.below(places.size() / 3)); break;
        case 1: corner = odd_integer(static_cast<std::uint32_t>(corner), 0U, input); break;
        case 2: std::swap(corners[0], corners[1]); break;
        case 3: corners.insert(corners.end(), {corner, corners[0], corners.back()}); break;
        case 4: place = places[input.below(places.size())]; break;
        default: place = odd_float(place, 0.0, input);
        }
    }
};

void sample(Context& context, const hrbfnpr_mesh* mesh, Input& input) {
    hrbfnpr_sample_desc desc;
    hrbfnpr_sample_desc_init(&desc, sizeof desc);
    change_fields(input, "hrbfnpr_sample_desc", &desc);
    const std::int64_t count = 1 + static_cast<std::int64_t>(input.below(60));
    const std::uint32_t scalar = input.once_in(4) ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_FLOAT64;
    Room points(count, 3, scalar);
    Room normals(count, 3, scalar);
    const Operation operation(context, input);
    Call call("mesh_sample");
    const hrbfnpr_status status =
        hrbfnpr_mesh_sample(mesh, &desc, &points.out, &normals.out, operation.handle, call.error());
    operation.check(status);
    if (call.expect(status, failures))
        require(points.is_finite() && normals.is_finite(), "samples of a mesh are finite");
    else
        require(points.is_untouched() && normals.is_untouched(), "a failed call leaves samples untouched");
}

void find_edges(Context& context, const hrbfnpr_mesh* mesh, Input& input) {
    hrbfnpr_array faces{};
    if (hrbfnpr_mesh_view(mesh, HRBFNPR_MESH_ATTRIBUTE_COMPONENT, &faces, nullptr) != HRBFNPR_STATUS_OK) return;
    hrbfnpr_mesh_edges_desc desc;
    hrbfnpr_mesh_edges_desc_init(&desc, sizeof desc);
    change_fields(input, "hrbfnpr_mesh_edges_desc", &desc);
    std::vector<std::int32_t> patch(static_cast<std::size_t>(faces.count), -1);
    const hrbfnpr_array_out patches{patch.data(), faces.count, 0, HRBFNPR_SCALAR_INT32, 1};
    const Operation operation(context, input);
    Call call("mesh_edges");
    const hrbfnpr_status status =
        hrbfnpr_mesh_edges(mesh, &desc, &patches, nullptr, nullptr, operation.handle, call.error());
    operation.check(status);
    if (call.expect(status, failures))
        for (const std::int32_t one : patch) require(one >= 0 && one < faces.count, "each face has a patch");
    else
        require(patch[0] == -1, "a failed call leaves patches untouched");
}

void compare(Context& context, const hrbfnpr_mesh* mesh, Input& input) {
    const hrbfnpr_model* const model = scene_model(input.below(model_count));
    hrbfnpr_compare_desc desc;
    hrbfnpr_compare_desc_init(&desc, sizeof desc);
    desc.points = 100 + static_cast<std::int64_t>(input.below(200));
    desc.cell_size = input.between(0.1, 1.0);
    change_fields(input, "hrbfnpr_compare_desc", &desc);
    hrbfnpr_comparison result;
    hrbfnpr_comparison_init(&result, sizeof result);
    const Operation operation(context, input);
    Call call("model_compare_mesh");
    const hrbfnpr_status status =
        hrbfnpr_model_compare_mesh(model, mesh, &desc, &result, operation.handle, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) return;
    require(std::isfinite(result.mesh_max) || result.surface_points == 0, "distances from a surface are finite");
    require(result.mesh_points > 0 && result.diagonal > 0.0, "a comparison counts places");
}

void fit(Context& context, const hrbfnpr_mesh* mesh, Input& input) {
    hrbfnpr_mesh_fit_desc desc;
    hrbfnpr_mesh_fit_desc_init(&desc, sizeof desc);
    desc.maximum_centres = 16 + static_cast<std::int64_t>(input.below(60));
    desc.candidates = 1000;
    desc.tolerance = 0.05;
    change_fields(input, "hrbfnpr_mesh_fit_desc", &desc);
    hrbfnpr_fit_desc solver;
    hrbfnpr_fit_desc_init(&solver, sizeof solver);
    change_fields(input, "hrbfnpr_fit_desc", &solver);
    hrbfnpr_mesh_fit_info info;
    hrbfnpr_mesh_fit_info_init(&info, sizeof info);
    hrbfnpr_model* model = nullptr;
    const Operation operation(context, input);
    Call call("model_fit_mesh");
    const hrbfnpr_status status = hrbfnpr_model_fit_mesh(mesh, &desc, input.once_in(2) ? &solver : nullptr, &info,
                                                         operation.handle, &model, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (model != nullptr), "a handle comes with success only");
    if (model == nullptr) return;
    require(info.centres >= 1 && info.off_surface_centres <= info.centres, "centres are counted");
    require(info.mesh_share >= 0.0 && info.mesh_share <= 1.0, "a share is from 0 to 1");
    hrbfnpr_model_release(model);
}

// Checks that the views agree with the counts.
void require_sound_mesh(const hrbfnpr_mesh* mesh) {
    hrbfnpr_mesh_info info;
    hrbfnpr_mesh_info_init(&info, sizeof info);
    Call ask("mesh_get_info");
    ask.expect(hrbfnpr_mesh_get_info(mesh, &info, ask.error()));
    require(info.faces >= 1 && info.faces <= info.given_faces && info.vertices <= 3 * info.faces, "faces are kept");
    require(std::isfinite(info.area) && info.area >= 0.0, "a mesh has an area");
    require(info.closed == 0 || std::isfinite(info.volume), "a closed mesh has a volume");
    const auto view = [&](std::uint32_t attribute) {
        Call call("mesh_view");
        hrbfnpr_array array;
        call.expect(hrbfnpr_mesh_view(mesh, attribute, &array, call.error()));
        return array;
    };
    const hrbfnpr_array triangles = view(HRBFNPR_MESH_ATTRIBUTE_TRIANGLE);
    require(triangles.count == info.faces, "faces can be seen");
    const auto* const corner = static_cast<const std::int32_t*>(triangles.data);
    for (std::int64_t i = 0; i < 3 * triangles.count; ++i)
        require(corner[i] >= 0 && corner[i] < info.vertices, "a corner is a vertex");
    const auto require_finite = [&](std::uint32_t attribute, std::int64_t count) {
        const hrbfnpr_array array = view(attribute);
        require(array.count == count, "what is kept can be seen");
        const auto* const number = static_cast<const double*>(array.data);
        for (std::int64_t i = 0; i < array.count * array.components; ++i)
            require(std::isfinite(number[i]), "what is kept is finite");
    };
    require_finite(HRBFNPR_MESH_ATTRIBUTE_VERTEX, info.vertices);
    require_finite(HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL, info.faces);
}

void farthest(Context& context, const Triangles& given, Input& input) {
    const Array points(given.places, 3, input);
    static constexpr std::uint32_t scalars[] = {HRBFNPR_SCALAR_INT64, HRBFNPR_SCALAR_INT32, HRBFNPR_SCALAR_UINT32};
    const std::int64_t count = 1 + static_cast<std::int64_t>(input.below(80));
    Room indices(count, 1, input.one_of(scalars));
    Room distance(count, 1, HRBFNPR_SCALAR_FLOAT64);
    const Operation operation(context, input);
    Call call("farthest_points");
    const hrbfnpr_status status = hrbfnpr_farthest_points(context.handle, &points.view, &indices.out, &distance.out,
                                                          operation.handle, call.error());
    operation.check(status);
    if (call.expect(status, failures)) {
        for (const double one : distance.numbers<double>()) require(one >= 0.0, "a distance is none below 0");
    } else {
        require(indices.is_untouched() && distance.is_untouched(), "a failed call leaves an order untouched");
    }
}

hrbfnpr_mesh* make(Context& context, const Triangles& given, Input& input) {
    const Array vertices(given.places, 3, input);
    hrbfnpr_mesh_desc desc;
    hrbfnpr_mesh_desc_init(&desc, sizeof desc);
    desc.vertices = vertices.view;
    desc.triangles = {given.corners.data(), static_cast<std::int64_t>(given.corners.size() / 3), 0,
                      HRBFNPR_SCALAR_INT64, 3};
    desc.parts = static_cast<std::uint32_t>(input.below(3));
    change_fields(input, "hrbfnpr_mesh_desc", &desc);
    hrbfnpr_mesh* mesh = nullptr;
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("mesh_create");
    const hrbfnpr_status status = hrbfnpr_mesh_create(context.handle, &desc, operation.handle, &mesh, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (mesh != nullptr), "a handle comes with success only");
    return mesh;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    Context context;
    const Triangles given(input);
    if (input.once_in(8)) farthest(context, given, input);
    hrbfnpr_mesh* const mesh = make(context, given, input);
    if (mesh == nullptr) return 0;
    require_sound_mesh(mesh);
    sample(context, mesh, input);
    if (input.once_in(3)) compare(context, mesh, input);
    if (input.once_in(4)) fit(context, mesh, input);
    find_edges(context, mesh, input); // last, so that committed inputs keep their meaning
    hrbfnpr_mesh_release(mesh);
    return 0;
}

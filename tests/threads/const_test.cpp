// SPDX-License-Identifier: MIT
// Calls that take a const handle run at the same time on several threads with the same handle, and give the same
// results as each call alone. The names come from the header: a name without a call here fails the test.
#include "const_handles.h"
#include "const_names.h"

#include <gtest/gtest.h>

#include <barrier>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace host_test::const_test {
namespace {

constexpr int threads = 4;
constexpr std::int64_t point_count = 200;

// The results of a call, as consecutive bytes.
class Result {
public:
    template <class T>
    void add(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
        bytes_.insert(bytes_.end(), first, first + sizeof value);
    }
    template <class T>
    void add(const std::vector<T>& values) {
        for (const T& value : values) add(value);
    }
    bool operator==(const Result&) const = default;

private:
    Bytes bytes_;
};

template <class T>
hrbfnpr_array_out out(std::vector<T>& numbers, std::uint32_t components = 1) {
    const std::uint32_t scalar = sizeof(T) == 8             ? HRBFNPR_SCALAR_FLOAT64
                                 : sizeof(T) == 1           ? HRBFNPR_SCALAR_UINT8
                                 : std::is_same_v<T, float> ? HRBFNPR_SCALAR_FLOAT32
                                                            : HRBFNPR_SCALAR_UINT32;
    return {numbers.data(), static_cast<std::int64_t>(numbers.size() / components), 0, scalar, components};
}

std::int32_t append(void* user, const void* data, std::uint64_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& all = *static_cast<Bytes*>(user);
    all.insert(all.end(), bytes, bytes + size);
    return 0;
}

// The handles that the calls share, and the calls by name.
struct Shared {
    Context context = make_context(2);
    Model model = fit(context, 60);
    PointSet marks = generate(context, model, three_layers(200));
    LineSet lines = line_set_of(context, model);
    hrbfnpr::test::Occluders occluders = occluders_of(context, marks, lines);
    hrbfnpr::test::Shading shading = shading_of(context, occluders, marks, lines);
    hrbfnpr::test::Field field = field_of(context);
    PointSet painted = marks_with_field(context, marks, field);
    hrbfnpr::test::Mesh mesh = mesh_of(context);
    Drawing drawing = drawing_of(context, marks);
    hrbfnpr::test::Picture picture = picture_of(context, model);
    Drawing picture_drawing = drawing_of(picture.get());
    hrbfnpr::test::Settings settings = settings_of(context);
    hrbfnpr_operation* operation = nullptr;
    std::vector<double> point;
    hrbfnpr_array points{};

    Shared() {
        scenes::Check check;
        check(hrbfnpr_operation_create(context.get(), &operation, check.error()));
        for (int i = 0; i < 3 * point_count; ++i) point.push_back(0.0011 * ((i * 37) % 2500) - 1.3);
        points = {point.data(), point_count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;
    ~Shared() { hrbfnpr_operation_release(operation); }
};

using Call = std::function<void(const Shared& s, hrbfnpr_error* error, Result& result, hrbfnpr_status& status)>;

void add(std::map<std::string, Call>& calls, const char* name, Call call) { calls.emplace(name, std::move(call)); }

#define CALL(name) add(calls, #name, [](const Shared& s, hrbfnpr_error* error, Result& result, hrbfnpr_status& status)
#define RETAIN_AND_RELEASE(what, owner)                                                                                \
    for (const char* const name : {"hrbfnpr_" #what "_retain", "hrbfnpr_" #what "_release"})                           \
    add(calls, name, [](const Shared& s, hrbfnpr_error*, Result&, hrbfnpr_status&) {                                   \
        hrbfnpr_##what##_retain((owner).get());                                                                        \
        hrbfnpr_##what##_release((owner).get());                                                                       \
    })
#define INFO(name, type, owner)                                                                                        \
    CALL(name) {                                                                                                       \
        auto info = made(type##_init);                                                                                 \
        status = name((owner).get(), &info, error);                                                                    \
        result.add(info);                                                                                              \
    })
#define UNUSED() static_cast<void>(s), static_cast<void>(error), static_cast<void>(result), static_cast<void>(status)

void add_meshes(std::map<std::string, Call>& calls) {
    RETAIN_AND_RELEASE(mesh, s.mesh);
    INFO(hrbfnpr_mesh_get_info, hrbfnpr_mesh_info, s.mesh);
    CALL(hrbfnpr_mesh_view) {
        hrbfnpr_array view{};
        status = hrbfnpr_mesh_view(s.mesh.get(), HRBFNPR_MESH_ATTRIBUTE_TRIANGLE, &view, error);
        result.add(view.count);
    });
    CALL(hrbfnpr_mesh_sample) {
        std::vector<double> place(3 * point_count);
        const auto places = out(place, 3);
        status = hrbfnpr_mesh_sample(s.mesh.get(), nullptr, &places, nullptr, nullptr, error);
        result.add(place);
    });
    CALL(hrbfnpr_mesh_edges) {
        auto info = made(hrbfnpr_mesh_edges_info_init);
        status = hrbfnpr_mesh_edges(s.mesh.get(), nullptr, nullptr, nullptr, &info, nullptr, error);
        result.add(info.edges);
        result.add(info.length);
    });
    CALL(hrbfnpr_model_compare_mesh) {
        auto desc = made(hrbfnpr_compare_desc_init);
        desc.points = point_count;
        auto found = made(hrbfnpr_comparison_init);
        status = hrbfnpr_model_compare_mesh(s.model.get(), s.mesh.get(), &desc, &found, nullptr, error);
        result.add(found.surface_max);
        result.add(found.mesh_max);
    });
    CALL(hrbfnpr_model_fit_mesh) {
        auto info = made(hrbfnpr_mesh_fit_info_init);
        hrbfnpr_model* fitted = nullptr;
        status = hrbfnpr_model_fit_mesh(s.mesh.get(), nullptr, nullptr, &info, nullptr, &fitted, error);
        const Model owned(fitted);
        result.add(info.centres);
        result.add(info.mesh_max);
    });
}

void add_models(std::map<std::string, Call>& calls) {
    RETAIN_AND_RELEASE(model, s.model);
    CALL(hrbfnpr_model_get_info) {
        auto info = made(hrbfnpr_model_info_init);
        status = hrbfnpr_model_get_info(s.model.get(), &info, error);
        result.add(info.centres);
        result.add(info.bounds_max);
    });
    CALL(hrbfnpr_model_view) {
        hrbfnpr_array view{};
        status = hrbfnpr_model_view(s.model.get(), HRBFNPR_MODEL_ATTRIBUTE_NORMAL, &view, error);
        result.add(view.data);
        result.add(view.count);
    });
    CALL(hrbfnpr_model_evaluate) {
        std::vector<double> value(point_count), gradient(3 * point_count);
        const auto values = out(value), gradients = out(gradient, 3);
        status = hrbfnpr_model_evaluate(s.model.get(), &s.points, &values, &gradients, nullptr, nullptr, error);
        result.add(value);
        result.add(gradient);
    });
    CALL(hrbfnpr_model_project) {
        std::vector<double> position(3 * point_count);
        auto projection = made(hrbfnpr_projection_init);
        projection.position = out(position, 3);
        status = hrbfnpr_model_project(s.model.get(), &s.points, nullptr, &projection, nullptr, error);
        result.add(position);
        result.add(projection.converged);
    });
    CALL(hrbfnpr_model_curvature) {
        std::vector<double> k1(point_count);
        auto curvature = made(hrbfnpr_curvature_init);
        curvature.k1 = out(k1);
        status = hrbfnpr_model_curvature(s.model.get(), &s.points, &curvature, nullptr, error);
        result.add(k1);
    });
    CALL(hrbfnpr_model_cast_rays) {
        std::vector<double> t(point_count);
        const std::vector<double> along(3 * point_count, 0.7);
        const hrbfnpr_array directions{along.data(), point_count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        auto hits = made(hrbfnpr_ray_hits_init);
        hits.t = out(t);
        status = hrbfnpr_model_cast_rays(s.model.get(), &s.points, &directions, nullptr, &hits, nullptr, error);
        result.add(t);
        result.add(hits.hit_rays);
        auto on_mesh = made(hrbfnpr_cast_desc_init);
        on_mesh.line_set = s.lines.get();
        if (status == HRBFNPR_STATUS_OK)
            status = hrbfnpr_model_cast_rays(s.model.get(), &s.points, &directions, &on_mesh, &hits, nullptr, error);
        result.add(t);
        result.add(hits.hit_rays);
    });
    CALL(hrbfnpr_model_lipschitz) {
        double bound = 0.0;
        status = hrbfnpr_model_lipschitz(s.model.get(), &bound, nullptr, error);
        result.add(bound);
    });
    CALL(hrbfnpr_model_contains) {
        std::int64_t inside = 0;
        status = hrbfnpr_model_contains(s.model.get(), &s.points, nullptr, &inside, nullptr, error);
        result.add(inside);
    });
    CALL(hrbfnpr_model_save) {
        Bytes file;
        status = hrbfnpr_model_save(s.model.get(), append, &file, error);
        result.add(file);
    });
    CALL(hrbfnpr_model_save_memory) {
        std::int64_t size = 0;
        Bytes file(1 << 20);
        status = hrbfnpr_model_save_memory(s.model.get(), file.data(), 1 << 20, &size, error);
        result.add(file);
    });
}

void add_point_sets(std::map<std::string, Call>& calls) {
    CALL(hrbfnpr_point_set_generate) {
        Generation desc = three_layers(60);
        hrbfnpr_point_set* set = nullptr;
        status = hrbfnpr_point_set_generate(s.context.get(), s.model.get(), desc.get(), nullptr, &set, error);
        const PointSet owner(set);
        hrbfnpr_array view{};
        hrbfnpr_point_set_view(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, nullptr);
        const auto* first = static_cast<const std::uint8_t*>(view.data);
        result.add(Bytes(first, first + 12 * view.count));
    });
    CALL(hrbfnpr_point_set_generate_still) {
        const auto item = made(hrbfnpr_item_init);
        auto camera = made(hrbfnpr_camera_init);
        status = hrbfnpr_picture_get_camera(s.picture.get(), &camera, error);
        Generation desc = three_layers(60);
        hrbfnpr_point_set* set = nullptr;
        status = hrbfnpr_point_set_generate_still(s.context.get(), s.model.get(), desc.get(), &item, &camera, nullptr,
                                                  &set, error);
        const PointSet owner(set);
        hrbfnpr_array view{};
        hrbfnpr_point_set_view(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, nullptr);
        const auto* first = static_cast<const std::uint8_t*>(view.data);
        result.add(Bytes(first, first + 12 * view.count));
    });
    CALL(hrbfnpr_point_set_step_patches) {
        std::vector<double> corner(60);
        const auto corners = out(corner, 12);
        status =
            hrbfnpr_point_set_step_patches(s.context.get(), s.model.get(), nullptr, &corners, nullptr, nullptr, error);
        result.add(corner);
    });
    CALL(hrbfnpr_model_trim) {
        hrbfnpr_model* trimmed = nullptr;
        status = hrbfnpr_model_trim(s.model.get(), nullptr, nullptr, &trimmed, error);
        const Model owned(trimmed);
        auto info = made(hrbfnpr_trim_info_init);
        if (trimmed != nullptr) static_cast<void>(hrbfnpr_model_get_trim_info(trimmed, &info, error));
        result.add(info);
    });
    INFO(hrbfnpr_model_get_trim_info, hrbfnpr_trim_info, s.model);
    INFO(hrbfnpr_model_get_csg_info, hrbfnpr_csg_info, s.model);
    CALL(hrbfnpr_line_set_create) {
        hrbfnpr_line_set* lines = nullptr;
        status = hrbfnpr_line_set_create(s.context.get(), s.model.get(), nullptr, nullptr, &lines, error);
        const LineSet owned(lines);
        auto info = made(hrbfnpr_line_set_info_init);
        if (lines != nullptr) static_cast<void>(hrbfnpr_line_set_get_info(lines, &info, error));
        result.add(info.triangles);
    });
    RETAIN_AND_RELEASE(line_set, s.lines);
    CALL(hrbfnpr_line_set_get_info) {
        auto info = made(hrbfnpr_line_set_info_init);
        status = hrbfnpr_line_set_get_info(s.lines.get(), &info, error);
        info.bytes = 0; // This grows when the first ray on the set makes a tree, which another thread may do meanwhile.
        result.add(info);
    });
    RETAIN_AND_RELEASE(occluders, s.occluders);
    RETAIN_AND_RELEASE(shading, s.shading);
    CALL(hrbfnpr_shading_create) {
        LitItem lit(s.marks, s.lines);
        hrbfnpr_shading* shading = nullptr;
        status = hrbfnpr_shading_create(s.context.get(), s.occluders.get(), &lit.item, nullptr, nullptr, nullptr,
                                        &shading, error);
        const hrbfnpr::test::Shading owned(shading);
        lit.item.shading = shading;
        hrbfnpr_renderer* raw = nullptr;
        hrbfnpr_renderer_create(s.context.get(), &raw, nullptr);
        const Renderer renderer(raw);
        auto camera = made(hrbfnpr_camera_init);
        hrbfnpr_picture_get_camera(s.picture.get(), &camera, nullptr);
        hrbfnpr_drawing* drawing = nullptr;
        if (shading != nullptr) status = hrbfnpr_renderer_draw(raw, &lit.item, 1, 0, &camera, &drawing, error);
        const Drawing owned_drawing(drawing);
        auto info = made(hrbfnpr_drawing_info_init);
        hrbfnpr_drawing_get_info(drawing, &info, nullptr);
        result.add(info.shown);
    });
    CALL(hrbfnpr_shading_view) {
        hrbfnpr_array view{};
        status = hrbfnpr_shading_view(s.shading.get(), 0, 0, &view, error);
        result.add(view.data);
    });
    RETAIN_AND_RELEASE(point_set, s.marks);
    INFO(hrbfnpr_point_set_get_info, hrbfnpr_point_set_info, s.marks);
    CALL(hrbfnpr_point_set_get_layer_info) {
        auto info = made(hrbfnpr_layer_info_init);
        status = hrbfnpr_point_set_get_layer_info(s.marks.get(), 1, &info, error);
        result.add(info);
    });
    INFO(hrbfnpr_point_set_get_seed_placement, hrbfnpr_placement_info, s.marks);
    CALL(hrbfnpr_point_set_get_placement) {
        auto info = made(hrbfnpr_placement_info_init);
        status = hrbfnpr_point_set_get_placement(s.marks.get(), 1, 0, &info, error);
        result.add(info);
    });
    CALL(hrbfnpr_point_set_view) {
        hrbfnpr_array view{};
        status = hrbfnpr_point_set_view(s.marks.get(), 1, HRBFNPR_MARK_ATTRIBUTE_RANK, &view, error);
        result.add(view.data);
    });
    CALL(hrbfnpr_point_set_save) {
        Bytes file;
        status = hrbfnpr_point_set_save(s.marks.get(), append, &file, error);
        result.add(file);
    });
    CALL(hrbfnpr_point_set_save_memory) {
        std::int64_t size = 0;
        Bytes file(1 << 20);
        status = hrbfnpr_point_set_save_memory(s.marks.get(), file.data(), 1 << 20, &size, error);
        result.add(file);
    });
}

void add_fields(std::map<std::string, Call>& calls) {
    RETAIN_AND_RELEASE(field, s.field);
    CALL(hrbfnpr_field_evaluate) {
        std::vector<double> value(point_count);
        const auto values = out(value);
        status = hrbfnpr_field_evaluate(s.field.get(), &s.points, nullptr, &values, nullptr, nullptr, error);
        result.add(value);
    });
    CALL(hrbfnpr_point_set_with_fields) {
        const PointSet set(make_marks_with_field(s.context, s.marks, s.field, error, status));
        hrbfnpr_array values{};
        hrbfnpr_point_set_view_field(set.get(), 0, "a", &values, nullptr, nullptr);
        const auto* const first = static_cast<const float*>(values.data);
        result.add(std::vector<float>(first, first + values.count));
    });
    CALL(hrbfnpr_point_set_get_field) {
        const char* name = nullptr;
        status = hrbfnpr_point_set_get_field(s.painted.get(), 0, &name, nullptr, error);
        result.add(name);
    });
    CALL(hrbfnpr_point_set_view_field) {
        hrbfnpr_array values{};
        status = hrbfnpr_point_set_view_field(s.painted.get(), 1, "a", &values, nullptr, error);
        result.add(values.data);
        result.add(values.count);
    });
}

void add_drawings(std::map<std::string, Call>& calls) {
    RETAIN_AND_RELEASE(drawing, s.drawing);
    INFO(hrbfnpr_drawing_get_info, hrbfnpr_drawing_info, s.drawing);
    CALL(hrbfnpr_drawing_get_layer_info) {
        auto info = made(hrbfnpr_drawing_layer_info_init);
        status = hrbfnpr_drawing_get_layer_info(s.drawing.get(), 0, &info, error);
        result.add(info);
    });
    CALL(hrbfnpr_drawing_rasterize) {
        Bytes pixels(std::size_t{4} * picture_size * picture_size);
        auto image = made(hrbfnpr_image_init);
        image.width = image.height = picture_size;
        image.pixels = pixels.data();
        status = hrbfnpr_drawing_rasterize(s.drawing.get(), &image, nullptr, error);
        result.add(pixels);
    });
    CALL(hrbfnpr_drawing_vertex_bound) {
        std::int64_t count = 0;
        status = hrbfnpr_drawing_vertex_bound(s.drawing.get(), HRBFNPR_PRIMITIVE_LINE_STRIPS, &count, nullptr, error);
        result.add(count);
    });
    CALL(hrbfnpr_drawing_write_vertices) {
        auto attribute = made(hrbfnpr_vertex_attribute_init);
        attribute.attribute = HRBFNPR_VERTEX_ATTRIBUTE_WINDOW;
        auto layout = made(hrbfnpr_vertex_layout_init);
        layout.attributes = &attribute;
        layout.attribute_count = 1;
        for (layout.primitive = HRBFNPR_PRIMITIVE_POINTS; layout.primitive <= HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS;
             ++layout.primitive) {
            std::vector<float> vertices(30000);
            status = hrbfnpr_drawing_write_vertices(s.drawing.get(), &layout, vertices.data(), 10000, nullptr, nullptr,
                                                    0, nullptr, error);
            result.add(vertices);
        }
    });
    CALL(hrbfnpr_drawing_mark_results) {
        auto layer = made(hrbfnpr_layer_info_init);
        hrbfnpr_point_set_get_layer_info(s.marks.get(), 1, &layer, error);
        std::vector<float> radius(static_cast<std::size_t>(layer.marks));
        auto results = made(hrbfnpr_mark_results_init);
        results.radius = out(radius);
        status = hrbfnpr_drawing_mark_results(s.drawing.get(), 0, 1, &results, error);
        result.add(radius);
    });
    CALL(hrbfnpr_drawing_write_mark_indices) {
        std::vector<std::uint32_t> indices(2000);
        std::int64_t count = 0;
        status = hrbfnpr_drawing_write_mark_indices(s.drawing.get(), 0, 1, HRBFNPR_CLASS_FRONT,
                                                    HRBFNPR_PRIMITIVE_LINE_STRIPS, indices.data(), 2000, &count, error);
        result.add(indices);
    });
    CALL(hrbfnpr_drawing_identify) {
        auto identity = made(hrbfnpr_mark_identity_init);
        status = hrbfnpr_drawing_identify(s.drawing.get(), 210, &identity, error);
        result.add(identity);
    });
}

void add_pictures(std::map<std::string, Call>& calls) {
    CALL(hrbfnpr_picture_restyle) {
        hrbfnpr::test::Picture other;
        status = restyle(s.picture.get(), other, error);
        auto info = made(hrbfnpr_picture_info_init);
        hrbfnpr_picture_get_info(other.get(), &info, error);
        result.add(info.marks);
    });
    INFO(hrbfnpr_picture_get_info, hrbfnpr_picture_info, s.picture);
    CALL(hrbfnpr_picture_get_part) {
        auto part = made(hrbfnpr_picture_part_init);
        status = hrbfnpr_picture_get_part(s.picture.get(), 0, &part, error);
        result.add(part);
    });
    CALL(hrbfnpr_picture_get_style) {
        const hrbfnpr_style* style = nullptr;
        status = hrbfnpr_picture_get_style(s.picture.get(), &style, error);
        result.add(style->layer_count);
    });
    CALL(hrbfnpr_picture_get_marks) {
        const hrbfnpr_generate_desc* desc = nullptr;
        status = hrbfnpr_picture_get_marks(s.picture.get(), &desc, error);
        result.add(desc->layer_count);
    });
    CALL(hrbfnpr_picture_get_note) {
        auto info = made(hrbfnpr_picture_info_init);
        status = hrbfnpr_picture_get_info(s.picture.get(), &info, error);
        for (std::int64_t i = 0; i < info.notes; ++i) {
            auto note = made(hrbfnpr_note_init);
            status = hrbfnpr_picture_get_note(s.picture.get(), i, &note, error);
            result.add(note.code);
        }
    });
    CALL(hrbfnpr_picture_get_stage) {
        auto stage = made(hrbfnpr_picture_event_init);
        status = hrbfnpr_picture_get_stage(s.picture.get(), 0, &stage, error);
        result.add(stage.stage);
    });
    CALL(hrbfnpr_picture_get_camera) {
        auto camera = made(hrbfnpr_camera_init);
        status = hrbfnpr_picture_get_camera(s.picture.get(), &camera, error);
        result.add(camera);
    });
    CALL(hrbfnpr_picture_look) {
        auto camera = made(hrbfnpr_camera_init);
        status = hrbfnpr_picture_look(s.picture.get(), nullptr, 70.0, 10.0, &camera, error);
        result.add(camera);
    });
    CALL(hrbfnpr_picture_orbit) {
        auto camera = made(hrbfnpr_camera_init);
        status = hrbfnpr_picture_orbit(s.picture.get(), 40.0, &camera, error);
        result.add(camera);
    });
    CALL(hrbfnpr_picture_plate_size) {
        std::int32_t width = 0, height = 0;
        status = hrbfnpr_picture_plate_size(s.picture.get(), nullptr, &width, &height, error);
        result.add(width * height);
    });
    CALL(hrbfnpr_picture_rasterize) {
        Bytes pixels(std::size_t{4} * picture_size * picture_size);
        auto image = made(hrbfnpr_image_init);
        image.width = image.height = picture_size;
        image.pixels = pixels.data();
        status = hrbfnpr_picture_rasterize(s.picture.get(), s.picture_drawing.get(), nullptr, &image, error);
        result.add(pixels);
    });
    CALL(hrbfnpr_picture_write) { // the drawing is shared, but each thread has a separate picture
        hrbfnpr::test::Picture own;
        status = restyle(s.picture.get(), own, error);
        if (status != HRBFNPR_STATUS_OK) return;
        Bytes page;
        status = hrbfnpr_picture_write(own.get(), s.picture_drawing.get(), nullptr, nullptr, append, &page, nullptr,
                                       nullptr, error);
        result.add(page);
    });
    RETAIN_AND_RELEASE(settings, s.settings);
}

std::map<std::string, Call> all_calls() {
    std::map<std::string, Call> calls;
    CALL(hrbfnpr_context_get_info) {
        auto info = made(hrbfnpr_context_info_init);
        status = hrbfnpr_context_get_info(s.context.get(), &info, error);
        result.add(info.thread_count); // bytes_now and bytes_peak depend on all threads
    });
    CALL(hrbfnpr_operation_is_cancelled) {
        UNUSED();
        result.add(hrbfnpr_operation_is_cancelled(s.operation));
    });
    CALL(hrbfnpr_operation_progress) {
        UNUSED();
        result.add(hrbfnpr_operation_progress(s.operation));
    });
    add_models(calls);
    add_meshes(calls);
    add_point_sets(calls);
    add_fields(calls);
    add_drawings(calls);
    add_pictures(calls);
    return calls;
}

#undef CALL
#undef RETAIN_AND_RELEASE
#undef INFO
#undef UNUSED

Result run(const Shared& shared, const std::string& name, const Call& call) {
    auto error = made(hrbfnpr_error_init);
    hrbfnpr_status status = HRBFNPR_STATUS_OK;
    Result result;
    call(shared, &error, result, status);
    EXPECT_EQ(status, HRBFNPR_STATUS_OK) << name << ": " << error.message;
    return result;
}

TEST(Const, EveryFunctionOfTheHeaderIsCalledHere) {
    const std::map<std::string, Call> calls = all_calls();
    const std::set<std::string> names(std::begin(const_names), std::end(const_names));
    for (const std::string& name : names) EXPECT_TRUE(calls.count(name) == 1) << name << " has no call: add one";
    for (const auto& [name, call] : calls) EXPECT_TRUE(names.count(name) == 1) << name << " takes no const handle";
}

TEST(Const, HandlesAreSharedByThreads) {
    const Shared shared;
    const std::map<std::string, Call> calls = all_calls();
    using Found = std::vector<std::pair<std::string, Result>>;
    std::vector<Found> found(threads);
    // Calls that wait for each other hide each other's races, so all threads also begin the same call at once.
    std::barrier<> together(threads);
    std::vector<std::thread> all;
    for (int thread = 0; thread < threads; ++thread)
        all.emplace_back([&, thread] {
            Found& mine = found[static_cast<std::size_t>(thread)];
            for (const auto& [name, call] : calls) {
                together.arrive_and_wait();
                mine.emplace_back(name, run(shared, name, call));
            }
            // Each thread begins with a different call, so that all kinds of calls meet.
            for (int round = 0; round < 3; ++round) {
                auto at = std::next(calls.begin(), thread * static_cast<std::ptrdiff_t>(calls.size()) / threads);
                for (std::size_t i = 0; i < calls.size(); ++i) {
                    mine.emplace_back(at->first, run(shared, at->first, at->second));
                    if (++at == calls.end()) at = calls.begin();
                }
            }
        });
    for (std::thread& thread : all) thread.join();
    // The calls run alone last: so the data that a handle makes at its first call are made by several threads, too.
    std::map<std::string, Result> alone;
    for (const auto& [name, call] : calls) alone.emplace(name, run(shared, name, call));
    for (const Found& mine : found) {
        EXPECT_EQ(mine.size(), 4 * calls.size());
        for (const auto& [name, result] : mine)
            EXPECT_TRUE(result == alone.at(name)) << name << " gave something else on several threads";
    }
}

} // namespace
} // namespace host_test::const_test

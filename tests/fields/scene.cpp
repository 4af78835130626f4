// SPDX-License-Identifier: MIT
#include "scene.h"
#include "views.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace fields_test {
namespace {

using hrbfnpr::test::Drawing;
using hrbfnpr::test::LineSet;
using hrbfnpr::test::made;
using hrbfnpr::test::Mesh;
using hrbfnpr::test::Model;
using hrbfnpr::test::Occluders;
using hrbfnpr::test::PointSet;
using hrbfnpr::test::Renderer;

constexpr std::uint8_t canary = 0x5a;
constexpr std::int64_t vertex_room = 20000;

std::int32_t unit_sphere(void* /*user*/, std::int64_t count, const double* points, double* value, double* gradient,
                         double* hessian) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        value[i] = 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1.0);
        for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = p[c];
        for (int c = 0; hessian != nullptr && c < 6; ++c) hessian[6 * i + c] = c == 0 || c == 3 || c == 5 ? 1.0 : 0.0;
    }
    return 0;
}

std::int32_t even_tone(void* /*user*/, std::int64_t count, const float* /*positions*/, const float* /*normals*/,
                       float* tau) {
    std::fill_n(tau, count, 0.5F);
    return 0;
}

std::int32_t even_density(void* /*user*/, std::int64_t count, const double* /*positions*/, const double* /*normals*/,
                          double* density) {
    std::fill_n(density, count, 1.0);
    return 0;
}

std::int32_t along_z(void* /*user*/, std::int64_t count, const double* /*positions*/, const double* /*normals*/,
                     double* directions) {
    for (std::int64_t i = 0; i < count; ++i) directions[3 * i + 2] = 1.0;
    return 0;
}

void run_one_by_one(void* /*user*/, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) task(task_context, i);
}

void ignore_log(void* /*user*/, std::int32_t /*level*/, const char* /*message*/) {}

} // namespace

Scene::Scene() {
    hrbfnpr_error_init(&error_, sizeof error_);
    describe_surface();
    scenes::Check check;
    hrbfnpr_context* context = nullptr;
    check(hrbfnpr_context_create(&context_desc_, &context, check.error()));
    context_.reset(context);
    take_time(plenty);
    describe_fields();
    describe_marks();
    describe_style();
    describe_output();
    connect();
    describe_pictures();
}

// Makes a new operation, since a cancelled operation stays cancelled. HRBFNPR_TEST_SLOWER says how many times slower a
// tool makes the program.
void Scene::take_time(std::chrono::milliseconds time) {
    scenes::Check check;
    const char* const slower = std::getenv("HRBFNPR_TEST_SLOWER");
    end_ = Clock::now() + time * (slower != nullptr ? std::max(std::atoi(slower), 1) : 1);
    hrbfnpr_operation* operation = nullptr;
    check(hrbfnpr_operation_create(context_.get(), &operation, check.error()));
    operation_.reset(operation);
    check(hrbfnpr_operation_set_callback(operation, progress, this, check.error()));
}

std::int32_t Scene::progress(void* user, double /*value*/) {
    return Clock::now() > static_cast<Scene*>(user)->end_ ? 1 : 0;
}

void Scene::describe_surface() {
    allocator_.largest = std::uint64_t{1} << 28;
    points_ = normals_ = room(18);
    std::copy(samples_.points.begin(), samples_.points.end(), points_.begin());
    std::copy(samples_.normals.begin(), samples_.normals.end(), normals_.begin());
    for (auto& numbers : result_) numbers = room(1024);
    depths_.points.resize(16 * depths_.points.size());

    context_desc_ = made(hrbfnpr_context_desc_init);
    context_desc_.thread_count = 1;
    context_desc_.allocate = hrbfnpr::test::Allocator::allocate;
    context_desc_.deallocate = hrbfnpr::test::Allocator::deallocate;
    context_desc_.allocator_user = &allocator_;
    context_desc_.log = ignore_log;
    context_desc_.run_tasks = run_one_by_one;

    fit_desc_ = made(hrbfnpr_fit_desc_init);
    fit_desc_.points = in(points_, 6);
    fit_desc_.normals = in(normals_, 6);
    orient_desc_ = made(hrbfnpr_orient_desc_init);
    orient_desc_.points = in(points_, 6);
    orient_desc_.normals = in(normals_, 6);
    depth_image_desc_ = made(hrbfnpr_depth_image_desc_init);
    depth_image_desc_.columns = depths_.columns;
    depth_image_desc_.rows = depths_.rows;
    depth_image_desc_.points = in(depths_.points, std::int64_t{depths_.columns} * depths_.rows);
    custom_desc_ = made(hrbfnpr_custom_desc_init);
    custom_desc_.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN;
    custom_desc_.function = unit_sphere;
    for (int axis = 0; axis < 3; ++axis) {
        custom_desc_.bounds_min[axis] = -1.0;
        custom_desc_.bounds_max[axis] = 1.0;
    }
    for (hrbfnpr_csg_node& node : csg_node_) {
        node = made(hrbfnpr_csg_node_init);
        node.distance = 0.05;
    }
    csg_node_[0].blend = 0.2;
    csg_node_[1].parent = csg_node_[2].parent = 0;
    csg_node_[1].kind = HRBFNPR_CSG_CONE;
    csg_node_[2].kind = HRBFNPR_CSG_BOX;
    csg_desc_ = made(hrbfnpr_csg_desc_init);
    csg_desc_.nodes = csg_node_;
    csg_desc_.node_count = 3;
    project_desc_ = made(hrbfnpr_project_desc_init);
    projection_ = made(hrbfnpr_projection_init);
    projection_.position = out(result_[0], 6);
    projection_.normal = out(result_[1], 6);
    projection_.status = out(result_[2], 6, 1, HRBFNPR_SCALAR_UINT32);
    curvature_ = made(hrbfnpr_curvature_init);
    curvature_.k1 = out(result_[0], 6, 1);
    curvature_.k2 = out(result_[1], 6, 1);
    curvature_.d1 = out(result_[2], 6);
    curvature_.d2 = out(result_[3], 6);
    curvature_.confidence = out(result_[4], 6, 1);
    cast_desc_ = made(hrbfnpr_cast_desc_init);
    ray_hits_ = made(hrbfnpr_ray_hits_init);
    ray_hits_.count = out(result_[0], 6, 1, HRBFNPR_SCALAR_UINT32);
    ray_hits_.t = out(result_[1], 6, 1);
    ray_hits_.position = out(result_[2], 6);
    ray_hits_.normal = out(result_[3], 6);
    ray_hits_.entering = out(result_[4], 6, 1, HRBFNPR_SCALAR_UINT8);
    ray_hits_.status = out(result_[5], 6, 1, HRBFNPR_SCALAR_UINT32);
    trim_desc_ = made(hrbfnpr_trim_desc_init);
    trim_desc_.points = in(points_, 6);
    trim_desc_.normals = in(normals_, 6);
}

// A scalar field of the samples, and one of directions at triangles, which hatching follows.
void Scene::describe_fields() {
    scenes::Check check;
    numbers_ = room(6);
    std::fill_n(numbers_.begin(), 6, 0.5);
    field_desc_[0] = made(hrbfnpr_field_desc_init);
    field_desc_[0].points = in(points_, 6);
    field_desc_[0].values = {numbers_.data(), 6, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    field_desc_[0].range[1] = 1.0;
    field_desc_[1] = made(hrbfnpr_field_desc_init);
    field_desc_[1].kind = HRBFNPR_FIELD_KIND_DIRECTION;
    field_desc_[1].points = field_desc_[1].values = in(points_, 6);
    corners_.assign(64, 0);
    for (std::uint32_t i = 0; i < 6; ++i) corners_[i] = i;
    field_desc_[1].triangles = {corners_.data(), 2, 0, HRBFNPR_SCALAR_UINT32, 3};
    hrbfnpr_field* field = nullptr;
    check(hrbfnpr_field_create(context_.get(), &field_desc_[0], nullptr, &field, check.error()));
    density_.reset(field);
    check(hrbfnpr_field_create(context_.get(), &field_desc_[1], nullptr, &field, check.error()));
    way_.reset(field);
    mark_field_ = made(hrbfnpr_mark_field_init);
    mark_field_.name = "density";
    mark_field_.field = density_.get();
    for (std::size_t i = 0; i < 16; i += 5) turn_[i] = 1.0;
    mark_field_.transform = turn_;
}

void Scene::describe_marks() {
    scenes::Check check;
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context_.get(), &fit_desc_, nullptr, &model, check.error()));
    model_.reset(model);

    for (hrbfnpr_layer_desc& layer : layer_desc_) {
        layer = made(hrbfnpr_layer_desc_init);
        layer.budget = 100;
        layer.levels = 1;
        layer.density_function = even_density;
    }
    layer_desc_[0].name = "lines";
    layer_desc_[0].kind = HRBFNPR_LAYER_KIND_HATCH;
    layer_desc_[0].direction_function = along_z;
    layer_desc_[1].kind = HRBFNPR_LAYER_KIND_STIPPLES;
    layer_desc_[1].density_field = density_.get();
    generate_desc_ = made(hrbfnpr_generate_desc_init);
    generate_desc_.layers = layer_desc_;
    generate_desc_.layer_count = 2;
    generate_desc_.seed_points = in(points_, 6);

    layer_arrays_ = made(hrbfnpr_layer_arrays_init);
    layer_arrays_.kind = HRBFNPR_LAYER_KIND_HATCH;
    layer_arrays_.name = "own";
    layer_arrays_.position = in(points_, 6);
    layer_arrays_.normal = in(normals_, 6);
    tangents_ = room(18); // the unit vector of the next axis
    for (std::size_t i = 0; i < 18; ++i) tangents_[i] = normals_[i % 3 == 2 ? i - 2 : i + 1];
    layer_arrays_.direction = in(tangents_, 6);
    firsts_.assign(64, 0);
    firsts_[1] = 3;
    firsts_[2] = 6;
    layer_arrays_.stroke_first = {firsts_.data(), 3, 0, HRBFNPR_SCALAR_UINT32, 1};
    layer_arrays_.rank = layer_arrays_.width = {numbers_.data(), 6, 0, HRBFNPR_SCALAR_FLOAT64, 1};

    line_desc_[0] = made(hrbfnpr_line_desc_init);
    line_desc_[0].kind = HRBFNPR_LINE_KIND_SECTION;
    line_desc_[0].name = "sections";
    line_desc_[0].plane[2] = 1.0;
    line_desc_[0].levels = {numbers_.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    line_desc_[1] = made(hrbfnpr_line_desc_init);
    line_desc_[1].kind = HRBFNPR_LINE_KIND_OWN;
    line_desc_[1].position = in(points_, 6);
    line_desc_[1].line_first = {firsts_.data(), 3, 0, HRBFNPR_SCALAR_UINT32, 1};
    line_set_desc_ = made(hrbfnpr_line_set_desc_init);
    line_set_desc_.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
    line_set_desc_.cell_size = 0.3;
    line_set_desc_.lines = line_desc_;
    line_set_desc_.line_count = 2;
    line_set_desc_.seed_points = line_set_desc_.support_points = in(points_, 6);
    line_set_desc_.support_normals = in(normals_, 6);

    hrbfnpr_point_set* set = nullptr;
    check(hrbfnpr_point_set_generate(context_.get(), model, &generate_desc_, nullptr, &set, check.error()));
    set_.reset(set);
    hrbfnpr_line_set* lines = nullptr;
    check(hrbfnpr_line_set_create(context_.get(), model, &line_set_desc_, nullptr, &lines, check.error()));
    lines_.reset(lines);
    cast_desc_.line_set = lines;
    point_set_desc_ = made(hrbfnpr_point_set_desc_init);
    point_set_desc_.base = set;
    point_set_desc_.layers = &layer_arrays_;
    point_set_desc_.layer_count = 1;
}

void Scene::describe_style() {
    scenes::Check check;
    camera_ = made(hrbfnpr_camera_init);
    const std::array<double, 3> low{-1.5, -1.5, -1.5};
    const std::array<double, 3> high{1.5, 1.5, 1.5};
    const std::array<double, 3> direction{0.0, 0.3, -1.0};
    const std::array<double, 3> up{0.0, 1.0, 0.0};
    check(hrbfnpr_camera_fit_bounds(&camera_, low.data(), high.data(), direction.data(), up.data(), 0.6, 32.0, 32.0,
                                    0.05, check.error()));
    style_ = made(hrbfnpr_style_init);
    layer_style_ = made(hrbfnpr_layer_style_init);
    layer_style_.name = "lines";
    layer_style_.shape = HRBFNPR_SHAPE_HATCH;
    line_style_[0] = made(hrbfnpr_line_style_init);
    line_style_[0].hidden = HRBFNPR_HIDDEN_LINES_SHOW;
    line_style_[0].dash = 4.0F;
    line_style_[0].gap = 2.0F;
    line_style_[1] = made(hrbfnpr_line_style_init);
    line_style_[1].kind = HRBFNPR_LINE_KIND_ISOPHOTE;
    line_style_[1].levels = {numbers_.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    style_.layers = &layer_style_;
    style_.layer_count = 1;
    style_.lines = line_style_;
    style_.line_count = 2;
    light_[0] = made(hrbfnpr_light_init);
    light_[0].shadow = 1.0F;
    light_[1] = made(hrbfnpr_light_init);
    light_[1].kind = HRBFNPR_LIGHT_KIND_PLACE;
    light_[1].space = HRBFNPR_LIGHT_ITEM;
    light_[1].intensity = 0.5F;
    light_[1].shadow = 0.5F;
    light_[1].softness = 0.1F;
    style_.lights = light_;
    style_.light_count = 2;
    style_.ambient_sky = 0.25F;
    style_.curvature_contrast = 0.25F;
    style_.tone_function = even_tone;
    item_ = made(hrbfnpr_item_init);
    item_.point_set = set_.get();
    item_.model = model_.get();
    item_.line_set = lines_.get();
    item_.style = &style_;
    shading_desc_ = made(hrbfnpr_shading_desc_init);
    shading_desc_.sky_rays = shading_desc_.shadow_rays = 4;
    shaded_item_ = item_;
    hrbfnpr_occluders* occluders = nullptr;
    check(hrbfnpr_occluders_create(context_.get(), &item_, 1, 0, nullptr, &occluders, check.error()));
    const Occluders owner(occluders);
    hrbfnpr_shading* shading = nullptr;
    check(hrbfnpr_shading_create(context_.get(), occluders, &item_, &camera_, &shading_desc_, nullptr, &shading,
                                 check.error()));
    shading_.reset(shading);
    item_.shading = shading;
    hrbfnpr_array position{};
    check(hrbfnpr_point_set_view(set_.get(), 1, HRBFNPR_MARK_ATTRIBUTE_POSITION, &position, check.error()));
    up_ = room(static_cast<std::size_t>(3 * position.count));
    for (std::int64_t i = 0; i < position.count; ++i) up_[static_cast<std::size_t>(3 * i) + 2] = 1.0;
    pose_ = made(hrbfnpr_layer_pose_init);
    pose_.layer = 1;
    pose_.position = pose_.normal = in(up_, position.count);
    posed_item_ = made(hrbfnpr_item_init);
    posed_item_.point_set = set_.get();
    posed_item_.poses = &pose_;
    posed_item_.pose_count = 1;
}

void Scene::describe_output() {
    scenes::Check check;
    hrbfnpr_renderer* renderer = nullptr;
    check(hrbfnpr_renderer_create(context_.get(), &renderer, check.error()));
    renderer_.reset(renderer);
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_renderer_draw(renderer, &item_, 1, 0, &camera_, &drawing, check.error()));
    drawing_.reset(drawing);

    pixels_.assign(std::size_t{64} * 32 * 32, 0);
    vertices_.assign(std::size_t{64} * vertex_room, 0);
    image_ = made(hrbfnpr_image_init);
    image_.width = image_.height = 32;
    image_.pixels = pixels_.data();
    raster_desc_ = made(hrbfnpr_raster_desc_init);
    raster_desc_.host_depth = {result_[3].data(), 1024, 0, HRBFNPR_SCALAR_FLOAT32, 1};
    raster_desc_.depth = out(result_[0], 1024, 1, HRBFNPR_SCALAR_FLOAT32);
    raster_desc_.id = out(result_[1], 1024, 1, HRBFNPR_SCALAR_UINT32);
    raster_desc_.mark_class = out(result_[2], 1024, 1, HRBFNPR_SCALAR_UINT8);
    vertex_attribute_ = made(hrbfnpr_vertex_attribute_init);
    vertex_attribute_.attribute = HRBFNPR_VERTEX_ATTRIBUTE_WINDOW;
    vertex_attribute_.scalar = HRBFNPR_SCALAR_FLOAT32;
    vertex_layout_ = made(hrbfnpr_vertex_layout_init);
    vertex_layout_.attributes = &vertex_attribute_;
    vertex_layout_.attribute_count = 1;
    vertex_layout_.stride = 16;
    hrbfnpr_array position{};
    check(hrbfnpr_point_set_view(set_.get(), 1, HRBFNPR_MARK_ATTRIBUTE_POSITION, &position, check.error()));
    mark_results_ = made(hrbfnpr_mark_results_init);
    mark_results_.shown = out(result_[0], position.count, 1, HRBFNPR_SCALAR_UINT8);
    mark_results_.radius = out(result_[1], position.count, 1, HRBFNPR_SCALAR_FLOAT32);
    mark_results_.opacity = out(result_[2], position.count, 1, HRBFNPR_SCALAR_FLOAT32);

    // An octahedron of the samples, which are (+-1, 0, 0) and so on.
    triangles_ = room(24);
    auto* index = reinterpret_cast<std::uint32_t*>(triangles_.data());
    std::vector<std::uint32_t> pole(6);
    for (std::uint32_t i = 0; i < 6; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (const double c = points_[3 * i + axis]; c * c > 0.5) pole[2 * axis + (c > 0.0 ? 0 : 1)] = i;
    for (std::size_t face = 0; face < 8; ++face) {
        const std::array<std::size_t, 3> side{face & 1U, (face >> 1U) & 1U, (face >> 2U) & 1U};
        const bool turned = (side[0] + side[1] + side[2]) % 2 == 1;
        const std::array<std::uint32_t, 3> corner{pole[side[0]], pole[2 + side[1]], pole[4 + side[2]]};
        for (std::size_t c = 0; c < 3; ++c) index[3 * face + c] = corner[turned ? 2 - c : c];
    }
    mesh_desc_ = made(hrbfnpr_mesh_desc_init);
    mesh_desc_.vertices = in(points_, 6);
    mesh_desc_.triangles = {index, 8, 0, HRBFNPR_SCALAR_UINT32, 3};
    hrbfnpr_mesh* mesh = nullptr;
    check(hrbfnpr_mesh_create(context_.get(), &mesh_desc_, nullptr, &mesh, check.error()));
    mesh_.reset(mesh);
    sample_desc_ = made(hrbfnpr_sample_desc_init);
    mesh_edges_desc_ = made(hrbfnpr_mesh_edges_desc_init);
    compare_desc_ = made(hrbfnpr_compare_desc_init);
    compare_desc_.points = 100;
    compare_desc_.cell_size = 0.3;
    mesh_fit_desc_ = made(hrbfnpr_mesh_fit_desc_init);
    mesh_fit_desc_.maximum_centres = 40;
    mesh_fit_desc_.candidates = 1000;
}

void Scene::connect() {
    page_item_ = made(hrbfnpr_page_item_init);
    page_item_.drawing = drawing_.get();
    page_item_.name = "sphere";
    pen_ = made(hrbfnpr_pen_init);
    pen_.groups = "*";
    annotation_ = made(hrbfnpr_annotation_init);
    annotation_.text = "a text";
    annotation_.group = "texts";
    annotation_.points = {points_.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 2};
    page_desc_ = made(hrbfnpr_page_desc_init);
    page_desc_.items = &page_item_;
    page_desc_.item_count = 1;
    page_desc_.pens = &pen_;
    page_desc_.pen_count = 1;
    page_desc_.annotations = &annotation_;
    page_desc_.annotation_count = 1;
}

void Scene::describe_pictures() {
    scenes::Check check;
    source_ = made(hrbfnpr_picture_source_init);
    source_.points = in(points_, 6);
    source_.normals = in(normals_, 6);
    source_.name = "sphere";
    source_field_ = made(hrbfnpr_source_field_init);
    source_field_.name = "quality";
    source_field_.values = {quality_.data(), 6, 0, HRBFNPR_SCALAR_FLOAT32, 1};
    source_.fields = &source_field_;
    source_.field_count = 1;
    change_ = made(hrbfnpr_change_init);
    change_.field = "marks.layers.budget";
    change_.value = "50";
    dab_ = made(hrbfnpr_dab_init);
    dab_.normal[2] = dab_.direction[0] = 1.0;
    dab_.radius = 0.5;
    picture_desc_ = made(hrbfnpr_picture_desc_init);
    picture_desc_.flags = HRBFNPR_PICTURE_ALLOW_BLANK;
    picture_desc_.sources = &source_;
    picture_desc_.source_count = 1;
    picture_desc_.changes = &change_;
    picture_desc_.change_count = 1;
    picture_desc_.dabs = &dab_;
    picture_desc_.dab_count = 1;
    picture_desc_.width = picture_desc_.height = 32;
    hrbfnpr_picture* picture = nullptr;
    check(hrbfnpr_picture_create(context_.get(), &picture_desc_, nullptr, &picture, check.error()));
    picture_.reset(picture);
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_picture_draw(picture, nullptr, nullptr, &drawing, check.error()));
    picture_drawing_.reset(drawing);
    picture_page_desc_ = made(hrbfnpr_picture_page_desc_init);
    picture_page_desc_.paper = "a6";
    numbers_[0] = 0.3;
    picture_page_desc_.pen_widths = {numbers_.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    views_desc_ = made(hrbfnpr_views_desc_init);
    views_desc_.sections = "z";
    views_desc_.title = "sphere";
    views_desc_.paper = "a4";
}

Outcome Scene::outcome(hrbfnpr_status status, bool clean) const {
    return {status, status == HRBFNPR_STATUS_OK ? "" : error_.message, status == HRBFNPR_STATUS_OK || clean};
}

void Scene::fill_canaries() {
    std::fill(pixels_.begin(), pixels_.end(), canary);
    std::fill(vertices_.begin(), vertices_.end(), canary);
}

bool Scene::canaries_are_whole(std::span<const std::uint8_t> bytes) const {
    return std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t byte) { return byte == canary; });
}

Outcome Scene::picture_of(hrbfnpr_renderer* renderer, const hrbfnpr_item& of) {
    fill_canaries();
    hrbfnpr_drawing* drawing = sentinel<hrbfnpr_drawing>();
    hrbfnpr_status status = hrbfnpr_renderer_draw(renderer, &of, 1, 0, &camera_, &drawing, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, drawing == nullptr);
    const Drawing owner(drawing);
    auto image = image_;
    image.width = static_cast<std::int32_t>(std::clamp(camera_.viewport[2], 1.0, 64.0));
    image.height = static_cast<std::int32_t>(std::clamp(camera_.viewport[3], 1.0, 64.0));
    status = hrbfnpr_drawing_rasterize(drawing, &image, nullptr, &error_);
    return outcome(status, canaries_are_whole(pixels_));
}

Outcome Scene::picture_of(const hrbfnpr_point_set* set) {
    auto item = made(hrbfnpr_item_init);
    item.point_set = set;
    return picture_of(renderer_.get(), item);
}

Outcome Scene::picture_of(hrbfnpr_context* context, const hrbfnpr_model* model) {
    auto layer = made(hrbfnpr_layer_desc_init);
    layer.budget = 50;
    auto desc = made(hrbfnpr_generate_desc_init);
    desc.layers = &layer;
    desc.layer_count = 1;
    hrbfnpr_operation* operation = nullptr;
    hrbfnpr_status status = hrbfnpr_operation_create(context, &operation, &error_);
    const hrbfnpr::test::Operation own_operation(operation);
    if (status == HRBFNPR_STATUS_OK) status = hrbfnpr_operation_set_callback(operation, progress, this, &error_);
    hrbfnpr_point_set* set = sentinel<hrbfnpr_point_set>();
    if (status == HRBFNPR_STATUS_OK)
        status = hrbfnpr_point_set_generate(context, model, &desc, operation, &set, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, set == nullptr);
    const PointSet owner(set);
    hrbfnpr_renderer* renderer = nullptr;
    status = hrbfnpr_renderer_create(context, &renderer, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status);
    const Renderer own_renderer(renderer);
    auto item = made(hrbfnpr_item_init);
    item.point_set = set;
    return picture_of(renderer, item);
}

} // namespace fields_test

// SPDX-License-Identifier: MIT
// Runs each descriptor, through to a picture where it leads to one.
#include "scene.h"
#include "views.h"

namespace fields_test {
namespace {

using hrbfnpr::test::made;

std::int32_t swallow(void* user, const void* /*data*/, std::uint64_t size) {
    *static_cast<std::uint64_t*>(user) += size;
    return 0;
}

} // namespace

Outcome Scene::create_context() {
    hrbfnpr_context* context = sentinel<hrbfnpr_context>();
    hrbfnpr_status status = hrbfnpr_context_create(&context_desc_, &context, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, context == nullptr);
    const hrbfnpr::test::Context owner(context);
    hrbfnpr_model* model = nullptr;
    status = hrbfnpr_model_fit(context, &fit_desc_, nullptr, &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model own_model(model);
    return picture_of(context, model);
}

Outcome Scene::fit() {
    hrbfnpr_model* model = sentinel<hrbfnpr_model>();
    const hrbfnpr_status status = hrbfnpr_model_fit(context_.get(), &fit_desc_, operation_.get(), &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model owner(model);
    return picture_of(context_.get(), model);
}

Outcome Scene::orient() {
    std::vector<double> normals = room(18);
    const std::vector<double> before = normals;
    const hrbfnpr_array_out made_normals = out(normals, 6);
    const hrbfnpr_status status =
        hrbfnpr_orient(context_.get(), &orient_desc_, operation_.get(), &made_normals, nullptr, &error_);
    return outcome(status, normals == before);
}

Outcome Scene::smooth_depth_image() {
    const std::int64_t pixels = std::int64_t{depths_.columns} * depths_.rows;
    std::vector<double> points = room(static_cast<std::size_t>(3 * pixels));
    std::vector<double> normals = points;
    const std::vector<double> before = points;
    const hrbfnpr_array_out moved = out(points, pixels);
    const hrbfnpr_array_out made_normals = out(normals, pixels);
    const hrbfnpr_status status = hrbfnpr_smooth_depth_image(context_.get(), &depth_image_desc_, operation_.get(),
                                                             &moved, &made_normals, nullptr, &error_);
    return outcome(status, points == before && normals == before);
}

Outcome Scene::create_custom() {
    hrbfnpr_model* model = sentinel<hrbfnpr_model>();
    const hrbfnpr_status status = hrbfnpr_model_create_custom(context_.get(), &custom_desc_, &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model owner(model);
    return picture_of(context_.get(), model);
}

Outcome Scene::create_csg() {
    hrbfnpr_model* model = sentinel<hrbfnpr_model>();
    const hrbfnpr_status status = hrbfnpr_model_create_csg(context_.get(), &csg_desc_, &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model owner(model);
    return picture_of(context_.get(), model);
}

Outcome Scene::project() {
    const hrbfnpr_array points = in(points_, 6);
    return outcome(
        hrbfnpr_model_project(model_.get(), &points, &project_desc_, &projection_, operation_.get(), &error_));
}

Outcome Scene::curvature() {
    const hrbfnpr_array points = in(points_, 6);
    return outcome(hrbfnpr_model_curvature(model_.get(), &points, &curvature_, operation_.get(), &error_));
}

Outcome Scene::cast() {
    std::vector<double> from = points_;
    std::vector<double> along = normals_;
    for (double& number : from) number *= 3.0;
    for (double& number : along) number = -number;
    const hrbfnpr_array origins = in(from, 6);
    const hrbfnpr_array directions = in(along, 6);
    return outcome(hrbfnpr_model_cast_rays(model_.get(), &origins, &directions, &cast_desc_, &ray_hits_,
                                           operation_.get(), &error_));
}

Outcome Scene::trim() {
    hrbfnpr_model* model = sentinel<hrbfnpr_model>();
    const hrbfnpr_status status = hrbfnpr_model_trim(model_.get(), &trim_desc_, operation_.get(), &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model owner(model);
    return picture_of(context_.get(), model);
}

Outcome Scene::generate() {
    std::vector<double> corner = room(12);
    const hrbfnpr_array_out corners{corner.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 12};
    const hrbfnpr_status patches = hrbfnpr_point_set_step_patches(context_.get(), model_.get(), &generate_desc_,
                                                                  &corners, nullptr, operation_.get(), &error_);
    hrbfnpr_point_set* set = sentinel<hrbfnpr_point_set>();
    const hrbfnpr_status status =
        hrbfnpr_point_set_generate(context_.get(), model_.get(), &generate_desc_, operation_.get(), &set, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, set == nullptr);
    const hrbfnpr::test::PointSet owner(set);
    return patches == HRBFNPR_STATUS_OK ? picture_of(set) : outcome(patches);
}

Outcome Scene::create_point_set() {
    hrbfnpr_point_set* set = sentinel<hrbfnpr_point_set>();
    const hrbfnpr_status status = hrbfnpr_point_set_create(context_.get(), &point_set_desc_, &set, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, set == nullptr);
    const hrbfnpr::test::PointSet owner(set);
    return picture_of(set);
}

Outcome Scene::create_field() {
    for (const hrbfnpr_field_desc& desc : field_desc_) {
        hrbfnpr_field* field = sentinel<hrbfnpr_field>();
        hrbfnpr_status status = hrbfnpr_field_create(context_.get(), &desc, operation_.get(), &field, &error_);
        if (status != HRBFNPR_STATUS_OK) return outcome(status, field == nullptr);
        const hrbfnpr::test::Field owner(field);
        std::vector<double> values = room(18);
        const hrbfnpr_array at = in(points_, 6), normals = in(normals_, 6);
        const hrbfnpr_array_out to = out(values, 6, desc.kind == HRBFNPR_FIELD_KIND_SCALAR ? 1 : 3);
        status = hrbfnpr_field_evaluate(field, &at, &normals, &to, nullptr, operation_.get(), &error_);
        if (status != HRBFNPR_STATUS_OK) return outcome(status);
    }
    return outcome(HRBFNPR_STATUS_OK);
}

Outcome Scene::give_field() {
    hrbfnpr_point_set* set = sentinel<hrbfnpr_point_set>();
    const hrbfnpr_status status =
        hrbfnpr_point_set_with_fields(context_.get(), set_.get(), &mark_field_, 1, 0, operation_.get(), &set, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, set == nullptr);
    const hrbfnpr::test::PointSet owner(set);
    return picture_of(set);
}

Outcome Scene::create_line_set() {
    hrbfnpr_line_set* lines = sentinel<hrbfnpr_line_set>();
    const hrbfnpr_status status =
        hrbfnpr_line_set_create(context_.get(), model_.get(), &line_set_desc_, operation_.get(), &lines, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, lines == nullptr);
    const hrbfnpr::test::LineSet owner(lines);
    hrbfnpr_item item = item_;
    item.line_set = lines;
    return picture_of(renderer_.get(), item);
}

Outcome Scene::draw() { return picture_of(renderer_.get(), item_); }

Outcome Scene::draw_posed() { return picture_of(renderer_.get(), posed_item_); }

Outcome Scene::shade() {
    hrbfnpr_occluders* occluders = sentinel<hrbfnpr_occluders>();
    hrbfnpr_status status =
        hrbfnpr_occluders_create(context_.get(), &shaded_item_, 1, 0, operation_.get(), &occluders, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, occluders == nullptr);
    const hrbfnpr::test::Occluders owner(occluders);
    hrbfnpr_shading* shading = sentinel<hrbfnpr_shading>();
    status = hrbfnpr_shading_create(context_.get(), occluders, &shaded_item_, &camera_, &shading_desc_,
                                    operation_.get(), &shading, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, shading == nullptr);
    const hrbfnpr::test::Shading own_shading(shading);
    hrbfnpr_item item = shaded_item_;
    item.shading = shading;
    return picture_of(renderer_.get(), item);
}

Outcome Scene::rasterize() {
    fill_canaries();
    const hrbfnpr_status status = hrbfnpr_drawing_rasterize(drawing_.get(), &image_, &raster_desc_, &error_);
    return outcome(status, canaries_are_whole(pixels_));
}

Outcome Scene::write_vertices() {
    fill_canaries();
    std::int64_t count = -7;
    std::int64_t index_count = -7;
    std::vector<std::uint32_t> indices(vertices_.size() / 16);
    const hrbfnpr_status status = hrbfnpr_drawing_write_vertices(
        drawing_.get(), &vertex_layout_, vertices_.data(), 2000, &count, indices.data(), 20000, &index_count, &error_);
    return outcome(status, canaries_are_whole(vertices_) &&
                               (status == HRBFNPR_STATUS_BUFFER_TOO_SMALL || (count == -7 && index_count == -7)));
}

Outcome Scene::mark_results() {
    const std::vector<double> before = result_[0];
    const hrbfnpr_status status = hrbfnpr_drawing_mark_results(drawing_.get(), 0, 1, &mark_results_, &error_);
    return outcome(status, result_[0] == before);
}

Outcome Scene::create_mesh() {
    hrbfnpr_mesh* mesh = sentinel<hrbfnpr_mesh>();
    hrbfnpr_status status = hrbfnpr_mesh_create(context_.get(), &mesh_desc_, operation_.get(), &mesh, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, mesh == nullptr);
    const hrbfnpr::test::Mesh owner(mesh);
    hrbfnpr_model* model = nullptr;
    status = hrbfnpr_model_fit_mesh(mesh, &mesh_fit_desc_, nullptr, nullptr, operation_.get(), &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model own_model(model);
    return picture_of(context_.get(), model);
}

Outcome Scene::sample_mesh() {
    std::vector<double> points = room(30);
    std::vector<double> normals = room(30);
    const std::vector<double> before = points;
    const hrbfnpr_array_out to_points = out(points, 10);
    const hrbfnpr_array_out to_normals = out(normals, 10);
    const hrbfnpr_status status =
        hrbfnpr_mesh_sample(mesh_.get(), &sample_desc_, &to_points, &to_normals, operation_.get(), &error_);
    return outcome(status, points == before && normals == before);
}

Outcome Scene::find_mesh_edges() {
    std::vector<std::int32_t> patch(8, 7);
    std::vector<std::int32_t> sharp(24, 7);
    const std::vector<std::int32_t> before = sharp;
    const hrbfnpr_array_out patches{patch.data(), 8, 0, HRBFNPR_SCALAR_INT32, 1};
    const hrbfnpr_array_out sides{sharp.data(), 8, 0, HRBFNPR_SCALAR_INT32, 3};
    const hrbfnpr_status status =
        hrbfnpr_mesh_edges(mesh_.get(), &mesh_edges_desc_, &patches, &sides, nullptr, operation_.get(), &error_);
    return outcome(status, sharp == before && patch[0] == 7);
}

Outcome Scene::compare_mesh() {
    auto comparison = made(hrbfnpr_comparison_init);
    const hrbfnpr_status status =
        hrbfnpr_model_compare_mesh(model_.get(), mesh_.get(), &compare_desc_, &comparison, operation_.get(), &error_);
    return outcome(status, comparison.surface_points == 0);
}

Outcome Scene::fit_mesh() {
    hrbfnpr_model* model = sentinel<hrbfnpr_model>();
    const hrbfnpr_status status =
        hrbfnpr_model_fit_mesh(mesh_.get(), &mesh_fit_desc_, nullptr, nullptr, operation_.get(), &model, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, model == nullptr);
    const hrbfnpr::test::Model owner(model);
    return picture_of(context_.get(), model);
}

// Writes the page in every format, and returns the last failure.
Outcome Scene::write_page() {
    Outcome result;
    const std::uint32_t given = page_desc_.format;
    for (std::uint32_t format = HRBFNPR_PAGE_FORMAT_SVG; format <= HRBFNPR_PAGE_FORMAT_DXF; ++format) {
        if (given == HRBFNPR_PAGE_FORMAT_SVG) page_desc_.format = format;
        std::uint64_t bytes = 0;
        auto info = made(hrbfnpr_page_info_init);
        const hrbfnpr_status status =
            hrbfnpr_page_write(context_.get(), &page_desc_, swallow, &bytes, &info, operation_.get(), &error_);
        if (status != HRBFNPR_STATUS_OK) result = outcome(status, info.bytes == 0);
    }
    page_desc_.format = given;
    return result;
}

Outcome Scene::make_picture() {
    hrbfnpr_picture* picture = sentinel<hrbfnpr_picture>();
    hrbfnpr_status status = hrbfnpr_picture_create(context_.get(), &picture_desc_, operation_.get(), &picture, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, picture == nullptr);
    const hrbfnpr::test::Picture owner(picture);
    if ((picture_desc_.flags & HRBFNPR_PICTURE_SURFACE_ONLY) != 0) return outcome(status);
    hrbfnpr_drawing* drawing = sentinel<hrbfnpr_drawing>();
    status = hrbfnpr_picture_draw(picture, nullptr, operation_.get(), &drawing, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status, drawing == nullptr);
    const hrbfnpr::test::Drawing own_drawing(drawing);
    auto image = image_;
    status = hrbfnpr_picture_plate_size(picture, nullptr, &image.width, &image.height, &error_);
    if (status != HRBFNPR_STATUS_OK) return outcome(status);
    std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height));
    image.pixels = pixels.data();
    return outcome(hrbfnpr_picture_rasterize(picture, drawing, nullptr, &image, &error_));
}

Outcome Scene::write_picture() {
    std::uint64_t bytes = 0;
    auto info = made(hrbfnpr_page_info_init);
    const hrbfnpr_status status =
        hrbfnpr_picture_write(picture_.get(), picture_drawing_.get(), nullptr, &picture_page_desc_, swallow, &bytes,
                              &info, operation_.get(), &error_);
    return outcome(status, info.bytes == 0);
}

Outcome Scene::write_views() {
    std::uint64_t bytes = 0;
    auto info = made(hrbfnpr_views_info_init);
    const hrbfnpr_status status =
        hrbfnpr_picture_write_views(picture_.get(), &views_desc_, swallow, &bytes, &info, operation_.get(), &error_);
    return outcome(status, info.views == 0);
}

std::vector<Slot> Scene::slots() {
    using namespace hrbfnpr::api;
    return {
#define FIELDS_TEST_SLOT(record, member, run)                                                                          \
    Slot{#record, fields_of_##record, reinterpret_cast<std::byte*>(&(member)), sizeof(member), &Scene::run}
        FIELDS_TEST_SLOT(hrbfnpr_context_desc, context_desc_, create_context),
        FIELDS_TEST_SLOT(hrbfnpr_fit_desc, fit_desc_, fit),
        FIELDS_TEST_SLOT(hrbfnpr_orient_desc, orient_desc_, orient),
        FIELDS_TEST_SLOT(hrbfnpr_depth_image_desc, depth_image_desc_, smooth_depth_image),
        FIELDS_TEST_SLOT(hrbfnpr_custom_desc, custom_desc_, create_custom),
        FIELDS_TEST_SLOT(hrbfnpr_csg_node, csg_node_[0], create_csg),
        FIELDS_TEST_SLOT(hrbfnpr_csg_node, csg_node_[1], create_csg),
        FIELDS_TEST_SLOT(hrbfnpr_csg_desc, csg_desc_, create_csg),
        FIELDS_TEST_SLOT(hrbfnpr_project_desc, project_desc_, project),
        FIELDS_TEST_SLOT(hrbfnpr_projection, projection_, project),
        FIELDS_TEST_SLOT(hrbfnpr_curvature, curvature_, curvature),
        FIELDS_TEST_SLOT(hrbfnpr_cast_desc, cast_desc_, cast),
        FIELDS_TEST_SLOT(hrbfnpr_ray_hits, ray_hits_, cast),
        FIELDS_TEST_SLOT(hrbfnpr_trim_desc, trim_desc_, trim),
        FIELDS_TEST_SLOT(hrbfnpr_layer_desc, layer_desc_[0], generate),
        FIELDS_TEST_SLOT(hrbfnpr_layer_desc, layer_desc_[1], generate),
        FIELDS_TEST_SLOT(hrbfnpr_generate_desc, generate_desc_, generate),
        FIELDS_TEST_SLOT(hrbfnpr_layer_arrays, layer_arrays_, create_point_set),
        FIELDS_TEST_SLOT(hrbfnpr_point_set_desc, point_set_desc_, create_point_set),
        FIELDS_TEST_SLOT(hrbfnpr_field_desc, field_desc_[0], create_field),
        FIELDS_TEST_SLOT(hrbfnpr_field_desc, field_desc_[1], create_field),
        FIELDS_TEST_SLOT(hrbfnpr_mark_field, mark_field_, give_field),
        FIELDS_TEST_SLOT(hrbfnpr_line_desc, line_desc_[0], create_line_set),
        FIELDS_TEST_SLOT(hrbfnpr_line_desc, line_desc_[1], create_line_set),
        FIELDS_TEST_SLOT(hrbfnpr_line_set_desc, line_set_desc_, create_line_set),
        FIELDS_TEST_SLOT(hrbfnpr_camera, camera_, draw),
        FIELDS_TEST_SLOT(hrbfnpr_layer_style, layer_style_, draw),
        FIELDS_TEST_SLOT(hrbfnpr_line_style, line_style_[0], draw),
        FIELDS_TEST_SLOT(hrbfnpr_line_style, line_style_[1], draw),
        FIELDS_TEST_SLOT(hrbfnpr_light, light_[0], shade),
        FIELDS_TEST_SLOT(hrbfnpr_light, light_[1], draw),
        FIELDS_TEST_SLOT(hrbfnpr_style, style_, draw),
        FIELDS_TEST_SLOT(hrbfnpr_layer_pose, pose_, draw_posed),
        FIELDS_TEST_SLOT(hrbfnpr_item, item_, draw),
        FIELDS_TEST_SLOT(hrbfnpr_item, posed_item_, draw_posed),
        FIELDS_TEST_SLOT(hrbfnpr_item, shaded_item_, shade),
        FIELDS_TEST_SLOT(hrbfnpr_shading_desc, shading_desc_, shade),
        FIELDS_TEST_SLOT(hrbfnpr_image, image_, rasterize),
        FIELDS_TEST_SLOT(hrbfnpr_raster_desc, raster_desc_, rasterize),
        FIELDS_TEST_SLOT(hrbfnpr_vertex_attribute, vertex_attribute_, write_vertices),
        FIELDS_TEST_SLOT(hrbfnpr_vertex_layout, vertex_layout_, write_vertices),
        FIELDS_TEST_SLOT(hrbfnpr_mark_results, mark_results_, mark_results),
        FIELDS_TEST_SLOT(hrbfnpr_mesh_desc, mesh_desc_, create_mesh),
        FIELDS_TEST_SLOT(hrbfnpr_sample_desc, sample_desc_, sample_mesh),
        FIELDS_TEST_SLOT(hrbfnpr_mesh_edges_desc, mesh_edges_desc_, find_mesh_edges),
        FIELDS_TEST_SLOT(hrbfnpr_compare_desc, compare_desc_, compare_mesh),
        FIELDS_TEST_SLOT(hrbfnpr_mesh_fit_desc, mesh_fit_desc_, fit_mesh),
        FIELDS_TEST_SLOT(hrbfnpr_page_item, page_item_, write_page),
        FIELDS_TEST_SLOT(hrbfnpr_pen, pen_, write_page),
        FIELDS_TEST_SLOT(hrbfnpr_annotation, annotation_, write_page),
        FIELDS_TEST_SLOT(hrbfnpr_page_desc, page_desc_, write_page),
        FIELDS_TEST_SLOT(hrbfnpr_source_field, source_field_, make_picture),
        FIELDS_TEST_SLOT(hrbfnpr_picture_source, source_, make_picture),
        FIELDS_TEST_SLOT(hrbfnpr_change, change_, make_picture),
        FIELDS_TEST_SLOT(hrbfnpr_dab, dab_, make_picture),
        FIELDS_TEST_SLOT(hrbfnpr_picture_desc, picture_desc_, make_picture),
        FIELDS_TEST_SLOT(hrbfnpr_picture_page_desc, picture_page_desc_, write_picture),
        FIELDS_TEST_SLOT(hrbfnpr_views_desc, views_desc_, write_views),
#undef FIELDS_TEST_SLOT
    };
}

} // namespace fields_test

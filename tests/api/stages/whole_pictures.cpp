// SPDX-License-Identifier: MIT
// Stages of pictures: from sources to drawings in one call, and the outputs.
#include "stages/stages.h"

#include <array>
#include <cstring>

namespace api_test {
namespace {

constexpr std::int64_t most_refusals = 8; // for stages that ask for memory thousands of times

// The memory is allocated before the call, so that no request within the call is the test's own.
struct Sink {
    std::vector<char> room = std::vector<char>(std::size_t{4} << 20);
    std::size_t used = 0;

    static std::int32_t write(void* user, const void* data, std::uint64_t size) {
        auto& self = *static_cast<Sink*>(user);
        if (self.used + size > self.room.size()) return 1;
        std::memcpy(self.room.data() + self.used, data, size);
        self.used += size;
        return 0;
    }
    void append_to(Bytes& bytes) {
        room.resize(used);
        append(bytes, room);
    }
};

// Draws a picture and appends its plate.
hrbfnpr_status draw(Attempt& attempt, hrbfnpr_picture* picture, hrbfnpr_operation* operation, Bytes& bytes,
                    hrbfnpr_error* error) {
    hrbfnpr_drawing* drawing = nullptr;
    auto status = attempt([&] { return hrbfnpr_picture_draw(picture, nullptr, operation, &drawing, error); });
    EXPECT_EQ(drawing != nullptr, status == HRBFNPR_STATUS_OK);
    const Drawing owned(drawing);
    if (status != HRBFNPR_STATUS_OK) return status;
    std::int32_t width = 0, height = 0;
    status = attempt([&] { return hrbfnpr_picture_plate_size(picture, nullptr, &width, &height, error); });
    if (status != HRBFNPR_STATUS_OK) return status;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * width * height));
    auto image = made(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = width;
    image.height = height;
    image.pixels = pixels.data();
    status = attempt([&] { return hrbfnpr_picture_rasterize(picture, drawing, nullptr, &image, error); });
    if (status == HRBFNPR_STATUS_OK) append(bytes, pixels);
    return status;
}

} // namespace

hrbfnpr_picture_desc Stages::picture_desc() const {
    auto desc = made(hrbfnpr_picture_desc_init);
    desc.flags = HRBFNPR_PICTURE_ALLOW_BLANK;
    desc.width = desc.height = sizes_.pixels;
    desc.changes = changes_.data();
    desc.change_count = static_cast<std::int64_t>(changes_.size());
    return desc;
}

void Stages::add_picture(std::vector<Stage>& stages, const char* name, const hrbfnpr_picture_source& source,
                         std::uint32_t preset, const char* uses) {
    add(stages, name, [this, source, preset, uses](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto desc = picture_desc();
        std::array<hrbfnpr_change, 4> changes{changes_[0], changes_[1], changes_[2], made(hrbfnpr_change_init)};
        changes[3].field = "style.field";
        changes[3].value = uses;
        desc.changes = changes.data();
        desc.change_count = static_cast<std::int64_t>(changes.size());
        desc.sources = &source;
        desc.source_count = 1;
        desc.preset = preset;
        hrbfnpr_picture* picture = nullptr;
        const auto status =
            attempt([&] { return hrbfnpr_picture_create(context_.get(), &desc, attempt.operation, &picture, error); });
        EXPECT_EQ(picture != nullptr, status == HRBFNPR_STATUS_OK);
        const Picture owned(picture);
        return status == HRBFNPR_STATUS_OK ? draw(attempt, picture, nullptr, bytes, error) : status;
    }).most_refusals = most_refusals;
}

void Stages::add_pictures(std::vector<Stage>& stages) {
    constexpr std::array<std::pair<const char*, const char*>, 3> given{
        {{"marks.layers.budget", "40"}, {"style.halo_width", "1.5"}, {"style.ink", "#203040"}}};
    for (std::size_t i = 0; i < given.size(); ++i) {
        changes_[i] = made(hrbfnpr_change_init);
        changes_[i].field = given[i].first;
        changes_[i].value = given[i].second;
    }
    auto points = made(hrbfnpr_picture_source_init);
    points.points = in(samples_.points);
    points.normals = in(samples_.normals);
    add_picture(stages, "picture.points", points, HRBFNPR_PRESET_CONTOUR_AND_STIPPLE);
    add_picture(stages, "picture.plate", points, HRBFNPR_PRESET_ARCHAEOLOGICAL);
    auto valued = points;
    field_ = made(hrbfnpr_source_field_init);
    field_.name = "x";
    field_.values = in(samples_.points);
    field_.values.components = 1;
    field_.values.stride = 3 * std::int64_t{sizeof(double)};
    valued.fields = &field_;
    valued.field_count = 1;
    add_picture(stages, "picture.fields", valued, HRBFNPR_PRESET_STIPPLE, "tone=x,mask=-x");
    auto bare = made(hrbfnpr_picture_source_init);
    bare.points = in(dense_.points);
    add_picture(stages, "picture.no_normals", bare, HRBFNPR_PRESET_STIPPLE);
    auto mesh = made(hrbfnpr_picture_source_init);
    mesh.points = in(triangles_.vertices);
    mesh.triangles = {triangles_.triangles.data(), static_cast<std::int64_t>(triangles_.faces()), 0,
                      HRBFNPR_SCALAR_INT32, 3};
    add_picture(stages, "picture.mesh", mesh, HRBFNPR_PRESET_ENGRAVING);
    auto model = made(hrbfnpr_picture_source_init);
    model.model = model_.get();
    add_picture(stages, "picture.model", model, HRBFNPR_PRESET_HATCH);
    auto marks = made(hrbfnpr_picture_source_init);
    marks.point_set = set_.get();
    add_picture(stages, "picture.marks", marks, HRBFNPR_PRESET_STIPPLE);

    const std::array<std::pair<const char*, hrbfnpr_picture_source>, 3> inspected{
        {{"picture.inspected_points", points}, {"picture.inspected_bare", bare}, {"picture.inspected_mesh", mesh}}};
    for (const auto& each : inspected)
        add(stages, each.first, [this, source = each.second](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
            auto info = made(hrbfnpr_source_info_init);
            const auto status = attempt([&] {
                return hrbfnpr_source_inspect(context_.get(), &source, HRBFNPR_WORDING_FIELDS, nullptr, nullptr,
                                              attempt.operation, &info, error);
            });
            if (status == HRBFNPR_STATUS_OK) append_value(bytes, info);
            return status;
        }).most_refusals = most_refusals;

    {
        Error error;
        auto desc = picture_desc();
        desc.sources = &points;
        desc.source_count = 1;
        hrbfnpr_picture* picture = nullptr;
        hrbfnpr_drawing* drawing = nullptr;
        EXPECT_OK(hrbfnpr_picture_create(context_.get(), &desc, nullptr, &picture, error));
        picture_.reset(picture);
        EXPECT_OK(hrbfnpr_picture_draw(picture, nullptr, nullptr, &drawing, error));
        picture_drawing_.reset(drawing);
    }
    add(stages, "picture.restyled", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto restyle = picture_desc();
        restyle.style_name = "etching";
        hrbfnpr_picture* other = nullptr;
        const auto status = attempt(
            [&] { return hrbfnpr_picture_restyle(picture_.get(), &restyle, attempt.operation, &other, error); });
        EXPECT_EQ(other != nullptr, status == HRBFNPR_STATUS_OK);
        const Picture owned(other);
        return status == HRBFNPR_STATUS_OK ? draw(attempt, other, nullptr, bytes, error) : status;
    }).most_refusals = most_refusals;
    add(stages, "picture.drawn", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        return draw(attempt, picture_.get(), attempt.operation, bytes, error);
    }).most_refusals = most_refusals;
    add(stages, "picture.page", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto page = made(hrbfnpr_picture_page_desc_init);
        page.paper = "a6";
        const std::array<double, 2> widths{0.2, 0.5};
        page.pen_widths = {widths.data(), 2, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        Sink sink;
        const auto status = attempt([&] {
            return hrbfnpr_picture_write(picture_.get(), picture_drawing_.get(), nullptr, &page, Sink::write, &sink,
                                         nullptr, attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) sink.append_to(bytes);
        return status;
    }).most_refusals = most_refusals;
    add(stages, "picture.views", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto views = made(hrbfnpr_views_desc_init);
        views.sections = "z";
        views.model = "stage";
        Sink sink;
        const auto status = attempt([&] {
            return hrbfnpr_picture_write_views(picture_.get(), &views, Sink::write, &sink, nullptr, attempt.operation,
                                               error);
        });
        if (status == HRBFNPR_STATUS_OK) sink.append_to(bytes);
        return status;
    }).most_refusals = most_refusals;
    add(stages, "picture.settings", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        Sink sink;
        const auto status =
            attempt([&] { return hrbfnpr_picture_write_settings(picture_.get(), Sink::write, &sink, error); });
        if (status == HRBFNPR_STATUS_OK) sink.append_to(bytes);
        return status;
    });
}

} // namespace api_test

// SPDX-License-Identifier: MIT
// Implements the descriptor of a picture: its defaults, its checks, and the values that come from settings.
#include "api/dabs.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/lists.h"
#include "api/presets.h"
#include "api/views.h"
#include "base/assert.h"
#include "base/utf8.h"
#include "picture/call.h"
#include "picture/settings_keys.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <numbers>

namespace hrbfnpr::api {
namespace {

using PictureDesc = hrbfnpr_picture_desc;
constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
constexpr double largest_number = 1e300; // Larger lengths and coordinates are refused.

// Accepts NaN, which asks for an automatic choice, and the values that a rule accepts.
template <class Rule>
struct OrNan {
    Rule rule;
    void operator()(const Checks& checks, const char* field, double value) const {
        if (!std::isnan(value)) rule(checks, field, value);
    }
};
template <class Rule>
OrNan(Rule) -> OrNan<Rule>;

// Accepts 0, which asks for an automatic choice, and the values in a range.
struct OrZero {
    double low, high;
    void operator()(const Checks& checks, const char* field, double value) const {
        if (value != 0.0) checks.between(field, value, low, high);
    }
};

constexpr rule::Between any_number{-largest_number, largest_number};

constexpr auto picture_fields() noexcept {
    using D = PictureDesc;
    return FieldTable{
        field("flags", &D::flags, rule::Flags{2 * HRBFNPR_PICTURE_VERIFY - 1}),
        field("sources", &D::sources, rule::Any{}),
        field("source_count", &D::source_count, rule::Any{}),
        field("source_stride", &D::source_stride, rule::Any{}),
        field("preset", &D::preset, rule::KnownPreset{}),
        field("wording", &D::wording, rule::OneOf{HRBFNPR_WORDING_ARGUMENTS, "HRBFNPR_WORDING_*"}),
        field("style_name", &D::style_name, rule::Any{}),
        field("style", &D::style, rule::Any{}),
        field("settings", &D::settings, rule::Any{}),
        field("changes", &D::changes, rule::Any{}),
        field("change_count", &D::change_count, rule::Any{}),
        field("change_stride", &D::change_stride, rule::Any{}),
        field("dabs", &D::dabs, rule::Any{}),
        field("dab_count", &D::dab_count, rule::Any{}),
        field("dab_stride", &D::dab_stride, rule::Any{}),
        field("width", &D::width, rule::Between{0.0, picture::largest_settings_side}),
        field("height", &D::height, rule::Between{0.0, picture::largest_settings_side}),
        field("size", &D::size, rule::Between{0.0, picture::largest_settings_side}),
        field("sides", &D::sides, rule::OneOf{HRBFNPR_PICTURE_SIDES_BOTH, "HRBFNPR_PICTURE_SIDES_*"}),
        field("pen", &D::pen, OrZero{1e-6, 1e6}),
        field("line_width", &D::line_width, OrZero{1e-6, 1e6}),
        field("camera", &D::camera, rule::Any{}),
        field("up", &D::up, rule::IndexedNumbers{any_number}),
        field("azimuth", &D::azimuth, OrNan{any_number}),
        field("elevation", &D::elevation, OrNan{any_number}),
        field("direction", &D::direction, rule::IndexedNumbers{any_number}),
        field("eye", &D::eye, rule::IndexedNumbers{OrNan{any_number}}),
        field("target", &D::target, rule::IndexedNumbers{OrNan{any_number}}),
        field("fov", &D::fov, OrNan{OrZero{0.01, 179.0}}),
        field("margin", &D::margin, OrNan{rule::Between{0.0, 0.45}}),
        field("turn", &D::turn, any_number),
        field("turn_frames", &D::turn_frames, rule::Between{1.0, 1e6}),
        field("normals", &D::normals, rule::OneOf{HRBFNPR_NORMALS_AUTO, "HRBFNPR_NORMALS_*"}),
        field("samples", &D::samples, rule::Between{0.0, 1e9}),
        field("tolerance", &D::tolerance, rule::not_negative),
        field("maximum_centres", &D::maximum_centres, rule::not_negative),
        field("parts", &D::parts, rule::OneOf{HRBFNPR_PARTS_AUTO, "HRBFNPR_PARTS_*"}),
        field("edges", &D::edges, rule::OneOf{HRBFNPR_PICTURE_EDGES_SHARP, "HRBFNPR_PICTURE_EDGES_*"}),
        field("edge_angle", &D::edge_angle, rule::Between{5.0, 175.0}),
        field("crease_angle", &D::crease_angle, OrNan{rule::Between{0.0, 180.0}}),
        field("subdivide", &D::subdivide, rule::Between{-1.0, 6.0}),
        field("profile", &D::profile, rule::OneOf{HRBFNPR_PROFILE_NO, "HRBFNPR_PROFILE_*"}),
        field("viewpoint", &D::viewpoint, rule::IndexedNumbers{OrNan{any_number}}),
        field("depth_smoothing", &D::depth_smoothing, OrNan{rule::Between{0.0, 100.0}}),
        field("random_seed", &D::random_seed, rule::Any{}),
        field("mark_kinds", &D::mark_kinds, rule::Any{}),
        field("seed_points", &D::seed_points, rule::Any{}),
        field("hatch_angle", &D::hatch_angle, rule::Between{-360.0, 360.0}),
        field("lines", &D::lines, rule::Any{}),
        field("scale_bar", &D::scale_bar, rule::Any{}),
        field("on_event", &D::on_event, rule::Any{}),
        field("event_user", &D::event_user, rule::Any{}),
        field("ground", &D::ground, rule::OneOf{HRBFNPR_PICTURE_GROUND_HEIGHT, "HRBFNPR_PICTURE_GROUND_*"}),
        reserved("reserved", &D::reserved),
        field("ground_height", &D::ground_height, any_number)};
}
static_assert(picture_fields().covers<PictureDesc>());

} // namespace

template <>
hrbfnpr_picture_desc defaults() noexcept {
    hrbfnpr_picture_desc desc{};
    desc.preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    desc.azimuth = desc.elevation = desc.fov = desc.margin = not_given;
    desc.crease_angle = desc.depth_smoothing = not_given;
    for (int axis = 0; axis < 3; ++axis) desc.eye[axis] = desc.target[axis] = desc.viewpoint[axis] = not_given;
    desc.turn_frames = 36;
    desc.normals = HRBFNPR_NORMALS_AUTO;
    desc.parts = HRBFNPR_PARTS_AUTO;
    desc.edge_angle = 30.0;
    desc.subdivide = -1;
    desc.random_seed = 1;
    return desc;
}

template <>
hrbfnpr_picture_source defaults() noexcept {
    return {};
}

template <>
hrbfnpr_change defaults() noexcept {
    return {};
}

} // namespace hrbfnpr::api

namespace hrbfnpr::picture {
namespace {

constexpr std::size_t longest_text = 4096;

void check_desc(const hrbfnpr_picture_desc& desc) {
    api::picture_fields().check("picture_desc", desc);
    if ((desc.width == 0) != (desc.height == 0))
        fail(Status::invalid_argument, "picture_desc.width is %d and height is %d; give both, or size alone",
             static_cast<int>(desc.width), static_cast<int>(desc.height));
}

// Checks a direction. A vector of zeros asks for an automatic choice.
void check_direction(const double (&given)[3], const char* field) {
    const double length = glm::length(glm::dvec3(given[0], given[1], given[2]));
    if ((given[0] == 0.0 && given[1] == 0.0 && given[2] == 0.0) || (length > 1e-100 && length < 1e100)) return;
    fail(Status::invalid_argument, "picture_desc.%s is (%g, %g, %g); it must have a direction", field, given[0],
         given[1], given[2]);
}

void check_text(const char* text, const char* field) {
    if (text == nullptr) return;
    const std::size_t size = strnlen(text, longest_text + 1);
    if (size > longest_text)
        fail(Status::invalid_argument, "picture_desc.%s is longer than %zu bytes", field, longest_text);
    if (!base::is_utf8({text, size})) fail(Status::invalid_argument, "picture_desc.%s is not UTF-8", field);
}

std::uint32_t preset_of(const char* name) {
    String known_names; // The names are only needed for a message.
    for (std::uint32_t preset = 0;; ++preset) {
        const char* const known = hrbfnpr_preset_name(preset);
        if (known == nullptr) break;
        if (std::strcmp(known, name) == 0) return preset;
        known_names += (preset > 0 ? ", " : "");
        known_names += known;
    }
    fail(Status::invalid_argument, "picture_desc.style_name is \"%.40s\"; it must be one of %.180s", name,
         known_names.c_str());
}

// Copies a text of the caller, and replaces the pointer to it by one to the copy.
void keep_text(const char*& text, Vector<String>& texts) {
    if (text == nullptr) return;
    texts.emplace_back(text);
    text = texts.back().c_str();
}

bool gives_view(const hrbfnpr_picture_desc& desc) noexcept {
    return desc.up[0] != 0 || desc.up[1] != 0 || desc.up[2] != 0 || !std::isnan(desc.azimuth) ||
           !std::isnan(desc.elevation) || desc.direction[0] != 0 || desc.direction[1] != 0 || desc.direction[2] != 0 ||
           !std::isnan(desc.eye[0]) || !std::isnan(desc.target[0]) || !std::isnan(desc.fov) || !std::isnan(desc.margin);
}

// Sets the size of the picture. If the caller gives only the longer side, and the settings have a size, the picture has
// the aspect ratio of that size.
void set_size(hrbfnpr_picture_desc& desc, const std::array<std::int32_t, 2>& known) noexcept {
    if (desc.width > 0) return;
    const double scale =
        desc.size == 0 ? 1.0 : static_cast<double>(desc.size) / static_cast<double>(std::max(known[0], known[1]));
    const auto scaled = [&](std::int32_t side) {
        return std::max(1, static_cast<std::int32_t>(std::nearbyint(scale * static_cast<double>(side))));
    };
    desc.width = scaled(known[0]);
    desc.height = scaled(known[1]);
}

Vector<hrbfnpr_dab> dabs_of(const hrbfnpr_picture_desc& given, const Settings* settings, Pool& pool) {
    Vector<hrbfnpr_dab> dabs(&pool);
    const api::List<hrbfnpr_dab> list(given.dabs, given.dab_count, given.dab_stride, api::most_dabs,
                                      "picture_desc.dabs");
    for (std::int64_t i = 0; i < list.count(); ++i) {
        dabs.push_back(list[i]);
        api::dab_fields().check(list.name(i).text, dabs.back());
    }
    if (dabs.empty() && settings != nullptr) dabs = settings->dabs;
    return dabs;
}

Points points_of(const hrbfnpr_array& array, const char* name, Pool& pool) {
    const base::InView view = api::in_view(array, name, api::points_type);
    Points points(&pool);
    points.reserve(static_cast<std::size_t>(view.count));
    for (std::int64_t i = 0; i < view.count; ++i) points.emplace_back(view.get(i, 0), view.get(i, 1), view.get(i, 2));
    return points;
}

Changes changes_of(const hrbfnpr_picture_desc& given, const Settings* settings, Pool& pool) {
    if (settings == nullptr) return {given.changes, given.change_count, given.change_stride, pool};
    return {settings->fields, given.changes, given.change_count, given.change_stride, pool};
}

} // namespace

Options::Options(const hrbfnpr_picture_desc& given, std::shared_ptr<const Settings> of_file, Pool& pool)
    : desc(given), settings(std::move(of_file)), changes(changes_of(given, settings.get(), pool)),
      dabs(dabs_of(given, settings.get(), pool)), seed_points(points_of(given.seed_points, "seed_points", pool)),
      texts_(&pool) {
    check_desc(desc);
    check_direction(desc.up, "up");
    check_direction(desc.direction, "direction");
    check_text(desc.style_name, "style_name");
    check_text(desc.mark_kinds, "mark_kinds");
    check_text(desc.lines, "lines");
    check_text(desc.scale_bar, "scale_bar");
    texts_.reserve(4);
    for (const char** text : {&desc.style_name, &desc.mark_kinds, &desc.lines, &desc.scale_bar})
        keep_text(*text, texts_);
    if (desc.style_name != nullptr) desc.preset = preset_of(desc.style_name);
    if (given.style != nullptr) style.emplace(api::read_struct(given.style, "picture_desc.style"), pool);
    if (given.camera != nullptr) camera = api::read_struct(given.camera, "picture_desc.camera");
    if (settings != nullptr) use_settings();
    if (const std::optional<double> mode = changes.number("fit.normal_mode");
        mode && desc.normals == HRBFNPR_NORMALS_AUTO)
        desc.normals = static_cast<std::uint32_t>(*mode);
    if (const std::optional<double> trim = changes.number("fit.trim"); trim && *trim == double{HRBFNPR_TRIM_NEVER})
        desc.flags |= HRBFNPR_PICTURE_CLOSE;
}

void Options::use_settings() {
    const bool names_style =
        style.has_value() || desc.style_name != nullptr || desc.preset != HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    if (!names_style) {
        desc.preset = settings->preset;
        takes_style_of_settings = true;
    }
    if (desc.profile == HRBFNPR_PROFILE_AUTO) desc.profile = HRBFNPR_PROFILE_NO;
    if (desc.scale_bar == nullptr) desc.scale_bar = "none";
    if (!wants_ground() && settings->has_ground) {
        desc.ground = settings->ground_height ? HRBFNPR_PICTURE_GROUND_HEIGHT : HRBFNPR_PICTURE_GROUND_LOWEST;
        desc.ground_height = settings->ground_height.value_or(0.0);
    }
    if (settings->size) set_size(desc, *settings->size);
    if (camera || gives_view(desc)) return;
    const bool sized = desc.width > 0;
    constexpr std::int32_t usual = 1600;
    const std::int32_t side = desc.size > 0 ? desc.size : usual;
    camera = settings->camera(sized ? desc.width : side, sized ? desc.height : side);
}

bool Options::gives_fit(std::string_view field) const noexcept {
    std::array<char, 48> path{"fit."};
    constexpr std::size_t room_taken = 4;
    HRBFNPR_ASSERT(room_taken + field.size() <= path.size());
    std::copy(field.begin(), field.end(), path.begin() + room_taken);
    return changes.has({path.data(), room_taken + field.size()}) ||
           (field == "regularization" && changes.has("fit.regularization_mode"));
}

} // namespace hrbfnpr::picture

extern "C" {

hrbfnpr_status hrbfnpr_picture_desc_init(hrbfnpr_picture_desc* desc, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_picture_source_init(hrbfnpr_picture_source* source, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(source, struct_size);
}

hrbfnpr_status hrbfnpr_change_init(hrbfnpr_change* change, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(change, struct_size);
}

} // extern "C"

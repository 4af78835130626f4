// SPDX-License-Identifier: MIT
#include "picture/page.h"

#include "api/fields.h"
#include "api/lists.h"
#include "api/views.h"
#include "base/assert.h"
#include "picture/field_table.h"
#include "picture/json.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace hrbfnpr::api {
namespace {

constexpr double largest_paper = 1e6; // The largest width and height of a page, in mm.

constexpr auto picture_page_fields() noexcept {
    using D = hrbfnpr_picture_page_desc;
    return FieldTable{reserved("reserved", &D::reserved), field("page", &D::page, rule::Any{}),
                      field("paper", &D::paper, rule::Any{}),
                      field("paper_margin", &D::paper_margin, rule::Between{-largest_paper, largest_paper}),
                      field("pen_widths", &D::pen_widths, rule::Any{})};
}
static_assert(picture_page_fields().covers<hrbfnpr_picture_page_desc>());

} // namespace

} // namespace hrbfnpr::api

namespace hrbfnpr::picture {

// ---- Strokes and dots of a drawing

namespace {

hrbfnpr_vertex_attribute attribute_of_point(std::uint32_t attribute, std::uint32_t scalar, std::size_t offset) {
    auto made = picture::defaults<hrbfnpr_vertex_attribute>(hrbfnpr_vertex_attribute_init);
    made.attribute = attribute;
    made.scalar = scalar;
    made.offset = static_cast<std::uint32_t>(offset);
    return made;
}

Vector<DrawnPoint> read_points(const hrbfnpr_drawing& drawing, std::uint32_t primitive, Vector<std::uint32_t>& indices,
                               Pool& pool) {
    const std::array attributes{
        attribute_of_point(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(DrawnPoint, x)),
        attribute_of_point(HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, offsetof(DrawnPoint, radius)),
        attribute_of_point(HRBFNPR_VERTEX_ATTRIBUTE_LAYER, HRBFNPR_SCALAR_UINT32, offsetof(DrawnPoint, layer))};
    auto layout = picture::defaults<hrbfnpr_vertex_layout>(hrbfnpr_vertex_layout_init);
    layout.primitive = primitive;
    layout.attributes = attributes.data();
    layout.attribute_count = static_cast<std::int64_t>(attributes.size());
    layout.stride = sizeof(DrawnPoint);
    std::int64_t point_count = 0;
    std::int64_t index_count = 0;
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_drawing_vertex_bound(&drawing, primitive, &point_count, &index_count, error);
    });
    Vector<DrawnPoint> points(static_cast<std::size_t>(point_count), &pool);
    indices.resize(static_cast<std::size_t>(index_count));
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_drawing_write_vertices(&drawing, &layout, points.data(), point_count, &point_count,
                                              indices.data(), index_count, &index_count, error);
    });
    points.resize(static_cast<std::size_t>(point_count));
    indices.resize(static_cast<std::size_t>(index_count));
    return points;
}

Vector<hrbfnpr_drawing_layer_info> layers_of_drawing(const hrbfnpr_drawing& drawing, Pool& pool) {
    auto info = picture::defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_info(&drawing, &info, error); });
    Vector<hrbfnpr_drawing_layer_info> layers(&pool);
    for (std::int64_t i = 0; i < info.layers; ++i) {
        layers.push_back(picture::defaults<hrbfnpr_drawing_layer_info>(hrbfnpr_drawing_layer_info_init));
        call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_layer_info(&drawing, i, &layers.back(), error); });
    }
    return layers;
}

} // namespace

DrawnStrokes drawn_strokes(const hrbfnpr_drawing& drawing, Pool& pool) {
    Vector<std::uint32_t> indices(&pool);
    const Vector<DrawnPoint> points = read_points(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS, indices, pool);
    DrawnStrokes strokes{Vector<DrawnPoint>(&pool), Vector<std::size_t>(&pool)};
    strokes.points.reserve(points.size());
    strokes.first.push_back(0);
    for (const std::uint32_t index : indices) {
        if (index != static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART))
            strokes.points.push_back(points[index]);
        else if (strokes.points.size() > strokes.first.back())
            strokes.first.push_back(strokes.points.size());
    }
    return strokes;
}

Vector<DrawnPoint> drawn_dots(const hrbfnpr_drawing& drawing, Pool& pool) {
    Vector<std::uint32_t> indices(&pool);
    return read_points(drawing, HRBFNPR_PRIMITIVE_POINTS, indices, pool);
}

// ---- Content

glm::ivec2 size_of_image(const hrbfnpr_camera& camera) {
    const glm::dvec2 size(std::ceil(camera.viewport[0] + camera.viewport[2]),
                          std::ceil(camera.viewport[1] + camera.viewport[3]));
    constexpr double largest = 1e9;
    if (!(size.x >= 0.0 && size.y >= 0.0 && size.x <= largest && size.y <= largest))
        fail(Status::invalid_argument, "the camera's viewport reaches to %g, %g; that is no size of an image", size.x,
             size.y);
    return {static_cast<int>(size.x), static_cast<int>(size.y)};
}

PageContent page_of(const Drawing& drawing, const hrbfnpr_camera& camera, Pool& pool) {
    PageContent content(pool);
    content.drawings.push_back({drawing});
    content.size = glm::dvec2(size_of_image(camera));
    return content;
}

// ---- Metadata

namespace {

void add_numbers(JsonDocument& json, const double* numbers, int count, int stride) {
    json.begin(JsonKind::list);
    for (int i = 0; i < count; ++i) json.add_number(numbers[i * stride]);
    json.end();
}

// Adds a column-major matrix to a JSON document, as a list of its rows.
void add_matrix(JsonDocument& json, const double (&matrix)[16]) {
    json.begin(JsonKind::list);
    for (int row = 0; row < 4; ++row) add_numbers(json, matrix + row, 4, 4);
    json.end();
}

void add_count(JsonDocument& json, std::int64_t count) {
    HRBFNPR_ASSERT(count >= 0);
    json.add_whole(false, static_cast<std::uint64_t>(count));
}

constexpr std::array<const char*, 5> kernel_names{"triharmonic", "gaussian", "wendland_c2", "custom", "csg"};
static_assert(kernel_names.size() == HRBFNPR_KERNEL_CSG + 1);

void add_models(JsonDocument& json, std::span<const Model> models) {
    std::int64_t centres = 0;
    std::int64_t samples = 0;
    std::uint32_t kernel = 0; // the kernel of the first model
    for (std::size_t i = 0; i < models.size(); ++i) {
        auto info = picture::defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
        call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_info(models[i].get(), &info, error); });
        centres += info.centres;
        samples += info.samples;
        if (i == 0) kernel = info.kernel;
    }
    HRBFNPR_ASSERT(kernel < kernel_names.size());
    json.begin(JsonKind::object);
    add_count(json.key("centres"), centres);
    json.key("kernel").add_text(kernel_names[kernel]);
    add_count(json.key("samples"), samples);
    json.end();
}

} // namespace

String page_metadata(std::string_view input, std::string_view style, std::span<const Model> models, std::int64_t marks,
                     const hrbfnpr_camera& camera, Pool& pool) {
    JsonDocument json(pool);
    json.begin(JsonKind::object);
    json.key("input").add_text(input);
    json.key("style").add_text(style);
    if (!models.empty()) add_models(json.key("model"), models);
    add_count(json.key("marks"), marks);
    json.key("camera").begin(JsonKind::object);
    add_matrix(json.key("view"), camera.view);
    add_matrix(json.key("projection"), camera.projection);
    add_numbers(json.key("viewport"), camera.viewport, 4, 1);
    json.end();
    json.end();
    String line(&pool);
    json.write_line(line, 0);
    return line;
}

// ---- Paper

namespace {

struct Paper {
    char name[8];         // The text is in an array, because a table of pointers would need relocation.
    double width, height; // in mm, in portrait format
};
constexpr std::array<Paper, 10> papers{Paper{"a0", 841.0, 1189.0},   Paper{"a1", 594.0, 841.0},
                                       Paper{"a2", 420.0, 594.0},    Paper{"a3", 297.0, 420.0},
                                       Paper{"a4", 210.0, 297.0},    Paper{"a5", 148.0, 210.0},
                                       Paper{"a6", 105.0, 148.0},    Paper{"letter", 215.9, 279.4},
                                       Paper{"legal", 215.9, 355.6}, Paper{"tabloid", 279.4, 431.8}};

constexpr double pixel_mm = 25.4 / 96.0; // The size of a pixel in mm, as CSS defines it.
constexpr double largest_side_mm = 1e6;

std::string_view without_blanks(std::string_view text) noexcept {
    const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// Returns the number in a text, or NaN if the text is not a number.
double number_of_text(std::string_view text) noexcept {
    return parse_number(without_blanks(text)).value_or(std::numeric_limits<double>::quiet_NaN());
}

// The position of the content on a page.
struct PagePlacement {
    glm::dvec2 corner; // in mm
    double scale;      // mm on the page per pixel
    glm::dvec2 page;   // the size in mm
};

PagePlacement placed_on_paper(const glm::dvec2& size, const hrbfnpr_picture_page_desc& desc, const Report& report) {
    if (desc.paper == nullptr) return {glm::dvec2(0.0), pixel_mm, pixel_mm * size};
    glm::dvec2 page = paper_size(desc.paper, report);
    if ((page.x > page.y) != (size.x > size.y)) std::swap(page.x, page.y);
    const double margin = desc.paper_margin;
    const glm::dvec2 room = page - 2.0 * margin;
    if (margin < 0.0 || !(std::min(room.x, room.y) > 0.0))
        report.refuse(formatted(report.pool(),
                                "{page_margin=%g} must be at least 0, and leave room on a page of %g x %g mm", margin,
                                page.x, page.y));
    const double scale = std::min(room.x / size.x, room.y / size.y);
    return {(page - scale * size) / 2.0, scale, page};
}

} // namespace

glm::dvec2 paper_size(std::string_view name, const Report& report) {
    String lower(name, &report.pool());
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Paper& paper : papers)
        if (lower == paper.name) return {paper.width, paper.height};
    const std::size_t cross = lower.find('x');
    const std::string_view text = lower;
    const auto side = [&](std::string_view part) { return number_of_text(part); };
    if (cross != std::string_view::npos) {
        const glm::dvec2 size(side(text.substr(0, cross)), side(text.substr(cross + 1)));
        if (size.x > 0.0 && size.y > 0.0 && size.x < largest_side_mm && size.y < largest_side_mm) return size;
    }
    String names(&report.pool());
    for (const Paper& paper : papers) (names += paper.name) += ", ";
    constexpr int longest_name = 40;
    report.refuse(formatted(report.pool(), "{page} must be one of %sor WIDTHxHEIGHT in mm, such as 210x297, not '%.*s'",
                            names.c_str(), std::min(longest_name, static_cast<int>(name.size())), name.data()));
}

// ---- Pens

namespace {

// The widths in mm with which the layers of one group are drawn.
struct GroupWidths {
    String group; // The prefix that the names of these layers have in common.
    bool is_lines;
    Vector<float> widths;

    [[nodiscard]] const char* what() const noexcept { return is_lines ? "lines" : "dots"; }
};

constexpr std::array<const char*, 17> line_kind_groups{
    "",          "contour",    "suggestive", "ridge",        "valley",      "apparent ridge",
    "parabolic", "isophote",   "section",    "border",       "own",         "crease",
    "shadow",    "terminator", "soft edge",  "intersection", "tangent edge"};
static_assert(line_kind_groups.size() == HRBFNPR_LINE_KIND_TANGENT_EDGE + 1);

String group_of_layer(const hrbfnpr_drawing_layer_info& layer, Pool& pool) {
    String group(layer.name, &pool);
    if (layer.layer >= 0) {
        if (layer.mark_class == HRBFNPR_CLASS_SILHOUETTE) group += " contour";
        return group;
    }
    HRBFNPR_ASSERT(layer.kind < line_kind_groups.size());
    if (group.empty() || layer.kind != HRBFNPR_LINE_KIND_OWN) group = line_kind_groups[layer.kind];
    return group;
}

Vector<float>& widths_of_group(Vector<GroupWidths>& groups, String name, bool is_lines, Pool& pool) {
    for (GroupWidths& group : groups)
        if (group.is_lines == is_lines && group.group == name) return group.widths;
    groups.push_back({std::move(name), is_lines, Vector<float>(&pool)});
    return groups.back().widths;
}

void add_widths(Vector<GroupWidths>& groups, const hrbfnpr_drawing& drawing, double scale, Pool& pool) {
    const Vector<hrbfnpr_drawing_layer_info> layers = layers_of_drawing(drawing, pool);
    const DrawnStrokes strokes = drawn_strokes(drawing, pool);
    const Vector<DrawnPoint> dots = drawn_dots(drawing, pool);
    const auto factor = static_cast<float>(2.0 * scale);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto is_of_layer = [&](const DrawnPoint& point) { return point.layer == i; };
        const bool is_lines = std::any_of(strokes.points.begin(), strokes.points.end(), is_of_layer);
        const Vector<DrawnPoint>& points = is_lines ? strokes.points : dots;
        if (std::none_of(points.begin(), points.end(), is_of_layer)) continue;
        Vector<float>& widths = widths_of_group(groups, group_of_layer(layers[i], pool), is_lines, pool);
        for (const DrawnPoint& point : points)
            if (is_of_layer(point)) widths.push_back(factor * point.radius);
    }
}

// Returns the median. For an even count it is the mean of the two middle widths.
float median_width(Vector<float>& widths) {
    HRBFNPR_ASSERT(!widths.empty());
    std::sort(widths.begin(), widths.end());
    const std::size_t half = widths.size() / 2;
    return widths.size() % 2 == 1 ? widths[half] : (widths[half - 1] + widths[half]) / 2.0F;
}

// The pen for a group, and the width with which the group is drawn.
struct ChosenPen {
    String groups;
    std::size_t pen; // the index of the pen among the available widths
    const char* what;
    double drawn; // the drawn width in mm
};

// Chooses for each group the pen nearest to the median width of its lines, or diameter of its dots. Groups are sorted
// by name, because the last matching pen is used: "stipples contour" must follow "stipples".
Vector<ChosenPen> nearest_pens(const PageContent& content, double scale, const base::Array<double>& at_hand,
                               Pool& pool) {
    Vector<GroupWidths> groups(&pool);
    for (const PageDrawing& one : content.drawings) add_widths(groups, *one.drawing.get(), scale, pool);
    Vector<std::size_t> order(groups.size(), &pool);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (groups[a].group != groups[b].group) return groups[a].group < groups[b].group;
        return !groups[a].is_lines && groups[b].is_lines; // For equal names, dots come before lines.
    });
    Vector<ChosenPen> chosen(&pool);
    for (const std::size_t i : order) {
        GroupWidths& group = groups[i];
        const auto width = static_cast<double>(median_width(group.widths));
        const double* const best = std::min_element(at_hand.begin(), at_hand.end(), [&](double a, double b) {
            return std::abs(a - width) < std::abs(b - width);
        });
        group.group += '*';
        chosen.push_back(
            {std::move(group.group), static_cast<std::size_t>(best - at_hand.begin()), group.what(), width});
    }
    return chosen;
}

base::Array<double> widths_at_hand(const hrbfnpr_array& given, Pool& pool) {
    constexpr unsigned float64_only = 1U << HRBFNPR_SCALAR_FLOAT64;
    base::Array<double> widths =
        api::finite_numbers(pool.memory(), given, "picture_page_desc.pen_widths", {1, float64_only});
    constexpr double widest = 1e3; // the largest width, in mm
    constexpr std::int64_t most = 255;
    if (widths.size() > most)
        fail(Status::invalid_argument, "picture_page_desc.pen_widths has %lld elements; it must have at most %lld",
             static_cast<long long>(widths.size()), static_cast<long long>(most));
    for (std::int64_t i = 0; i < widths.size(); ++i)
        if (!(widths[i] > 0.0 && widths[i] < widest) || (i > 0 && widths[i] < widths[i - 1]))
            fail(Status::invalid_argument,
                 "picture_page_desc.pen_widths[%lld] is %g; widths must be above 0, below %g, and ascend",
                 static_cast<long long>(i), widths[i], widest);
    return widths;
}

void note_pens(Report& report, const Vector<ChosenPen>& chosen, const base::Array<double>& at_hand) {
    Pool& pool = report.pool();
    String text("pens: ", &pool);
    String detail("Pens and what they draw: ", &pool);
    bool is_short = true;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        std::string_view group = chosen[i].groups;
        while (!group.empty() && group.back() == '*') group.remove_suffix(1);
        const std::string_view comma = i > 0 ? ", " : "";
        const double pen = at_hand[static_cast<std::int64_t>(chosen[i].pen)];
        ((detail += comma) += group) += formatted(pool, " %g mm (%s of %.2g mm)", pen, chosen[i].what, chosen[i].drawn);
        String longer(text, &pool);
        ((longer += comma) += short_name(group, pool)) += formatted(pool, " %g mm", pen);
        is_short = is_short && report.is_short(String(longer, &pool) += ", ...");
        if (is_short) text = longer;
    }
    report.note(HRBFNPR_NOTE_PENS, {}, is_short ? text : text += ", ...", {.detail = detail += '.'});
}

void note_plotted(Report& report, const hrbfnpr_page_info& info) {
    Pool& pool = report.pool();
    const double longest_in_seconds = 120.0; // Longer times are given in minutes.
    const bool is_long = info.seconds > longest_in_seconds;
    String text = formatted(pool, "the pen draws %.3g m and travels %.3g m in about %.3g %s", info.drawn / 1000.0,
                            info.travelled / 1000.0, std::nearbyint(is_long ? info.seconds / 60.0 : info.seconds),
                            is_long ? "min" : "s");
    if (info.dropped_paths + info.dropped_dots > 0)
        text += formatted(pool, "; too fine for it: %s",
                          info.dropped_dots == 0    ? count_of(info.dropped_paths, "line", pool).c_str()
                          : info.dropped_paths == 0 ? count_of(info.dropped_dots, "dot", pool).c_str()
                                                    : "lines and dots");
    const String detail = formatted(
        pool, "It fills %s wider than the pen by several passes, joins %s, and leaves out %s and %s as too fine.",
        count_of(info.filled_paths, "line", pool).c_str(), count_of(info.joined, "end", pool).c_str(),
        count_of(info.dropped_paths, "line", pool).c_str(), count_of(info.dropped_dots, "dot", pool).c_str());
    report.note(HRBFNPR_NOTE_PLOTTED, {info.drawn / 1000.0, info.travelled / 1000.0, info.seconds}, text,
                {.detail = detail});
}

// ---- The lists of a page

Vector<hrbfnpr_page_item> items_of_page(const PageContent& content, const PagePlacement& placed, Pool& pool) {
    Vector<hrbfnpr_page_item> items(&pool);
    for (const PageDrawing& one : content.drawings) {
        auto item = picture::defaults<hrbfnpr_page_item>(hrbfnpr_page_item_init);
        item.drawing = one.drawing.get();
        item.x = placed.corner.x + placed.scale * one.corner.x;
        item.y = placed.corner.y + placed.scale * one.corner.y;
        item.scale = placed.scale;
        item.name = one.name;
        items.push_back(item);
    }
    return items;
}

// Makes the annotations of a page. `points` receives the points of all notes in page coordinates and must outlive the
// list.
Vector<hrbfnpr_annotation> annotations_of_page(const PageContent& content, const PagePlacement& placed,
                                               Vector<glm::dvec2>& points, Pool& pool) {
    std::size_t point_count = 0;
    for (const PageNote& note : content.notes) point_count += note.points.size();
    points.reserve(point_count); // The notes point into this list, so its elements must not move later.
    Vector<hrbfnpr_annotation> annotations(&pool);
    annotations.reserve(content.notes.size());
    for (const PageNote& note : content.notes) {
        const std::size_t first = points.size();
        for (const glm::dvec2& point : note.points) points.push_back(point * placed.scale + placed.corner);
        auto annotation = picture::defaults<hrbfnpr_annotation>(hrbfnpr_annotation_init);
        annotation.group = note.group;
        annotation.text = note.text.empty() ? nullptr : note.text.c_str();
        annotation.points = {points.data() + first, static_cast<std::int64_t>(note.points.size()), 0,
                             HRBFNPR_SCALAR_FLOAT64, 2};
        annotation.width = note.width * placed.scale;
        std::copy(note.ink.begin(), note.ink.end(), annotation.ink);
        annotations.push_back(annotation);
    }
    return annotations;
}

// Lists the chosen pens, followed by the caller's pens, which override them.
Vector<hrbfnpr_pen> pens_of_page(const Vector<ChosenPen>& chosen, const base::Array<double>& at_hand,
                                 const hrbfnpr_page_desc& page, Pool& pool) {
    Vector<hrbfnpr_pen> pens(&pool);
    for (const ChosenPen& one : chosen) {
        auto pen = picture::defaults<hrbfnpr_pen>(hrbfnpr_pen_init);
        pen.groups = one.groups.c_str();
        pen.width = at_hand[static_cast<std::int64_t>(one.pen)];
        pen.number = static_cast<std::uint32_t>(one.pen) + 1;
        pens.push_back(pen);
    }
    constexpr std::int64_t most = 4096;
    const api::List<hrbfnpr_pen> given(page.pens, page.pen_count, page.pen_stride, most, "page_desc.pens");
    for (std::int64_t i = 0; i < given.count(); ++i) pens.push_back(given[i]);
    return pens;
}

} // namespace

// ---- Writing

void write_picture_page(hrbfnpr_context& context, Report& report, const PageContent& content,
                        const hrbfnpr_picture_page_desc& desc, const char* title, const char* metadata,
                        hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation) {
    Pool& pool = report.pool();
    api::picture_page_fields().check("picture_page_desc", desc);
    hrbfnpr_page_desc page = api::read_optional_struct(desc.page, "picture_page_desc.page");
    page.struct_size = sizeof page;
    if (info != nullptr) api::check_output_struct(info, "page_info");
    const base::Array<double> at_hand = widths_at_hand(desc.pen_widths, pool);

    const PagePlacement placed = placed_on_paper(content.size, desc, report);
    page.width = placed.page.x;
    page.height = placed.page.y;
    const Vector<hrbfnpr_page_item> items = items_of_page(content, placed, pool);
    Vector<glm::dvec2> points(&pool);
    const Vector<hrbfnpr_annotation> annotations = annotations_of_page(content, placed, points, pool);
    Vector<ChosenPen> chosen(&pool);
    if (!at_hand.empty()) {
        chosen = nearest_pens(content, placed.scale, at_hand, pool);
        note_pens(report, chosen, at_hand);
    }
    const Vector<hrbfnpr_pen> pens = pens_of_page(chosen, at_hand, page, pool);
    page.items = items.data();
    page.item_count = static_cast<std::int64_t>(items.size());
    page.item_stride = 0;
    page.annotations = annotations.data();
    page.annotation_count = static_cast<std::int64_t>(annotations.size());
    page.annotation_stride = 0;
    page.pens = pens.data();
    page.pen_count = static_cast<std::int64_t>(pens.size());
    page.pen_stride = 0;
    const String description = formatted(pool, "Drawn by hrbfnpr %s", hrbfnpr_version_string());
    if (page.title == nullptr) page.title = title;
    if (page.description == nullptr) page.description = description.c_str();
    if (page.metadata == nullptr) page.metadata = metadata;

    auto done = picture::defaults<hrbfnpr_page_info>(hrbfnpr_page_info_init);
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_page_write(&context, &page, write, user, &done, operation, error);
    });
    if (info != nullptr) api::write_struct(info, done);
    const bool is_plotted = (page.flags & HRBFNPR_PAGE_IN_PLOT_ORDER) != 0 || page.format == HRBFNPR_PAGE_FORMAT_HPGL ||
                            page.format == HRBFNPR_PAGE_FORMAT_GCODE;
    if (is_plotted) note_plotted(report, done);
}

} // namespace hrbfnpr::picture

// SPDX-License-Identifier: MIT
#include "picture/view_marks.h"

#include "picture/tuning_views.h"

#include <limits>
#include <numbers>

namespace hrbfnpr::picture {
namespace {

constexpr const ViewMarksTuning& drawn_as = view_marks_tuning;

struct KindOfLine {
    std::string_view name;
    double width;            // in widths of the outline, or in mm
    bool width_is_mm;        // True if `width` is in mm.
    std::uint32_t pen;       // the number of the plotter's pen
    std::uint32_t line_type; // HRBFNPR_LINE_TYPE_* [ISO 128-2]
};

constexpr std::uint32_t continuous = HRBFNPR_LINE_TYPE_CONTINUOUS;
constexpr std::uint32_t long_dashed_dotted = HRBFNPR_LINE_TYPE_LONG_DASHED_DOTTED;

// The width, pen and line type of each kind of line, indexed by SheetKind.
constexpr std::array<KindOfLine, 15> kinds_of_lines{{{"hatching", 0.5, false, 2, continuous},
                                                     {"centre lines", 0.5, false, 2, long_dashed_dotted},
                                                     {"smooth", 0.5, false, 2, continuous},
                                                     {"tangent", 0.5, false, 2, continuous},
                                                     {"hidden", 0.5, false, 2, HRBFNPR_LINE_TYPE_DASHED},
                                                     {"cutting planes", 0.5, false, 2, long_dashed_dotted},
                                                     {"outlines", 1.0, false, 1, continuous},
                                                     {"cutting ends", 1.0, false, 1, continuous},
                                                     {"frame", 0.7, true, 1, continuous},
                                                     {"title block", 0.5, false, 2, continuous},
                                                     {"projection", 1.0, false, 1, continuous},
                                                     {"projection axes", 0.5, false, 2, long_dashed_dotted},
                                                     {"scale bar", 0.5, false, 2, continuous},
                                                     {"scale fields", 0.3, true, 2, continuous},
                                                     {"texts", 0.0, false, 2, continuous}}};

const KindOfLine& kind_of(SheetKind kind) noexcept { return kinds_of_lines[static_cast<std::size_t>(kind)]; }

double width_of(const SheetContent& content, SheetKind kind) noexcept {
    const KindOfLine& how = kind_of(kind);
    return how.width_is_mm ? how.width : how.width * content.line_width;
}

std::uint32_t type_of(const SheetContent& content, SheetKind kind) noexcept {
    return kind == SheetKind::hidden && content.hidden_is_continuous ? continuous : kind_of(kind).line_type;
}

// ---- Texts

struct LetterWidth {
    char letters[12]; // The text is in an array, because a table of pointers would need relocation.
    int width;        // in thousandths of the font size
};

// The widths of the letters of Helvetica.
constexpr std::array<LetterWidth, 10> letter_widths{LetterWidth{" ,./:;ft!I", 278}, LetterWidth{"ijl'|", 222},
                                                    LetterWidth{"()r-", 333},       LetterWidth{"cksvxyz", 500},
                                                    LetterWidth{"FTZ", 611},        LetterWidth{"ABEKPSVXY", 667},
                                                    LetterWidth{"CDHNRUw", 722},    LetterWidth{"GOQ", 778},
                                                    LetterWidth{"mM", 833},         LetterWidth{"W", 944}};
constexpr int usual_letter = 556;

bool begins_letter(char byte) noexcept { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

std::size_t letter_count(std::string_view text) noexcept {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_letter));
}

void drop_letters(String& text, std::size_t count) {
    while (count > 0 && !text.empty()) {
        if (begins_letter(text.back())) --count;
        text.pop_back();
    }
}

struct FittedText {
    String text;
    double capitals;
};

// Makes a text smaller, and if necessary shortens it, until it fits.
FittedText fitted_text(std::string_view given, double room, double capitals, Pool& pool) {
    constexpr std::size_t least_letters = 4;
    FittedText fitted{String(given, &pool), 0.0};
    fitted.capitals =
        std::max(drawn_as.small_capitals,
                 std::min(capitals, capitals * room / std::max(width_of_sheet_text(given, capitals), 1e-9)));
    while (letter_count(fitted.text) > least_letters && width_of_sheet_text(fitted.text, fitted.capitals) > room) {
        drop_letters(fitted.text, 4);
        fitted.text += "...";
    }
    return fitted;
}

// ---- Shapes

std::array<glm::dvec2, 5> rectangle(const SheetBox& box) noexcept {
    return {{{box.left, box.top},
             {box.right, box.top},
             {box.right, box.bottom},
             {box.left, box.bottom},
             {box.left, box.top}}};
}

std::string_view name_of(Projection projection) noexcept { return projection == Projection::first ? "first" : "third"; }

// Draws the symbol of the projection [ISO 5456-2]: a truncated cone in two views, from its side and from its smaller
// end. The projection decides on which side the second view is.
void add_projection_symbol(SheetContent& content, const glm::dvec2& middle, Projection projection) {
    constexpr double large = 5.0; // the two radii of the cone
    constexpr double small = 2.5;
    constexpr double half = 5.0; // half the length of the cone
    constexpr double beyond = 1.5;
    constexpr std::size_t points = 73;
    const double side = projection == Projection::first ? 1.0 : -1.0;
    const double cone = middle.x - side * 8.0;
    const double end = middle.x + side * 9.0;
    std::array<glm::dvec2, 5> trapezium{
        {{-half, -small}, {half, -large}, {half, large}, {-half, small}, {-half, -small}}};
    for (glm::dvec2& p : trapezium) p += glm::dvec2(cone, middle.y);
    content.add(SheetKind::projection, trapezium);
    for (const double radius : {large, small}) {
        std::array<glm::dvec2, points> circle;
        for (std::size_t i = 0; i < points; ++i) {
            const double turn = static_cast<double>(i % (points - 1)) * (2.0 * std::numbers::pi / (points - 1));
            circle[i] = radius * glm::dvec2(std::cos(turn), std::sin(turn)) + glm::dvec2(end, middle.y);
        }
        content.add(SheetKind::projection, circle);
    }
    const auto add_axis = [&](const glm::dvec2& from, const glm::dvec2& to) {
        content.add(SheetKind::projection_axes, {from, to});
    };
    add_axis({cone - (half + beyond), middle.y}, {cone + (half + beyond), middle.y});
    add_axis({end - (large + beyond), middle.y}, {end + (large + beyond), middle.y});
    add_axis({end, middle.y - large - beyond}, {end, middle.y + large + beyond});
}

// Returns the two places where a line enters and leaves a box. If the line misses the box, both are the given point.
std::array<glm::dvec2, 2> across_box(const glm::dvec2& point, const glm::dvec2& way, const SheetBox& box) noexcept {
    constexpr double along_side = 1e-9;
    double low = -std::numeric_limits<double>::infinity();
    double high = -low;
    const auto clip = [&](double from, double to, double at, double slope) {
        if (!(std::abs(slope) > along_side)) return;
        const double a = (from - at) / slope;
        const double b = (to - at) / slope;
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    };
    clip(box.left, box.right, point.x, way.x);
    clip(box.top, box.bottom, point.y, way.y);
    if (!(low < high)) return {point, point};
    return {point + low * way, point + high * way};
}

// The line that a view shows for a plane that it sees edge-on.
struct PlaneTrace {
    glm::dvec2 point;
    glm::dvec2 way;    // the direction of the line
    glm::dvec2 normal; // the side of the line to which the normal of the plane points
};

// Returns the trace of a plane. `away` is its distance from the middle of the model.
PlaneTrace trace_of(const PlacedView& placed, const glm::dvec3& normal, double away) noexcept {
    const glm::dvec2 flat(glm::dot(normal, placed.view.right), -glm::dot(normal, placed.view.up));
    return {placed.centre + placed.scale * placed.view.factor * away * flat, {-flat.y, flat.x}, flat};
}

} // namespace

// ---- Content

SheetLayer& SheetContent::layer_of(SheetKind kind, std::string_view view) {
    const auto found = std::find_if(layers.begin(), layers.end(),
                                    [&](const SheetLayer& layer) { return layer.kind == kind && layer.view == view; });
    if (found != layers.end()) return *found;
    const auto memory = layers.get_allocator();
    layers.push_back(
        {kind, String(view, memory), Vector<PaperLine>(memory), Vector<String>(memory), Vector<double>(memory)});
    return layers.back();
}

void SheetContent::add(SheetKind kind, std::span<const glm::dvec2> line, std::string_view view) {
    HRBFNPR_ASSERT(!line.empty() && kind != SheetKind::texts);
    layer_of(kind, view).lines.emplace_back(line.begin(), line.end());
}

void SheetContent::add_text(const glm::dvec2& at, std::string_view text, double capitals, bool is_centred) {
    SheetLayer& layer = layer_of(SheetKind::texts, {});
    const double left = is_centred ? at.x - width_of_sheet_text(text, capitals) / 2.0 : at.x;
    layer.lines.emplace_back(std::size_t{1}, glm::dvec2(left, at.y));
    layer.texts.emplace_back(text);
    layer.capitals.push_back(capitals);
}

SheetAnnotations annotations_of(const SheetContent& content, Pool& pool) {
    SheetAnnotations made(pool);
    // The lists point to the names, so the list of names must not grow beyond its reserved memory.
    made.groups.reserve(content.layers.size() + kinds_of_lines.size());
    for (std::size_t kind = 0; kind < kinds_of_lines.size(); ++kind)
        for (const SheetLayer& layer : content.layers) {
            if (static_cast<std::size_t>(layer.kind) != kind) continue;
            String& group = made.groups.emplace_back(kinds_of_lines[kind].name);
            if (!layer.view.empty()) (group += ' ') += layer.view;
            for (std::size_t i = 0; i < layer.lines.size(); ++i) {
                auto& one = made.list.emplace_back(defaults<hrbfnpr_annotation>(hrbfnpr_annotation_init));
                one.points = {layer.lines[i].data(), static_cast<std::int64_t>(layer.lines[i].size()), 0,
                              HRBFNPR_SCALAR_FLOAT64, 2};
                one.group = group.c_str();
                one.line_type = type_of(content, layer.kind);
                const bool is_text = layer.kind == SheetKind::texts;
                one.width = is_text ? layer.capitals[i] : width_of(content, layer.kind);
                one.text = is_text ? layer.texts[i].c_str() : nullptr;
            }
        }
    for (std::size_t i = 0; i + 1 < kinds_of_lines.size(); ++i) { // The last kind is texts, which have no lines.
        String& group = made.groups.emplace_back(kinds_of_lines[i].name);
        group += '*';
        auto& pen = made.pens.emplace_back(defaults<hrbfnpr_pen>(hrbfnpr_pen_init));
        pen.groups = group.c_str();
        pen.width = width_of(content, static_cast<SheetKind>(i));
        pen.number = kinds_of_lines[i].pen;
        pen.line_type = type_of(content, static_cast<SheetKind>(i));
        pen.ink[3] = 1.0F;
    }
    return made;
}

double width_of_sheet_text(std::string_view text, double capitals) noexcept {
    int width = 0;
    for (const char byte : text) {
        if (!begins_letter(byte)) continue;
        const auto* known = std::find_if(letter_widths.begin(), letter_widths.end(), [&](const LetterWidth& one) {
            return std::string_view(one.letters).find(byte) != std::string_view::npos;
        });
        width += known != letter_widths.end() ? known->width : usual_letter;
    }
    return capitals / drawn_as.capital_share * static_cast<double>(width) / 1000.0;
}

// ---- Beside the views

void add_frame(SheetContent& content, const SheetPage& page) {
    content.add(SheetKind::frame, rectangle(frame_of(page)));
}

void add_title_block(SheetContent& content, const SheetPage& page, const SheetFacts& facts, Projection projection,
                     Pool& pool) {
    constexpr double wide = 100.0; // the widths of the columns in mm
    constexpr double narrow = 40.0;
    const SheetBox block = block_of(page);
    const double middle = block.top + view_layout_tuning.block_height / 2.0;
    const double second = block.left + wide;
    const double third = block.left + (wide + narrow);
    content.add(SheetKind::frame, rectangle(block));
    content.add(SheetKind::title_block, {{block.left, middle}, {second, middle}});
    content.add(SheetKind::title_block, {{third, middle}, {block.right, middle}});
    for (const double x : {second, third}) content.add(SheetKind::title_block, {{x, block.top}, {x, block.bottom}});
    const auto add_field = [&](std::string_view name, std::string_view text, const glm::dvec2& corner, double room,
                               double capitals) {
        content.add_text({corner.x + 1.5, corner.y + 3.0}, name, drawn_as.small_capitals);
        const FittedText fitted = fitted_text(text, room - 4.0, capitals, pool);
        if (!fitted.text.empty()) content.add_text({corner.x + 2.5, corner.y + 9.5}, fitted.text, fitted.capitals);
    };
    add_field("Title", facts.title, {block.left, block.top}, wide, drawn_as.large_capitals);
    add_field("Model", facts.model, {block.left, middle}, wide, drawn_as.capitals);
    add_field("Scale", facts.scale, {third, block.top}, narrow, drawn_as.capitals);
    add_field("Page, unit", facts.page, {third, middle}, narrow, drawn_as.capitals);
    String name("Projection: ", &pool);
    (name += name_of(projection)) += " angle";
    add_field(name, {}, {second, block.top}, narrow, drawn_as.capitals);
    add_projection_symbol(content, {second + 20.0, block.top + 14.5}, projection);
}

double length_of_bar(double longest) noexcept {
    HRBFNPR_ASSERT(longest > 0.0 && std::isfinite(longest));
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    for (const double step : {5.0, 2.0})
        if (step * power <= longest * (1.0 + 1e-9)) return step * power;
    return power;
}

void add_scale_bar(SheetContent& content, const SheetPage& page, double scale, Pool& pool) {
    constexpr double height = 1.5;
    // The distances of the first and the last of the lines that fill a field from the bar's upper edge, in mm.
    constexpr double first_line = 0.15;
    constexpr double last_line = 1.35;
    const double longest = drawn_as.longest_bar * view_layout_tuning.bar_width / scale;
    if (!(longest > 0.0 && std::isfinite(longest))) return;
    const SheetBox frame = frame_of(page);
    const double length = length_of_bar(longest);
    const double field = length * scale / 5.0;
    const double x = frame.left + 6.0;
    const double y = frame.bottom - 10.0;
    content.add(SheetKind::scale_bar, rectangle({x, y, x + 5.0 * field, y + height}));
    for (const double number : {0.0, 2.0, 4.0}) // Black fields are filled with lines, which plotters can draw.
        for (const double level : evenly(y + first_line, y + last_line, 6, pool))
            content.add(SheetKind::scale_fields, {{x + number * field, level}, {x + (number + 1.0) * field, level}});
    content.add_text({x, y + 5.5}, "0", drawn_as.bar_capitals, true);
    content.add_text({x + 5.0 * field, y + 5.5}, formatted(pool, "%g mm", length), drawn_as.bar_capitals, true);
}

// ---- In a view

void add_view_name(SheetContent& content, const PlacedView& placed) {
    const bool is_section = placed.view.is_section();
    String text(placed.view.name, placed.view.name.get_allocator());
    if (!is_section) {
        if (placed.view.kind == ViewName::iso) text = "isometric";
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
        text += " view";
    }
    content.add_text({(placed.box.left + placed.box.right) / 2.0, placed.box.top + drawn_as.capitals}, text,
                     is_section ? drawn_as.large_capitals : drawn_as.capitals, true);
}

void add_cutting_plane(SheetContent& content, const PlacedView& placed, const CutPlane& plane,
                       const glm::dvec3& middle) {
    const PlaneTrace trace = trace_of(placed, plane.normal, plane.place - glm::dot(plane.normal, middle));
    const auto ends = across_box(trace.point, trace.way, placed.seen.grown(drawn_as.beyond));
    content.add(SheetKind::cutting_planes, ends, placed.view.name);
    const glm::dvec2 sight = -trace.normal;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec2& tip = ends[i];
        const glm::dvec2 inward = i == 0 ? trace.way : -trace.way;
        content.add(SheetKind::cutting_ends, {tip, tip + drawn_as.thick_end * inward}, placed.view.name);
        content.add(SheetKind::cutting_ends, {tip - drawn_as.arrow * sight, tip}, placed.view.name);
        for (const double side : {-1.0, 1.0})
            content.add(SheetKind::cutting_ends,
                        {tip - drawn_as.arrow_head * sight + side * drawn_as.arrow_side * inward, tip},
                        placed.view.name);
        const glm::dvec2 letter = tip - 4.5 * inward - 0.5 * drawn_as.arrow * sight;
        content.add_text({letter.x, letter.y + drawn_as.large_capitals / 2.0}, plane.name, drawn_as.large_capitals,
                         true);
    }
}

void add_centre_line(SheetContent& content, const PlacedView& placed, const glm::dvec3& normal) {
    const PlaneTrace trace = trace_of(placed, normal, 0.0);
    content.add(SheetKind::centre_lines, across_box(trace.point, trace.way, placed.seen.grown(drawn_as.centre_beyond)),
                placed.view.name);
}

} // namespace hrbfnpr::picture

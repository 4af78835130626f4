// SPDX-License-Identifier: MIT
#include "picture/view_layout.h"

#include "base/assert.h"
#include "picture/field_table.h"
#include "picture/look.h"
#include "picture/page.h"
#include "picture/tuning_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::picture {
namespace {

constexpr const ViewLayoutTuning& on_sheet = view_layout_tuning;
constexpr std::array<std::string_view, 7> view_names{"front", "back", "left", "right", "top", "bottom", "iso"};

// ---- Texts

// Returns a text in quotes for a message.
String quoted(std::string_view text, Pool& pool) {
    String result("'", &pool);
    result += text;
    result += '\'';
    return result;
}

std::string_view trimmed(std::string_view text) noexcept {
    constexpr std::string_view blanks = " \t\n\r\f\v";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

double finite_number_in(std::string_view text, std::string_view option, const Report& report) {
    if (const std::optional<double> value = parse_number(trimmed(text))) return *value;
    String words(option, &report.pool());
    words += ": a finite number is needed, not ";
    words += quoted(text, report.pool());
    report.refuse(words);
}

String lower_case(std::string_view text, Pool& pool) {
    String result(text, &pool);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

// Reads a cut: AXIS, AXIS:PLACE or A:B:C:D for the plane A x + B y + C z = D.
AskedCut parse_cut(std::string_view text, const Report& report) {
    const Vector<std::string_view> parts = split_text(text, ':', report.pool());
    const std::string_view first = parts.front();
    const std::size_t signs = std::min(first.find_first_not_of("+-"), first.size());
    const std::string_view axis = first.substr(signs);
    if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z' && parts.size() <= 2) {
        const double sign = first.starts_with('-') ? -1.0 : 1.0;
        AskedCut cut;
        cut.normal[axis[0] - 'x'] = sign;
        if (parts.size() == 2) cut.place = sign * finite_number_in(parts[1], "{section}", report);
        cut.is_signed = signs > 0;
        return cut;
    }
    if (parts.size() == 4) {
        std::array<double, 4> numbers{};
        for (std::size_t i = 0; i < 4; ++i) numbers[i] = finite_number_in(parts[i], "{section}", report);
        const glm::dvec3 normal(numbers[0], numbers[1], numbers[2]);
        if (normal != glm::dvec3(0.0)) return {normal, numbers[3], true};
    }
    String words("{section}: ", &report.pool());
    words += quoted(text, report.pool());
    words += " is not a plane: write z:20, z for the middle, or A:B:C:D for the plane Ax + By + Cz = D";
    report.refuse(words);
}

// ---- Paper

constexpr std::array<std::string_view, 5> tried_papers{"a4", "a3", "a2", "a1", "a0"};

// Returns a named paper in landscape format.
SheetPage named_page(std::string_view name, const Report& report) {
    const glm::dvec2 upright = paper_size(name, report);
    return {String(name, &report.pool()), upright.y, upright.x};
}

SheetPage copy_of(const SheetPage& page, Pool& pool) { return {String(page.name, &pool), page.width, page.height}; }

} // namespace

Vector<std::string_view> split_text(std::string_view text, char separator, Pool& pool) {
    Vector<std::string_view> parts(&pool);
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

// ---- Requests

Vector<ViewName> parse_views(std::string_view text, const Report& report) {
    Pool& pool = report.pool();
    Vector<ViewName> names(&pool);
    for (const std::string_view part : split_text(text, ',', pool)) {
        const auto* found = std::find(view_names.begin(), view_names.end(), part);
        if (found == view_names.end()) {
            String words("{views}: there is no view ", &pool);
            words += quoted(part, pool);
            words += "; there are ";
            for (const std::string_view name : view_names) {
                if (name != view_names.front()) words += ", ";
                words += name;
            }
            report.refuse(words);
        }
        const auto name = static_cast<ViewName>(found - view_names.begin());
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

Vector<AskedCut> parse_sections(std::string_view text, const Report& report) {
    Vector<AskedCut> cuts(&report.pool());
    if (trimmed(text).empty()) return cuts;
    for (const std::string_view part : split_text(text, ';', report.pool()))
        cuts.push_back(parse_cut(trimmed(part), report));
    return cuts;
}

std::optional<SheetPage> parse_paper(std::string_view text, const Report& report) {
    Pool& pool = report.pool();
    const String name = lower_case(text, pool);
    if (name == "auto") return std::nullopt;
    const glm::dvec2 size = paper_size(text, report);
    if (name.find('x') == String::npos) return named_page(name, report);
    return SheetPage{formatted(pool, "%g x %g", size.x, size.y), size.x, size.y};
}

std::optional<SheetScale> parse_scale(std::string_view text, const Report& report) {
    Pool& pool = report.pool();
    if (text == "auto") return std::nullopt;
    const std::size_t colon = text.find(':');
    if (colon != std::string_view::npos) {
        const std::optional<double> drawn = parse_number(trimmed(text.substr(0, colon)));
        const std::optional<double> real = parse_number(trimmed(text.substr(colon + 1)));
        const double value = drawn && real && *real != 0.0 ? *drawn / *real : 0.0;
        if (std::isfinite(value) && value > 0.0) return SheetScale{String(text, &pool), value};
    }
    String words("{scale} must be auto or like 1:2, 2:1 or 1:1, not ", &pool);
    words += quoted(text, pool);
    report.refuse(words);
}

// ---- Directions

Standing standing(const glm::dvec3& up) noexcept {
    const glm::dvec3 upward = up / glm::length(up);
    const glm::dvec3 front = -direction_of_view(up, 0.0, 0.0);
    return {glm::cross(upward, front), upward, front};
}

bool SheetView::is_edge_on(const glm::dvec3& normal) const noexcept {
    return kind != ViewName::iso && std::abs(glm::dot(normal, eye)) < on_sheet.along;
}

glm::dvec3 middle_of(const Points& points, const Standing& axes) noexcept {
    HRBFNPR_ASSERT(!points.empty());
    geometry::Bounds turned;
    for (const glm::dvec3& p : points)
        turned.extend({glm::dot(p, axes.right), glm::dot(p, axes.up), glm::dot(p, axes.front)});
    const glm::dvec3 middle = (turned.min + turned.max) / 2.0;
    return middle.x * axes.right + middle.y * axes.up + middle.z * axes.front;
}

namespace {

// Returns the side from which isometric views and sections are seen.
glm::dvec3 drawn_side(std::span<const ViewName> names, const Standing& axes) noexcept {
    const auto has = [&](ViewName name) { return std::find(names.begin(), names.end(), name) != names.end(); };
    return has(ViewName::left) && !has(ViewName::right) ? -axes.right : axes.right;
}

// Returns a view from an eye direction, with up at the top. In views from above or below, the front is at the bottom or
// at the top.
SheetView view_from(ViewName kind, String name, const glm::dvec3& eye, const Standing& axes) {
    const double along = glm::dot(eye, axes.up);
    const bool is_level = std::abs(along) > 1.0 - on_sheet.along;
    glm::dvec3 up = is_level ? -std::copysign(1.0, along) * axes.front : axes.up - along * eye;
    up = up / glm::length(up);
    SheetView view{kind, std::move(name), glm::cross(up, eye), up, eye};
    // An isometric projection shortens the model's axes by this factor. The view is enlarged by it, so that the axes
    // are to scale [ISO 5456-3].
    if (kind == ViewName::iso) view.factor = std::sqrt(1.5);
    return view;
}

glm::dvec3 eye_of(ViewName name, std::span<const ViewName> names, const Standing& axes) noexcept {
    switch (name) {
    case ViewName::front: return axes.front;
    case ViewName::back: return -axes.front;
    case ViewName::left: return -axes.right;
    case ViewName::right: return axes.right;
    case ViewName::top: return axes.up;
    case ViewName::bottom: return -axes.up;
    default: return (axes.front + axes.up + drawn_side(names, axes)) / std::sqrt(3.0);
    }
}

} // namespace

Vector<CutPlane> planes_of(std::span<const AskedCut> cuts, std::span<const ViewName> names, const Standing& axes,
                           const glm::dvec3& middle, Pool& pool) {
    constexpr std::string_view letters = "ABCDEFGHJKLMNPQRSTUVWXYZ"; // Letters that look like digits are left out.
    const glm::dvec3 towards = axes.front + axes.up + drawn_side(names, axes);
    Vector<CutPlane> planes(&pool);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const double length = glm::length(cuts[i].normal);
        const glm::dvec3 normal = cuts[i].normal / length;
        const double place = cuts[i].place ? *cuts[i].place / length : glm::dot(normal, middle);
        const double turn = cuts[i].is_signed || glm::dot(normal, towards) >= 0.0 ? 1.0 : -1.0;
        String name(1 + i / letters.size(), letters[i % letters.size()], &pool);
        planes.push_back({std::move(name), turn * normal, turn * place});
    }
    return planes;
}

Vector<SheetView> views_of(std::span<const ViewName> names, const Vector<CutPlane>& planes, const Standing& axes,
                           Pool& pool) {
    Vector<SheetView> views(&pool);
    for (const ViewName name : names)
        views.push_back(view_from(name, String(view_names[static_cast<std::size_t>(name)], &pool),
                                  eye_of(name, names, axes), axes));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        String name(planes[i].name, &pool);
        (name += '-') += planes[i].name;
        views.push_back(view_from(ViewName::section, std::move(name), planes[i].normal, axes));
        views.back().plane = i;
    }
    return views;
}

// ---- Places on the sheet

SheetBox frame_of(const SheetPage& page) noexcept {
    return {on_sheet.left, on_sheet.margin, page.width - on_sheet.margin, page.height - on_sheet.margin};
}

SheetBox block_of(const SheetPage& page) noexcept {
    const SheetBox frame = frame_of(page);
    return {frame.right - on_sheet.block_width, frame.bottom - on_sheet.block_height, frame.right, frame.bottom};
}

SheetBox ViewCell::seen(double scale) const noexcept {
    const glm::dvec2 from = scale * low;
    const glm::dvec2 to = scale * high;
    return {from.x, from.y, to.x, to.y};
}

SheetBox ViewCell::box(double scale) const noexcept {
    glm::dvec2 beside(0.0);
    for (const glm::dvec3& normal : cut_normals) {
        if (std::abs(glm::dot(normal, view.up)) > on_sheet.cutting_side) beside.x = on_sheet.cutting;
        if (std::abs(glm::dot(normal, view.right)) > on_sheet.cutting_side) beside.y = on_sheet.cutting;
    }
    const SheetBox inner = seen(scale);
    SheetBox box{inner.left - beside.x, inner.top - beside.y, inner.right + beside.x, inner.bottom + beside.y};
    if (has_label) box.top = box.top - on_sheet.label;
    return box;
}

namespace {

struct TablePlace {
    int column;
    int row;
};

// The column and row of each view, indexed by ViewName, in a table with the front view in the middle [ISO 5456-2].
constexpr std::array<TablePlace, 7> first_angle{{{1, 1}, {3, 1}, {2, 1}, {0, 1}, {1, 2}, {1, 0}, {2, 2}}};
constexpr std::array<TablePlace, 7> third_angle{{{1, 1}, {3, 1}, {0, 1}, {2, 1}, {1, 0}, {1, 2}, {2, 0}}};

// Returns the index of the first view that shows the plane as a line; the front and top views are tried first. Without
// such a view, returns the number of cells.
std::size_t cell_that_shows(const Vector<ViewCell>& cells, const CutPlane& plane) noexcept {
    constexpr std::array order{ViewName::front, ViewName::top,    ViewName::left,
                               ViewName::right, ViewName::bottom, ViewName::back};
    for (const ViewName name : order)
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (cells[i].view.kind == name && cells[i].view.is_edge_on(plane.normal)) return i;
    return cells.size();
}

// Returns whether the view is aligned with its neighbours by common centre lines. Otherwise it is centred in its cell.
bool is_aligned(const ViewCell& cell, const glm::dvec3& up) noexcept {
    return cell.view.kind != ViewName::iso &&
           (!cell.view.is_section() || cell.row != 1 || std::abs(glm::dot(cell.view.eye, up)) < on_sheet.along);
}

// A column or a row of the table: its beginning, and its extents before and after its centre line.
struct TableSpan {
    int number;
    double begin;
    double before;
    double after;
};

struct TableSpans {
    Vector<TableSpan> spans;
    double length;

    [[nodiscard]] double centre(int number) const noexcept {
        const auto found =
            std::find_if(spans.begin(), spans.end(), [&](const TableSpan& s) { return s.number == number; });
        HRBFNPR_ASSERT(found != spans.end());
        return found->begin + found->before;
    }
};

TableSpans spans_of(Vector<TableSpan> each, double gap, Pool& pool) {
    std::stable_sort(each.begin(), each.end(),
                     [](const TableSpan& a, const TableSpan& b) { return a.number < b.number; });
    TableSpans found{Vector<TableSpan>(&pool), 0.0};
    for (const TableSpan& one : each) {
        if (found.spans.empty() || found.spans.back().number != one.number) {
            found.spans.push_back(one);
            continue;
        }
        TableSpan& known = found.spans.back();
        known.before = std::max(known.before, one.before);
        known.after = std::max(known.after, one.after);
    }
    double at = 0.0;
    for (TableSpan& span : found.spans) {
        span.begin = at;
        at += span.before + span.after + gap;
    }
    found.length = at - gap;
    return found;
}

// The size of the table, and the centres of its views relative to its upper left corner.
struct ViewTable {
    Vector<glm::dvec2> centres;
    double width;
    double height;
};

ViewTable table_of(const Vector<ViewCell>& cells, double scale, const LayoutRules& rules, Pool& pool) {
    Vector<glm::dvec2> shifts(&pool);
    Vector<TableSpan> columns(&pool);
    Vector<TableSpan> rows(&pool);
    for (const ViewCell& cell : cells) {
        const SheetBox box = cell.box(scale);
        const bool is_free = !is_aligned(cell, rules.up);
        shifts.push_back(is_free ? glm::dvec2((box.left + box.right) / 2.0, (box.top + box.bottom) / 2.0)
                                 : glm::dvec2(0.0));
        const SheetBox moved = box.moved(-shifts.back());
        columns.push_back({cell.column, 0.0, -moved.left, moved.right});
        rows.push_back({cell.row, 0.0, -moved.top, moved.bottom});
    }
    const TableSpans across = spans_of(std::move(columns), rules.spacing, pool);
    const TableSpans down = spans_of(std::move(rows), rules.spacing, pool);
    ViewTable table{Vector<glm::dvec2>(&pool), across.length, down.length};
    for (std::size_t i = 0; i < cells.size(); ++i)
        table.centres.emplace_back(across.centre(cells[i].column) - shifts[i].x,
                                   down.centre(cells[i].row) - shifts[i].y);
    return table;
}

// Returns the space for the table inside the frame.
glm::dvec2 room_of(const SheetPage& page) noexcept {
    const SheetBox frame = frame_of(page);
    return {frame.right - frame.left - 2.0 * on_sheet.pad, frame.bottom - frame.top - 2.0 * on_sheet.pad};
}

// Returns the centres of the views on a page, outside the title block and the scale bar, or nullopt if the space is too
// small.
std::optional<Vector<glm::dvec2>> place_on(const SheetPage& page, const Vector<ViewCell>& cells, double scale,
                                           const LayoutRules& rules, Pool& pool) {
    const ViewTable table = table_of(cells, scale, rules, pool);
    const SheetBox frame = frame_of(page);
    const glm::dvec2 room = room_of(page);
    if (!(table.width <= room.x && table.height <= room.y)) return std::nullopt;
    const double above = room.y - std::max(on_sheet.block_height, on_sheet.bar_height);
    const double middle = (room.x - table.width) / 2.0;
    const std::array<SheetBox, 2> reserved{
        {block_of(page),
         {frame.left, frame.bottom - on_sheet.bar_height, frame.left + on_sheet.bar_width, frame.bottom}}};
    const std::array<glm::dvec2, 4> corners{
        {{middle, (above - table.height) / 2.0}, {middle, 0.0}, {middle, (room.y - table.height) / 2.0}, {0.0, 0.0}}};
    for (const glm::dvec2& at : corners) {
        const glm::dvec2 corner(frame.left + on_sheet.pad + at.x, frame.top + on_sheet.pad + at.y);
        bool is_clear = at.y >= 0.0;
        for (std::size_t i = 0; i < cells.size() && is_clear; ++i) {
            const SheetBox box = cells[i].box(scale).moved(corner + table.centres[i]);
            for (const SheetBox& one : reserved) is_clear = is_clear && !box.meets(one.grown(on_sheet.pad / 2.0));
        }
        if (!is_clear) continue;
        Vector<glm::dvec2> centres(&pool);
        for (const glm::dvec2& centre : table.centres) centres.push_back(corner + centre);
        return centres;
    }
    return std::nullopt;
}

[[noreturn]] void refuse_scale(const Vector<ViewCell>& cells, const std::optional<SheetPage>& page,
                               const SheetScale& scale, const LayoutRules& rules, const Report& report) {
    Pool& pool = report.pool();
    const ViewTable table = table_of(cells, scale.value * rules.unit_mm, rules, pool);
    const SheetPage largest = page ? copy_of(*page, pool) : named_page("a0", report);
    const glm::dvec2 room = room_of(largest);
    String ways(&pool);
    for (const SheetScale& one : standard_scales(pool)) {
        if (!place_on(largest, cells, one.value * rules.unit_mm, rules, pool)) continue;
        ((ways += "{scale=") += one.text) += '}';
        break;
    }
    for (const std::string_view name : tried_papers) {
        if (!page || !place_on(named_page(name, report), cells, scale.value * rules.unit_mm, rules, pool)) continue;
        if (!ways.empty()) ways += " or ";
        ((ways += "{page=") += name) += '}';
        break;
    }
    report.refuse(formatted(pool,
                            "{scale=%s}: the views need %.0f x %.0f mm, but %s has room for %.0f x %.0f mm: %s fits",
                            scale.text.c_str(), table.width, table.height, largest.name.c_str(), room.x, room.y,
                            ways.empty() ? "a smaller {spacing}" : ways.c_str()));
}

} // namespace

Vector<ViewCell> cells_of(Vector<SheetView> views, const Vector<CutPlane>& planes, const Points& points,
                          const glm::dvec3& middle, Projection projection, const glm::dvec3& up, bool labels,
                          Pool& pool) {
    HRBFNPR_ASSERT(!points.empty());
    const auto& places = projection == Projection::first ? first_angle : third_angle;
    Vector<ViewCell> cells(&pool);
    int across = 4;
    int down = 3;
    for (SheetView& view : views) {
        glm::dvec2 low = view.flat(points.front(), middle);
        glm::dvec2 high = low;
        for (const glm::dvec3& p : points) {
            const glm::dvec2 place = view.flat(p, middle);
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        TablePlace at{};
        if (!view.is_section())
            at = places[static_cast<std::size_t>(view.kind)];
        else if (std::abs(glm::dot(view.eye, up)) > 1.0 - on_sheet.along)
            at = {1, down++};
        else
            at = {across++, 1};
        const bool has_label = labels || view.is_section();
        cells.push_back({std::move(view), at.column, at.row, low, high, has_label, Vector<glm::dvec3>(&pool),
                         Vector<std::size_t>(&pool)});
    }
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const std::size_t shows = cell_that_shows(cells, planes[i]);
        if (shows == cells.size()) continue;
        cells[shows].cut_normals.push_back(planes[i].normal);
        cells[shows].cuts.push_back(i);
    }
    return cells;
}

Vector<SheetScale> standard_scales(Pool& pool) {
    constexpr int most = 9; // The largest and smallest scales are this power of ten and its reciprocal.
    Vector<SheetScale> scales(&pool);
    const auto add = [&](double step, int power, bool is_large) {
        const double number = step * std::pow(10.0, power);
        String text = formatted(pool, is_large ? "%.0f:1" : "1:%.0f", number);
        scales.push_back({std::move(text), is_large ? number : 1.0 / number});
    };
    for (int power = most; power >= 0; --power)
        for (const double step : {5.0, 2.0, 1.0}) add(step, power, true);
    for (int power = 0; power <= most; ++power)
        for (const double step : {1.0, 2.0, 5.0})
            if (power > 0 || step > 1.0) add(step, power, false);
    return scales;
}

SheetLayout choose_layout(const Vector<ViewCell>& cells, const std::optional<SheetPage>& page,
                          const std::optional<SheetScale>& scale, const LayoutRules& rules, const Report& report) {
    HRBFNPR_ASSERT(!cells.empty() && rules.unit_mm > 0.0);
    Pool& pool = report.pool();
    const auto made = [&](const SheetPage& on, const SheetScale& at, Vector<glm::dvec2> centres) {
        return SheetLayout{
            copy_of(on, pool), {String(at.text, &pool), at.value}, at.value * rules.unit_mm, std::move(centres)};
    };
    if (!scale) {
        const SheetPage on = page ? copy_of(*page, pool) : named_page("a3", report);
        for (const SheetScale& one : standard_scales(pool))
            if (auto centres = place_on(on, cells, one.value * rules.unit_mm, rules, pool))
                return made(on, one, std::move(*centres));
        report.refuse(formatted(
            pool, "{page=%s} is too small for these views: use a larger page or a smaller {spacing}", on.name.c_str()));
    }
    Vector<SheetPage> pages(&pool);
    if (page)
        pages.push_back(copy_of(*page, pool));
    else
        for (const std::string_view name : tried_papers) pages.push_back(named_page(name, report));
    for (const SheetPage& on : pages)
        if (auto centres = place_on(on, cells, scale->value * rules.unit_mm, rules, pool))
            return made(on, *scale, std::move(*centres));
    refuse_scale(cells, page, *scale, rules, report);
}

} // namespace hrbfnpr::picture

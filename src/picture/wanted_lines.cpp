// SPDX-License-Identifier: MIT
#include "picture/wanted_lines.h"

#include "picture/field_table.h"
#include "picture/tuning_plan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

struct LineName {
    char name[20]; // The text is in an array, because a table of pointers would need relocation.
    std::uint32_t kind;
};

// The kinds of lines with the names that users write.
constexpr std::array<LineName, 31> line_names{LineName{"contour", HRBFNPR_LINE_KIND_CONTOUR},
                                              LineName{"contours", HRBFNPR_LINE_KIND_CONTOUR},
                                              LineName{"suggestive", HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR},
                                              LineName{"suggestive_contour", HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR},
                                              LineName{"ridges", HRBFNPR_LINE_KIND_RIDGE},
                                              LineName{"ridge", HRBFNPR_LINE_KIND_RIDGE},
                                              LineName{"valleys", HRBFNPR_LINE_KIND_VALLEY},
                                              LineName{"valley", HRBFNPR_LINE_KIND_VALLEY},
                                              LineName{"apparent", HRBFNPR_LINE_KIND_APPARENT_RIDGE},
                                              LineName{"apparent_ridge", HRBFNPR_LINE_KIND_APPARENT_RIDGE},
                                              LineName{"parabolic", HRBFNPR_LINE_KIND_PARABOLIC},
                                              LineName{"isophotes", HRBFNPR_LINE_KIND_ISOPHOTE},
                                              LineName{"isophote", HRBFNPR_LINE_KIND_ISOPHOTE},
                                              LineName{"section", HRBFNPR_LINE_KIND_SECTION},
                                              LineName{"sections", HRBFNPR_LINE_KIND_SECTION},
                                              LineName{"border", HRBFNPR_LINE_KIND_BORDER},
                                              LineName{"borders", HRBFNPR_LINE_KIND_BORDER},
                                              LineName{"crease", HRBFNPR_LINE_KIND_CREASE},
                                              LineName{"creases", HRBFNPR_LINE_KIND_CREASE},
                                              LineName{"shadow", HRBFNPR_LINE_KIND_SHADOW},
                                              LineName{"shadows", HRBFNPR_LINE_KIND_SHADOW},
                                              LineName{"terminator", HRBFNPR_LINE_KIND_TERMINATOR},
                                              LineName{"terminators", HRBFNPR_LINE_KIND_TERMINATOR},
                                              LineName{"soft", HRBFNPR_LINE_KIND_SOFT_EDGE},
                                              LineName{"soft_edge", HRBFNPR_LINE_KIND_SOFT_EDGE},
                                              LineName{"soft_edges", HRBFNPR_LINE_KIND_SOFT_EDGE},
                                              LineName{"intersection", HRBFNPR_LINE_KIND_INTERSECTION},
                                              LineName{"intersections", HRBFNPR_LINE_KIND_INTERSECTION},
                                              LineName{"tangent", HRBFNPR_LINE_KIND_TANGENT_EDGE},
                                              LineName{"tangent_edge", HRBFNPR_LINE_KIND_TANGENT_EDGE},
                                              LineName{"tangent_edges", HRBFNPR_LINE_KIND_TANGENT_EDGE}};

constexpr std::array<double, 3> usual_levels{0.25, 0.5, 0.75};

// A larger number of planes is a mistake, because the lines would fill the whole picture.
constexpr std::int64_t most_planes = 100'000;

int shown_length(std::string_view text) noexcept { return static_cast<int>(std::min<std::size_t>(text.size(), 60)); }

bool is_line_name(std::string_view known, std::string_view given) noexcept {
    return std::equal(known.begin(), known.end(), given.begin(), given.end(),
                      [](char a, char b) { return a == b || (a == '_' && b == '-'); });
}

std::uint32_t line_kind_of(std::string_view name) {
    for (const LineName& one : line_names)
        if (is_line_name(one.name, name)) return one.kind;
    fail(Status::invalid_argument,
         "there are no lines '%.*s'; there are contour, suggestive, ridges, valleys, apparent, parabolic, isophotes, "
         "section, border, crease, intersection, shadow, terminator, soft, tangent and none",
         shown_length(name), name.data());
}

std::string_view trimmed_number(std::string_view text) noexcept {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    return text;
}

bool read_line_number(std::string_view text, double& number) noexcept {
    const std::optional<double> parsed = parse_number(trimmed_number(text));
    if (parsed) number = *parsed;
    return parsed.has_value();
}

template <class Whole>
bool read_line_number(std::string_view text, Whole& number) noexcept {
    text = trimmed_number(text);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

// Returns the part of the text before the first `separator`, and removes it from the text.
std::string_view cut_line_part(std::string_view& text, char separator) noexcept {
    const std::size_t place = text.find(separator);
    const std::string_view part = text.substr(0, place);
    text.remove_prefix(place == std::string_view::npos ? text.size() : place + 1);
    return part;
}

// Reads section planes, such as "z:20": the axis and the number of planes.
bool read_planes(std::string_view text, WantedLine& line) noexcept {
    const std::string_view axis = cut_line_part(text, ':');
    if (axis != "x" && axis != "y" && axis != "z") return false;
    line.axis = axis[0] - 'x';
    return read_line_number(text, line.planes) && line.planes >= 1 && line.planes <= most_planes;
}

// Reads levels of isophotes, such as "0.3:0.6".
bool read_levels(std::string_view text, Vector<double>& levels) {
    levels.clear();
    while (true) {
        const bool is_last = text.find(':') == std::string_view::npos;
        double level = 0.0;
        if (!read_line_number(cut_line_part(text, ':'), level)) return false;
        levels.push_back(level);
        if (is_last) return true;
    }
}

WantedLine usual_line(std::uint32_t kind, Pool& pool) {
    WantedLine line(kind, pool);
    if (kind == HRBFNPR_LINE_KIND_ISOPHOTE) line.levels.assign(usual_levels.begin(), usual_levels.end());
    return line;
}

WantedLine parse_line(std::string_view part, Pool& pool) {
    std::string_view value = part;
    const std::string_view name = cut_line_part(value, '=');
    WantedLine line = usual_line(line_kind_of(name), pool);
    if (value.empty()) return line;
    const bool is_read = line.kind == HRBFNPR_LINE_KIND_SECTION    ? read_planes(value, line)
                         : line.kind == HRBFNPR_LINE_KIND_ISOPHOTE ? read_levels(value, line.levels)
                                                                   : false;
    if (!is_read)
        fail(Status::invalid_argument, "'%.*s' is not understood: write section=z:20 or isophotes=0.3:0.6",
             shown_length(part), part.data());
    return line;
}

hrbfnpr_line_style usual_contour() noexcept {
    hrbfnpr_line_style style = defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
    style.kind = HRBFNPR_LINE_KIND_CONTOUR;
    style.width = line_style_tuning.contour_width;
    return style;
}

hrbfnpr_line_style contour_style_of(const Style& style) noexcept {
    const auto found = std::find_if(style.lines.begin(), style.lines.end(), [](const hrbfnpr_line_style& line) {
        return line.kind == HRBFNPR_LINE_KIND_CONTOUR;
    });
    return found != style.lines.end() ? *found : usual_contour();
}

float scaled_line_length(float length, double factor) noexcept {
    return static_cast<float>(static_cast<double>(length) * factor);
}

// Adds the styles for one kind of lines. They are drawn in the ink and by the hand of the contour. Widths are relative
// to that of the contour.
void add_styles_of(const WantedLine& wanted, const hrbfnpr_line_style& contour, Style& style) {
    if (wanted.kind == HRBFNPR_LINE_KIND_CONTOUR) {
        style.lines.push_back(contour);
        return;
    }
    const bool is_crease = wanted.kind == HRBFNPR_LINE_KIND_CREASE;
    const bool is_border = wanted.kind == HRBFNPR_LINE_KIND_BORDER;
    const bool is_edge = is_border || is_crease || wanted.kind == HRBFNPR_LINE_KIND_INTERSECTION;
    hrbfnpr_line_style line = contour;
    line.kind = wanted.kind;
    // Hidden shadows would look as if they fell on what hides them.
    if (wanted.kind == HRBFNPR_LINE_KIND_SHADOW || wanted.kind == HRBFNPR_LINE_KIND_TERMINATOR)
        line.hidden = HRBFNPR_HIDDEN_PARTS_NONE;
    if (!is_border) line.outline_factor = 1.0F;
    if (!is_edge) line.width = scaled_line_length(line.width, line_style_tuning.fine_width);
    if (is_edge || wanted.kind == HRBFNPR_LINE_KIND_SECTION || wanted.kind == HRBFNPR_LINE_KIND_TANGENT_EDGE)
        line.taper = 0.0F;
    if (!wanted.levels.empty()) line.levels = style.keep_levels(wanted.levels.data(), wanted.levels.size());
    style.lines.push_back(line);
    if (!is_crease) return;
    // The creases of a smooth model that was fitted to a mesh are edges of the mesh, so they are OWN lines.
    line.kind = HRBFNPR_LINE_KIND_OWN;
    line.name = "crease";
    style.lines.push_back(line);
}

// Adds a style for borders for each style of contours, of which some draw contours twice.
void add_border_styles(Pool& pool, Style& style) {
    const WantedLine border(HRBFNPR_LINE_KIND_BORDER, pool);
    bool has_contour = false;
    const std::size_t count = style.lines.size();
    for (std::size_t i = 0; i < count; ++i) {
        const hrbfnpr_line_style line = style.lines[i];
        if (line.kind != HRBFNPR_LINE_KIND_CONTOUR) continue;
        has_contour = true;
        add_styles_of(border, line, style);
    }
    if (!has_contour) add_styles_of(border, usual_contour(), style);
}

std::uint32_t hidden_parts_of(std::uint32_t hidden_lines) noexcept {
    switch (hidden_lines) {
    case HRBFNPR_HIDDEN_LINES_HIDE: return HRBFNPR_HIDDEN_PARTS_NONE;
    case HRBFNPR_HIDDEN_LINES_SHOW: return HRBFNPR_HIDDEN_PARTS_SHOWN;
    default: return HRBFNPR_HIDDEN_PARTS_ATTENUATED;
    }
}

bool wants_finding_once(std::uint32_t kind) noexcept {
    return kind == HRBFNPR_LINE_KIND_RIDGE || kind == HRBFNPR_LINE_KIND_VALLEY || kind == HRBFNPR_LINE_KIND_PARABOLIC ||
           kind == HRBFNPR_LINE_KIND_SOFT_EDGE || kind == HRBFNPR_LINE_KIND_TANGENT_EDGE;
}

} // namespace

Vector<WantedLine> parse_lines(std::string_view text, Pool& pool) {
    Vector<WantedLine> lines(&pool);
    if (text.empty() || text == "none") return lines;
    while (true) {
        const bool is_last = text.find(',') == std::string_view::npos;
        lines.push_back(parse_line(cut_line_part(text, ','), pool));
        if (is_last) return lines;
    }
}

Vector<WantedLine> wanted_lines(const Call& call, const Style& style, bool is_mesh) {
    const Options& options = call.options;
    if (options.desc.lines != nullptr) return parse_lines(options.desc.lines, call.pool);
    const bool by_settings = options.settings != nullptr;
    Vector<WantedLine> lines(&call.pool);
    for (const hrbfnpr_line_style& line : style.lines)
        if (wants_finding_once(line.kind) || (by_settings && line.kind == HRBFNPR_LINE_KIND_SECTION))
            lines.push_back(usual_line(line.kind, call.pool));
    const bool has_creases = std::any_of(style.lines.begin(), style.lines.end(), [](const hrbfnpr_line_style& line) {
        return line.name != nullptr && std::string_view(line.name) == "crease";
    });
    if (!by_settings && has_creases && is_mesh) lines.push_back(usual_line(HRBFNPR_LINE_KIND_CREASE, call.pool));
    return lines;
}

bool needs_curvature(const Style& style) noexcept {
    return std::any_of(style.lines.begin(), style.lines.end(), [](const hrbfnpr_line_style& line) {
        return line.kind == HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR || line.kind == HRBFNPR_LINE_KIND_APPARENT_RIDGE ||
               line.kind == HRBFNPR_LINE_KIND_ISOPHOTE;
    });
}

void size_lines(const Call& call, Style& style, double pen, bool has_end) {
    const Options& options = call.options;
    const bool are_given = options.desc.lines != nullptr;
    const hrbfnpr_line_style contour = contour_style_of(style);
    if (are_given) {
        style.lines.clear();
        for (const WantedLine& wanted : parse_lines(options.desc.lines, call.pool))
            add_styles_of(wanted, contour, style);
    }
    const bool has_border = std::any_of(style.lines.begin(), style.lines.end(), [](const hrbfnpr_line_style& line) {
        return line.kind == HRBFNPR_LINE_KIND_BORDER;
    });
    if (!are_given && !style.lines.empty() && !has_border && has_end) add_border_styles(call.pool, style);
    const double line_width = options.desc.line_width;
    const double wider = line_width > 0.0 ? line_width / (pen * static_cast<double>(contour.width)) : 1.0;
    const std::optional<double> hidden_lines = options.changes.number("style.hidden_lines");
    for (hrbfnpr_line_style& line : style.lines) {
        if (hidden_lines) line.hidden = hidden_parts_of(static_cast<std::uint32_t>(*hidden_lines));
        line.width = scaled_line_length(line.width, wider * pen);
        line.hidden_width = scaled_line_length(line.hidden_width, wider * pen);
        line.taper = scaled_line_length(line.taper, wider * pen);
        line.shortest = scaled_line_length(line.shortest, wider * pen);
    }
}

} // namespace hrbfnpr::picture

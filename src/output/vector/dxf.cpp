// SPDX-License-Identifier: MIT
// The writer of DXF, version AC1018 (AutoCAD 2004), the first with true colours. A file consists of pairs of lines: a
// group code, which gives the meaning, and a value. Units are millimetres, with y up from the page's lower left corner.
//
// The tables of layers and line types come before the lines, so PageInfo::groups lists the groups of the page. Groups
// with the same name share a layer, and lines whose ink, width or line type is not that of their layer have their own.
#include "output/vector/curve_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;
using PieceKind = CurvePiece::Kind;

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr double whole_circle = 2.0 * std::numbers::pi * (1.0 - 1e-9);
// The largest number of bytes of a layer's name, and of a line of a comment.
constexpr std::size_t most_of_name = 255, most_of_comment = 240;

// The line weights of DXF, in hundredths of a millimetre.
constexpr std::array<int, 24> line_weights{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                           53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};

constexpr int default_weight = -3;

int line_weight_of(double width) noexcept {
    return *std::min_element(line_weights.begin(), line_weights.end(),
                             [&](int a, int b) { return std::abs(a - 100.0 * width) < std::abs(b - 100.0 * width); });
}

// The first nine indexed colours. The seventh is black on light paper, and white on a dark screen.
constexpr std::array<std::uint32_t, 9> indexed_colors{0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF, 0x0000FF,
                                                      0xFF00FF, 0x000000, 0x808080, 0xC0C0C0};
constexpr std::int64_t black = 7;

std::uint32_t color_of(const glm::vec4& ink) noexcept {
    const auto byte = [](float part) {
        return static_cast<std::uint32_t>(std::clamp(part, 0.0F, 1.0F) * 255.0F + 0.5F);
    };
    return byte(ink.x) << 16U | byte(ink.y) << 8U | byte(ink.z);
}

std::int64_t nearest_index(std::uint32_t color) noexcept {
    const auto distance = [&](std::uint32_t other) {
        std::int64_t sum = 0;
        for (const std::uint32_t shift : {0U, 8U, 16U}) {
            const std::int64_t off = std::int64_t{color >> shift & 255U} - std::int64_t{other >> shift & 255U};
            sum += off * off;
        }
        return sum;
    };
    const auto found = std::min_element(indexed_colors.begin(), indexed_colors.end(),
                                        [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
    return found - indexed_colors.begin() + 1;
}

// What a line has, or takes over from its layer.
struct Look {
    std::uint32_t color = 0;
    int weight = default_weight;
    LineType line_type = LineType::continuous;
};

struct DxfLayer {
    std::array<char, most_of_name + 1> name{}; // as in the file
    Look look;
};

// Handles of objects that every file has. Layers, line types and entities have the handles from `free` on.
enum Handle : std::int64_t {
    block_records = 1,
    layers_table,
    styles,
    line_types_table = 5,
    named_views,
    coordinate_systems,
    viewports,
    applications,
    dimension_styles,
    root = 12,
    groups_dictionary,
    plot_styles,
    plot_style,
    layer_0,
    standard_style,
    acad,
    by_block,
    by_layer,
    continuous_type,
    paper_space,
    paper_block,
    end_of_paper,
    model_space,
    model_block,
    end_of_model,
    active_viewport,
    free_handle = 256
};
constexpr const char* most_handles = "FFFFFFFF"; // every handle in the file is below this one

class DxfWriter final : public CurveWriter {
public:
    DxfWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts)
        : CurveWriter(memory, writer, settings, counts), page_(page), layers_(memory), pieces_(memory), lines_(memory),
          ribbon_(memory), keeps_(memory) {
        find_layers();
        write_header();
        write_tables();
        write_blocks();
        begin_section("ENTITIES");
    }

    void begin_view(const PageView&) override {}
    void begin_group(const PageGroup& group) override {
        group_ = group;
        ++counts_.groups;
        layer_ = &layers_[layer_of(group)];
    }
    void path(const PagePath& path) override {
        if (group_.pen_width > 0.0 || settings_.widths == Widths::classes || is_even(path)) {
            CurveWriter::path(path);
            return;
        }
        ++counts_.paths;
        swelling(path);
    }
    void dot(const PageDot& dot) override {
        ++counts_.dots;
        const DotShapes shape = settings_.dots_of(group_.pen_width);
        if (shape == DotShapes::spirals) {
            shapes_.shape(dot, group_, *this);
        } else if (shape == DotShapes::lines) {
            begin_line(2.0 * dot.radius, drawing::Cap::round, dot.opacity);
            point({dot.x, dot.y});
        } else {
            opacity_ = dot.opacity;
            width_ = 0.0;
            circle({dot.x, dot.y}, dot.radius);
        }
    }
    void text(const PageText& text) override {
        opacity_ = 1.0;
        width_ = 0.0;
        begin_entity("TEXT", "AcDbText");
        place({text.x, text.y});
        real(40, text.height);
        begin_value(1);
        string(text.text, true);
        out_ << '\n';
        pair(100, "AcDbText");
    }
    void end_group() override {}
    void end_view() override {}
    void finish() override {
        end_section();
        write_objects();
        pair(0, "EOF");
        out_.flush();
        counts_.bytes = out_.bytes();
    }

private:
    // ---- Shapes

    void begin_fill(double) override { HRBFNPR_ASSERT(false); } // swelling() draws the lines that would be filled
    void begin_line(double width, drawing::Cap, double opacity) override {
        width_ = width;
        opacity_ = opacity;
        pieces_.clear();
        closed_ = false;
    }
    void move_to(const dvec2& p) override { start_ = at_ = p; }
    void line_to(const dvec2& p) override { add({PieceKind::line, p}); }
    void curve_to(const geometry::Cubic& c) override { add({PieceKind::cubic, c.end, c.control_1, c.control_2}); }
    void arc_to(const CurvePiece& arc) override { add(arc); }
    void close() override { closed_ = true; }
    void end_shape() override {
        counts_.segments += pieces_.size();
        const bool is_point = std::all_of(pieces_.begin(), pieces_.end(), [&](const CurvePiece& piece) {
            return piece.kind == PieceKind::line && piece.end == start_;
        });
        if (is_point) {
            point(start_);
            return;
        }
        dvec2 start = start_;
        for (std::int64_t first = 0; first < pieces_.size();) {
            const bool is_spline = pieces_[first].kind == PieceKind::cubic;
            std::int64_t end = first + 1;
            while (end < pieces_.size() && (pieces_[end].kind == PieceKind::cubic) == is_spline) ++end;
            const std::span<const CurvePiece> run = std::as_const(pieces_).span().subspan(
                static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
            if (is_spline)
                spline(start, run);
            else
                polyline(start, run, closed_ && end - first == pieces_.size());
            start = run.back().end;
            first = end;
        }
    }
    void add(CurvePiece piece) {
        if (piece.kind == PieceKind::cubic) {
            const dvec2 chord = piece.end - at_;
            const auto is_near = [&](const dvec2& handle) {
                return geometry::distance_to_segment(handle, at_, piece.end) <= straight_within;
            };
            if (glm::dot(chord, chord) > 0.0 && is_near(piece.control_1) && is_near(piece.control_2))
                piece.kind = PieceKind::line;
        }
        pieces_.push_back(piece);
        at_ = piece.end;
    }

    // ---- Entities

    void point(const dvec2& p) {
        begin_entity("POINT", "AcDbPoint");
        place(p);
    }
    void circle(const dvec2& centre, double radius, const char* type = "CIRCLE") {
        begin_entity(type, "AcDbCircle");
        exact_place(centre);
        exact(40, radius);
    }
    // Writes lines and arcs as one entity.
    void polyline(const dvec2& start, std::span<const CurvePiece> pieces, bool closed) {
        const CurvePiece& first = pieces[0];
        if (pieces.size() == 1 && first.kind == PieceKind::line) {
            begin_entity("LINE", "AcDbLine");
            place(start);
            place(first.end, 11);
            return;
        }
        if (pieces.size() == 1) {
            const dvec2 from = start - first.centre, to = first.end - first.centre;
            if (std::abs(first.sweep) >= whole_circle) {
                circle(first.centre, glm::length(from));
                return;
            }
            circle(first.centre, glm::length(from), "ARC");
            pair(100, "AcDbArc");
            // The angles of an arc are counterclockwise, where y is up.
            const auto angle = [](const dvec2& p) {
                const double value = std::atan2(-p.y, p.x) * degrees;
                return value < 0.0 ? value + 360.0 : value;
            };
            exact(50, angle(first.sweep < 0.0 ? from : to));
            exact(51, angle(first.sweep < 0.0 ? to : from));
            return;
        }
        const bool ends_at_start = closed && pieces.back().end == start;
        begin_polyline(static_cast<std::int64_t>(pieces.size()) + (ends_at_start ? 0 : 1), closed);
        for (std::size_t i = 0; i <= pieces.size(); ++i) {
            if (i == pieces.size() && ends_at_start) break;
            flat_place(i == 0 ? start : pieces[i - 1].end);
            // A bulge is the tangent of a quarter of the sweep.
            if (i < pieces.size() && pieces[i].kind == PieceKind::arc) exact(42, -std::tan(0.25 * pieces[i].sweep));
        }
    }
    // Writes cubics as a B-spline whose knots are triple where they meet.
    void spline(const dvec2& start, std::span<const CurvePiece> cubics) {
        const auto count = static_cast<std::int64_t>(cubics.size());
        begin_entity("SPLINE", "AcDbSpline");
        constexpr std::int64_t is_planar = 8, degree = 3;
        whole(70, is_planar);
        whole(71, degree);
        whole(72, degree * count + 5);
        whole(73, degree * count + 1);
        whole(74, 0);
        for (std::int64_t knot = 0; knot <= count; ++knot)
            for (std::int64_t i = knot == 0 || knot == count ? 0 : 1; i <= degree; ++i) whole(40, knot);
        place(start);
        for (const CurvePiece& cubic : cubics) {
            place(cubic.control_1);
            place(cubic.control_2);
            place(cubic.end);
        }
    }
    // Writes a line of varying width as a polyline that has a width at each point.
    void swelling(const PagePath& path) {
        lines_.clear();
        for (const PagePoint& p : path.points) lines_.push_back({p.x, p.y, p.radius});
        geometry::simplify_polyline(std::span<const glm::dvec3>(lines_.span()), settings_.tolerance, keeps_);
        ribbon_.clear();
        const auto add_tip = [&](drawing::Cap cap, const PagePoint& end, const PagePoint& other) {
            const dvec2 way = place_of(end) - place_of(other);
            const double length = glm::length(way);
            if (cap != drawing::Cap::pointed || path.closed || !(length > 0.0)) return;
            const dvec2 tip =
                place_of(end) + (2.0 * static_cast<double>(drawing::point_length) * end.radius / length) * way;
            ribbon_.push_back({tip.x, tip.y, 0.0});
        };
        const std::span<const PagePoint> points = path.points;
        add_tip(path.begin, points[0], points[1]);
        for (std::int64_t i = 0; i < lines_.size(); ++i)
            if (keeps_[i] != 0) ribbon_.push_back(points[static_cast<std::size_t>(i)]);
        add_tip(path.end, points.back(), points[points.size() - 2]);
        counts_.segments += ribbon_.size() - 1;
        opacity_ = path.opacity;
        width_ = mean_width(points);
        begin_polyline(ribbon_.size(), false);
        for (std::int64_t i = 0; i < ribbon_.size(); ++i) {
            flat_place(place_of(ribbon_[i]));
            real(40, 2.0 * ribbon_[i].radius);
            real(41, 2.0 * ribbon_[std::min(i + 1, ribbon_.size() - 1)].radius);
        }
    }
    void begin_polyline(std::int64_t points, bool closed) {
        begin_entity("LWPOLYLINE", "AcDbPolyline");
        whole(90, points);
        whole(70, closed ? 1 : 0);
    }
    // Begins an entity of the current group. Its width is width_, or not said if that is 0.
    void begin_entity(const char* type, const char* kind) {
        pair(0, type);
        handle(5, next_handle_++);
        handle(330, model_space);
        pair(100, "AcDbEntity");
        pair(8, layer_->name.data());
        Look look = look_of(group_, width_);
        if (!(width_ > 0.0)) look.line_type = LineType::continuous;
        if (look.line_type != layer_->look.line_type) line_type(look.line_type);
        if (look.color != layer_->look.color) write_color(look.color);
        if (width_ > 0.0 && look.weight != layer_->look.weight) whole(370, look.weight);
        if (look.line_type > LineType::continuous) real(48, width_); // patterns are for lines of 1 mm
        const double alpha = std::clamp(opacity_ * static_cast<double>(group_.ink.w), 0.0, 1.0);
        constexpr std::int64_t has_alpha = 0x02000000;
        if (const auto byte = static_cast<std::int64_t>(alpha * 255.0 + 0.5); byte < 255) whole(440, has_alpha + byte);
        pair(100, kind);
    }

    // ---- Layers

    // Returns the look of lines of a group. If their width is 0, they have the reader's default.
    [[nodiscard]] static Look look_of(const PageGroup& group, double width) noexcept {
        return {color_of(group.ink), width > 0.0 ? line_weight_of(width) : default_weight,
                group.line_type > LineType::continuous ? group.line_type : LineType::continuous};
    }
    // Writes a group's name as that of a layer, which may not have some characters.
    static DxfLayer named(std::string_view name) noexcept {
        DxfLayer layer;
        std::size_t used = 0;
        for (std::size_t at = 0; at < name.size();) {
            std::array<char, 8> text{};
            const std::string_view part = in_file(next_character(name, at), true, text);
            if (used + part.size() > most_of_name) break;
            part.copy(layer.name.data() + used, part.size());
            used += part.size();
        }
        if (used == 0) layer.name[0] = '_';
        return layer;
    }
    // Names of layers are the same if they differ in the case of letters only.
    static bool is_same(std::string_view a, std::string_view b) noexcept {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
    }
    [[nodiscard]] std::int64_t find(const DxfLayer& wanted) const noexcept {
        std::int64_t at = 0;
        while (at < layers_.size() && !is_same(layers_[at].name.data(), wanted.name.data())) ++at;
        return at;
    }
    std::int64_t layer_of(const PageGroup& group) {
        const std::int64_t at = find(named(group.name));
        HRBFNPR_ASSERT(at < layers_.size());
        return at < layers_.size() ? at : 0;
    }
    void find_layers() {
        layers_.push_back(named("0"));
        for (const PageGroup& group : page_.groups) {
            DxfLayer layer = named(group.name);
            layer.look = look_of(group, group.pen_width);
            if (find(layer) == layers_.size()) layers_.push_back(layer);
        }
    }

    // ---- Sections

    void write_header() {
        const auto comment = [&](const char* text) {
            if (text == nullptr) return;
            std::string_view rest = text;
            while (!rest.empty()) {
                std::size_t size = std::min({rest.find('\n'), most_of_comment, rest.size()});
                while (size < rest.size() && (static_cast<unsigned char>(rest[size]) & 0xC0U) == 0x80U) ++size;
                begin_value(999);
                string(rest.substr(0, size));
                out_ << '\n';
                rest.remove_prefix(std::min(size + (size < rest.size() && rest[size] == '\n' ? 1 : 0), rest.size()));
            }
        };
        comment(page_.title);
        comment(page_.description);
        comment(page_.metadata);
        out_ << "999\nhrbfnpr " << page_.program << '\n';
        begin_section("HEADER");
        const auto variable = [&](const char* name) { pair(9, name); };
        variable("$ACADVER");
        pair(1, "AC1018");
        variable("$DWGCODEPAGE");
        pair(3, "ANSI_1252");
        variable("$INSUNITS"); // millimetres
        whole(70, 4);
        variable("$MEASUREMENT");
        whole(70, 1);
        variable("$LTSCALE");
        real(40, 1.0);
        variable("$LWDISPLAY");
        whole(290, 1);
        for (const char* least : {"$EXTMIN", "$LIMMIN"}) {
            variable(least);
            corner(0.0, 0.0, least[1] == 'E');
        }
        for (const char* most : {"$EXTMAX", "$LIMMAX"}) {
            variable(most);
            corner(page_.width, page_.height, most[1] == 'E');
        }
        variable("$HANDSEED");
        pair(5, most_handles);
        end_section();
        begin_section("CLASSES");
        end_section();
    }
    void write_tables() {
        begin_section("TABLES");
        begin_table("VPORT", viewports, 1);
        begin_entry("VPORT", active_viewport, viewports, "AcDbViewportTableRecord", "*Active");
        corner(0.0, 0.0, false, 10);
        corner(1.0, 1.0, false, 11);
        corner(0.5 * page_.width, 0.5 * page_.height, false, 12);
        corner(0.0, 0.0, true, 17);
        corner(0.0, 0.0, false, 16);
        real(36, 1.0);
        real(40, 1.05 * std::max(page_.height, page_.width));
        real(41, 1.0);
        end_table();
        write_line_types();
        begin_table("LAYER", layers_table, layers_.size());
        for (const DxfLayer& layer : layers_) {
            begin_entry("LAYER", &layer == &layers_[0] ? std::int64_t{layer_0} : next_handle_++, layers_table,
                        "AcDbLayerTableRecord", layer.name.data());
            write_color(layer.look.color);
            line_type(layer.look.line_type);
            whole(370, layer.look.weight);
            handle(390, plot_style);
        }
        end_table();
        begin_table("STYLE", styles, 1);
        begin_entry("STYLE", standard_style, styles, "AcDbTextStyleTableRecord", "Standard");
        real(40, 0.0);
        real(41, 1.0);
        real(50, 0.0);
        whole(71, 0);
        real(42, 2.5);
        pair(3, "arial.ttf");
        pair(4, "");
        end_table();
        begin_table("VIEW", named_views, 0);
        end_table();
        begin_table("UCS", coordinate_systems, 0);
        end_table();
        begin_table("APPID", applications, 1);
        begin_entry("APPID", acad, applications, "AcDbRegAppTableRecord", "ACAD");
        end_table();
        begin_table("DIMSTYLE", dimension_styles, 0);
        pair(100, "AcDbDimStyleTable");
        end_table();
        begin_table("BLOCK_RECORD", block_records, 2);
        for (const auto& [number, name] :
             {std::pair{model_space, "*Model_Space"}, std::pair{paper_space, "*Paper_Space"}}) {
            begin_entry("BLOCK_RECORD", number, block_records, "AcDbBlockTableRecord", name, false);
            handle(340, 0);
        }
        end_table();
        end_section();
    }
    // Writes the types that the page uses. Dashes and gaps are for a line of 1 mm, and lines scale them by their width.
    void write_line_types() {
        std::array<bool, static_cast<std::size_t>(LineType::last) + 1> used{};
        for (const PageGroup& group : page_.groups)
            used[static_cast<std::size_t>(look_of(group, 0.0).line_type)] = true;
        used[static_cast<std::size_t>(LineType::continuous)] = false;
        begin_table("LTYPE", line_types_table, 3 + std::count(used.begin(), used.end(), true));
        for (const auto& [number, name] : {std::pair{by_block, "ByBlock"}, std::pair{by_layer, "ByLayer"},
                                           std::pair{continuous_type, "Continuous"}}) {
            begin_entry("LTYPE", number, line_types_table, "AcDbLinetypeTableRecord", name);
            pattern("", {});
        }
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) continue;
            std::array<char, 16> name{};
            begin_entry("LTYPE", next_handle_++, line_types_table, "AcDbLinetypeTableRecord",
                        name_of(static_cast<LineType>(i), name));
            pattern("ISO 128-2", dashes_of(static_cast<LineType>(i)));
        }
        end_table();
    }
    void pattern(const char* description, std::span<const double> parts) {
        pair(3, description);
        whole(72, 'A');
        whole(73, static_cast<std::int64_t>(parts.size()));
        double sum = 0.0;
        for (const double part : parts) sum += part;
        real(40, sum);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            real(49, i % 2 == 0 ? parts[i] : -parts[i]);
            whole(74, 0);
        }
    }
    void write_blocks() {
        begin_section("BLOCKS");
        const auto block = [&](std::int64_t record, std::int64_t begin, std::int64_t end, const char* name) {
            const auto part = [&](const char* type, std::int64_t number, const char* kind) {
                pair(0, type);
                handle(5, number);
                handle(330, record);
                pair(100, "AcDbEntity");
                if (record == paper_space) whole(67, 1);
                pair(8, "0");
                pair(100, kind);
            };
            part("BLOCK", begin, "AcDbBlockBegin");
            pair(2, name);
            whole(70, 0);
            corner(0.0, 0.0, true);
            pair(3, name);
            pair(1, "");
            part("ENDBLK", end, "AcDbBlockEnd");
        };
        block(model_space, model_block, end_of_model, "*Model_Space");
        block(paper_space, paper_block, end_of_paper, "*Paper_Space");
        end_section();
    }
    void write_objects() {
        begin_section("OBJECTS");
        const auto dictionary = [&](const char* type, std::int64_t number, std::int64_t owner) {
            pair(0, type);
            handle(5, number);
            handle(330, owner);
            pair(100, "AcDbDictionary");
            whole(281, 1);
        };
        const auto entry = [&](const char* name, std::int64_t number) {
            pair(3, name);
            handle(350, number);
        };
        dictionary("DICTIONARY", root, 0);
        entry("ACAD_GROUP", groups_dictionary);
        entry("ACAD_PLOTSTYLENAME", plot_styles);
        dictionary("DICTIONARY", groups_dictionary, root);
        dictionary("ACDBDICTIONARYWDFLT", plot_styles, root);
        entry("Normal", plot_style);
        pair(100, "AcDbDictionaryWithDefault");
        handle(340, plot_style);
        pair(0, "ACDBPLACEHOLDER");
        handle(5, plot_style);
        handle(330, plot_styles);
        end_section();
    }
    void begin_section(const char* name) {
        pair(0, "SECTION");
        pair(2, name);
    }
    void end_section() { pair(0, "ENDSEC"); }
    void begin_table(const char* name, std::int64_t number, std::int64_t entries) {
        pair(0, "TABLE");
        pair(2, name);
        handle(5, number);
        handle(330, 0);
        pair(100, "AcDbSymbolTable");
        whole(70, entries);
    }
    void end_table() { pair(0, "ENDTAB"); }
    void begin_entry(const char* type, std::int64_t number, std::int64_t table, const char* kind, const char* name,
                     bool has_flags = true) {
        pair(0, type);
        handle(5, number);
        handle(330, table);
        pair(100, "AcDbSymbolTableRecord");
        pair(100, kind);
        pair(2, name);
        if (has_flags) whole(70, 0);
    }

    // ---- Values

    void begin_value(std::int64_t code) { out_ << code << '\n'; }
    void pair(std::int64_t code, const char* value) {
        begin_value(code);
        out_ << value << '\n';
    }
    void whole(std::int64_t code, std::int64_t value) {
        begin_value(code);
        out_ << value << '\n';
    }
    void handle(std::int64_t code, std::int64_t value) {
        begin_value(code);
        out_.hexadecimal(static_cast<std::uint64_t>(value)) << '\n';
    }
    // Writes a number with three decimals. Some readers need a digit before the decimal point.
    void real(std::int64_t code, double value) {
        begin_value(code);
        const std::int64_t thousandths = in_thousandths(value);
        const std::int64_t size = std::abs(thousandths);
        if (thousandths < 0) out_ << '-';
        if (size > 0 && size < 1000) out_ << '0';
        out_.thousandths(size);
        if (size % 1000 == 0) out_ << ".0";
        out_ << '\n';
    }
    void exact(std::int64_t code, double value) {
        begin_value(code);
        out_.precise(value) << '\n';
    }
    void place(const dvec2& p, std::int64_t code = 10) {
        real(code, p.x);
        real(code + 10, page_.height - p.y);
        real(code + 20, 0.0);
    }
    void exact_place(const dvec2& p) {
        exact(10, p.x);
        exact(20, page_.height - p.y);
        real(30, 0.0);
    }
    void flat_place(const dvec2& p) {
        real(10, p.x);
        real(20, page_.height - p.y);
    }
    void corner(double x, double y, bool has_z, std::int64_t code = 10) {
        real(code, x);
        real(code + 10, y);
        if (has_z) real(code + 20, 0.0);
    }
    void write_color(std::uint32_t color) {
        const std::int64_t index = nearest_index(color);
        whole(62, index);
        if (color != indexed_colors[black - 1] || index != black) whole(420, color);
    }
    // Writes the name of a line type. These are the names that AutoCAD gives to the types of the standard.
    static const char* name_of(LineType type, std::array<char, 16>& name) noexcept {
        if (type <= LineType::continuous) return "Continuous";
        std::snprintf(name.data(), name.size(), "ACAD_ISO%02uW100", static_cast<unsigned>(type) % 100U);
        return name.data();
    }
    void line_type(LineType type) {
        std::array<char, 16> name{};
        pair(6, name_of(type, name));
    }
    // Returns a character as it is written in a file. Characters outside ASCII are escaped, and characters that names
    // of layers may not have become '_'.
    static std::string_view in_file(std::uint32_t code, bool in_name, std::array<char, 8>& text) noexcept {
        constexpr std::string_view not_in_names = "<>/\\\":;?*|=,`";
        if (code >= 0x80 && code < 0x10000) {
            std::snprintf(text.data(), text.size(), "\\U+%04X", static_cast<unsigned>(code) & 0xFFFFU);
            return text.data();
        }
        text[0] = code >= 0x10000 ? '?' : code < 0x20 || code == 0x7F ? ' ' : static_cast<char>(code);
        if (in_name && (text[0] == ' ' ? code != ' ' : not_in_names.find(text[0]) != std::string_view::npos))
            text[0] = '_';
        return {text.data(), 1};
    }
    // Writes a text. In the text of an entity, "%%" and '^' begin codes of their own.
    void string(std::string_view text, bool has_codes = false) {
        for (std::size_t at = 0; at < text.size();) {
            const bool is_doubled = has_codes && text.substr(at, 2) == "%%";
            std::array<char, 8> part{};
            out_ << in_file(next_character(text, at), false, part);
            if (has_codes && part[0] == '^') out_ << ' ';
            if (is_doubled) out_ << "%%";
        }
    }

    // Handles of a cubic within this distance of its chord, in mm, make it a straight line.
    static constexpr double straight_within = 0.0015;

    PageInfo page_;
    base::Array<DxfLayer> layers_;
    const DxfLayer* layer_ = nullptr; // the layer of the current group
    std::int64_t next_handle_ = free_handle;
    double width_ = 0.0, opacity_ = 1.0; // the current entity's
    dvec2 start_{0.0}, at_{0.0};
    bool closed_ = false;
    base::Array<CurvePiece> pieces_; // the current line's
    base::Array<glm::dvec3> lines_;  // x, y and the radius of a line of varying width
    base::Array<PagePoint> ribbon_;
    base::Array<std::uint8_t> keeps_;
};

} // namespace

std::unique_ptr<PageSink> make_dxf_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                          const PageSettings& settings, PageCounts& counts) {
    return std::make_unique<DxfWriter>(memory, writer, page, settings.shapes, counts);
}

} // namespace hrbfnpr::output

// SPDX-License-Identifier: MIT
// Technical drawings of forty parts against rays through the exact parts: pieces of lines that are visible or hidden as
// they should be, classes of lines, lines drawn twice, edges without a line, and verified sheets. --named=TEXT: only
// parts with TEXT in the name; --only=drawings,sheets,times; --wrong: prints each wrong piece.
#include "line_calls.h"
#include "technical_reference.h"

#include <array>
#include <cstdio>
#include <ctime>
#include <exception>
#include <memory>

namespace {

using bench::LineClass;
using bench::TechnicalPart;
using bench::TechnicalReference;

constexpr std::uint32_t kind_intersection = 15;
constexpr std::uint32_t kind_tangent = 16;
constexpr std::uint32_t all_kinds[] = {HRBFNPR_LINE_KIND_CONTOUR, HRBFNPR_LINE_KIND_CREASE, HRBFNPR_LINE_KIND_BORDER,
                                       HRBFNPR_LINE_KIND_SECTION, kind_intersection,        kind_tangent};
constexpr double picture = 1000.0; // pixels

// ---- Drawings

// A point of a line, as the library writes it.
struct DrawnPoint {
    float window[3];
    float place[3];
    std::uint32_t layer, hidden_layers;
};

struct DrawnPiece {
    std::vector<glm::dvec2> pixels;
    std::vector<glm::dvec3> places;
    std::uint32_t kind = 0;
    bool hidden = false;
};

struct PartModels {
    std::vector<scenes::Model> models;
    std::vector<bench::LineSet> lines;
    std::vector<scenes::PointSet> marks;
};

struct ReleasePicture {
    void operator()(hrbfnpr_picture* handle) const { hrbfnpr_picture_release(handle); }
};
using Picture = std::unique_ptr<hrbfnpr_picture, ReleasePicture>;

// Makes the surface of a part, and nothing else.
Picture picture_of(hrbfnpr_context* context, const TechnicalPart& part, const hrbfnpr_model* model) {
    scenes::Check check;
    auto source = scenes::made(hrbfnpr_picture_source_init);
    if (model != nullptr) {
        source.model = model;
    } else {
        source.points = {part.mesh.points.data(), static_cast<std::int64_t>(part.mesh.points.size()), 0,
                         HRBFNPR_SCALAR_FLOAT64, 3};
        source.triangles = {part.mesh.faces.data(), static_cast<std::int64_t>(part.mesh.faces.size()), 0,
                            HRBFNPR_SCALAR_INT32, 3};
    }
    auto desc = scenes::made(hrbfnpr_picture_desc_init);
    desc.sources = &source;
    desc.source_count = 1;
    desc.flags = HRBFNPR_PICTURE_SURFACE_ONLY;
    desc.up[2] = 1.0;
    hrbfnpr_picture* made = nullptr;
    check(hrbfnpr_picture_create(context, &desc, nullptr, &made, check.error()));
    return Picture(made);
}

PartModels models_of(hrbfnpr_context* context, const TechnicalPart& part, const Picture& picture_of_mesh) {
    scenes::Check check;
    PartModels made;
    for (const bench::PlainSolid& item : part.items) made.models.push_back(bench::model_of(context, item));
    std::vector<const hrbfnpr_model*> all;
    for (const scenes::Model& model : made.models) all.push_back(model.get());
    if (picture_of_mesh) {
        auto info = scenes::made(hrbfnpr_picture_info_init);
        check(hrbfnpr_picture_get_info(picture_of_mesh.get(), &info, check.error()));
        for (std::int64_t i = 0; i < info.parts; ++i) {
            auto surface = scenes::made(hrbfnpr_picture_part_init);
            check(hrbfnpr_picture_get_part(picture_of_mesh.get(), i, &surface, check.error()));
            all.push_back(surface.model);
        }
    }
    const double level = 0.013;
    for (const hrbfnpr_model* model : all) {
        auto section = scenes::made(hrbfnpr_line_desc_init);
        section.kind = HRBFNPR_LINE_KIND_SECTION;
        section.plane[2] = 1.0;
        section.levels = {&level, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        auto desc = scenes::made(hrbfnpr_line_set_desc_init);
        desc.lines = &section;
        desc.line_count = 1;
        hrbfnpr_line_set* lines = nullptr;
        check(hrbfnpr_line_set_create(context, model, &desc, nullptr, &lines, check.error()));
        made.lines.emplace_back(lines);
        made.marks.push_back(bench::generate(context, model, bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 64)));
    }
    return made;
}

std::vector<DrawnPiece> pieces_of(const hrbfnpr_drawing* drawing) {
    scenes::Check check;
    const auto attribute = [](std::uint32_t what, std::uint32_t scalar, std::size_t offset) {
        auto made = scenes::made(hrbfnpr_vertex_attribute_init);
        made.attribute = what;
        made.scalar = scalar;
        made.offset = static_cast<std::uint32_t>(offset);
        return made;
    };
    const std::array attributes{
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(DrawnPoint, window)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, offsetof(DrawnPoint, place)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_LAYER, HRBFNPR_SCALAR_UINT32, offsetof(DrawnPoint, layer)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS, HRBFNPR_SCALAR_UINT32, offsetof(DrawnPoint, hidden_layers))};
    auto layout = scenes::made(hrbfnpr_vertex_layout_init);
    layout.primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
    layout.stride = sizeof(DrawnPoint);
    layout.attributes = attributes.data();
    layout.attribute_count = static_cast<std::int64_t>(attributes.size());
    std::int64_t vertices = 0;
    std::int64_t indices = 0;
    check(hrbfnpr_drawing_vertex_bound(drawing, layout.primitive, &vertices, &indices, check.error()));
    std::vector<DrawnPoint> points(static_cast<std::size_t>(vertices));
    std::vector<std::uint32_t> order(static_cast<std::size_t>(indices));
    check(hrbfnpr_drawing_write_vertices(drawing, &layout, points.data(), vertices, &vertices, order.data(), indices,
                                         &indices, check.error()));
    std::vector<DrawnPiece> pieces;
    bool begins = true;
    for (std::int64_t i = 0; i < indices; ++i) {
        const std::uint32_t index = order[static_cast<std::size_t>(i)];
        if (begins) pieces.emplace_back();
        begins = index == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART);
        if (begins) continue;
        const DrawnPoint& p = points[index];
        DrawnPiece& piece = pieces.back();
        piece.pixels.emplace_back(p.window[0], p.window[1]);
        piece.places.emplace_back(p.place[0], p.place[1], p.place[2]);
        piece.hidden = p.hidden_layers != 0;
        auto layer = scenes::made(hrbfnpr_drawing_layer_info_init);
        check(hrbfnpr_drawing_get_layer_info(drawing, p.layer, &layer, check.error()));
        piece.kind = layer.kind;
    }
    return pieces;
}

struct PartDrawing {
    std::vector<DrawnPiece> pieces;
    hrbfnpr_drawing_info info;
};

// Draws all lines of all items, hidden ones too. Kinds of lines that the library does not know are left out.
PartDrawing draw(hrbfnpr_context* context, const PartModels& made, const hrbfnpr_camera& camera, bool verify) {
    scenes::Check check;
    hrbfnpr_renderer* renderer = nullptr;
    check(hrbfnpr_renderer_create(context, &renderer, check.error()));
    const scenes::Renderer owner(renderer);
    for (std::size_t kinds = std::size(all_kinds);; --kinds) {
        std::vector<hrbfnpr_line_style> styles;
        for (std::size_t k = 0; k < kinds; ++k) {
            auto line = scenes::made(hrbfnpr_line_style_init);
            line.kind = all_kinds[k];
            line.hidden = HRBFNPR_HIDDEN_PARTS_SHOWN;
            line.width = 1.0F;
            line.taper = 0.0F;
            line.shortest = 0.0F;
            if (line.kind == HRBFNPR_LINE_KIND_CREASE) line.lower = line.upper = 5.0F; // degrees
            styles.push_back(line);
        }
        const bench::LinesStyle lines(styles);
        hrbfnpr_style style = lines.get();
        style.verify_lines = verify ? 1 : 0;
        std::vector<hrbfnpr_item> items;
        for (std::size_t i = 0; i < made.lines.size(); ++i) {
            auto item = scenes::made(hrbfnpr_item_init);
            item.point_set = made.marks[i].get();
            item.line_set = made.lines[i].get();
            item.style = &style;
            items.push_back(item);
        }
        hrbfnpr_drawing* drawing = nullptr;
        hrbfnpr_error error{};
        error.struct_size = sizeof error;
        const hrbfnpr_status status = hrbfnpr_renderer_draw(
            renderer, items.data(), static_cast<std::int64_t>(items.size()), 0, &camera, &drawing, &error);
        if (status == HRBFNPR_STATUS_INVALID_ARGUMENT && kinds > 4) continue;
        check(status);
        const scenes::Drawing drawn(drawing);
        PartDrawing found{pieces_of(drawing), scenes::made(hrbfnpr_drawing_info_init)};
        check(hrbfnpr_drawing_get_info(drawing, &found.info, check.error()));
        return found;
    }
}

// ---- Measures

struct Score {
    std::int64_t pieces = 0, decided = 0, right = 0;                 // pieces of lines
    double length = 0.0, twice = 0.0;                                // pixels
    std::int64_t edges = 0, missing_visible = 0, missing_hidden = 0; // places on edges
    std::int64_t proved = 0, proof_agrees = 0, proof_undecided = 0, proof_repaired = 0;

    void add(const Score& other) {
        pieces += other.pieces;
        decided += other.decided;
        right += other.right;
        length += other.length;
        twice += other.twice;
        edges += other.edges;
        missing_visible += other.missing_visible;
        missing_hidden += other.missing_hidden;
        proved += other.proved;
        proof_agrees += other.proof_agrees;
        proof_undecided += other.proof_undecided;
        proof_repaired += other.proof_repaired;
    }
    [[nodiscard]] double share_right() const {
        return static_cast<double>(right) / static_cast<double>(std::max<std::int64_t>(decided, 1));
    }
    [[nodiscard]] double share_missing() const {
        return static_cast<double>(missing_visible + missing_hidden) /
               static_cast<double>(std::max<std::int64_t>(edges, 1));
    }
};

// A place along a drawn piece.
struct PiecePlace {
    std::size_t piece;
    double at, from_end; // pixels along the piece
    glm::dvec2 pixel, way;
    glm::dvec3 place;
};

std::vector<PiecePlace> places_along(const std::vector<DrawnPiece>& pieces, double step) {
    std::vector<PiecePlace> places;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const DrawnPiece& piece = pieces[k];
        double whole = 0.0;
        for (std::size_t i = 1; i < piece.pixels.size(); ++i)
            whole += glm::distance(piece.pixels[i - 1], piece.pixels[i]);
        const double each = whole / std::max(1.0, std::round(whole / step));
        double next = 0.5 * each;
        double at = 0.0;
        for (std::size_t i = 1; i < piece.pixels.size(); ++i) {
            const double length = glm::distance(piece.pixels[i - 1], piece.pixels[i]);
            for (; length > 0.0 && next < at + length; next += each) {
                const double share = (next - at) / length;
                places.push_back({k, next, std::min(next, whole - next),
                                  glm::mix(piece.pixels[i - 1], piece.pixels[i], share),
                                  (piece.pixels[i] - piece.pixels[i - 1]) / length,
                                  glm::mix(piece.places[i - 1], piece.places[i], share)});
            }
            at += length;
        }
    }
    return places;
}

void judge_pieces(const std::vector<DrawnPiece>& pieces, const TechnicalReference& reference, const glm::dvec3& to_eye,
                  const char* tell, Score& score) {
    std::vector<int> agree(pieces.size(), 0);
    std::vector<int> differ(pieces.size(), 0);
    for (const PiecePlace& place : places_along(pieces, 8.0)) {
        if (place.from_end < 2.0) continue;
        const std::optional<bool> hidden = reference.hidden(place.place, to_eye);
        if (!hidden) continue;
        const bool is_right = *hidden == pieces[place.piece].hidden;
        ++(is_right ? agree : differ)[place.piece];
        if (!is_right && tell != nullptr)
            std::printf("   %s: kind %u drawn %s at pixel (%.1f %.1f), place (%.4f %.4f %.4f)\n", tell,
                        pieces[place.piece].kind, *hidden ? "visible" : "hidden", place.pixel.x, place.pixel.y,
                        place.place.x, place.place.y, place.place.z);
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        ++score.pieces;
        if (agree[k] + differ[k] == 0) continue;
        ++score.decided;
        if (differ[k] == 0) ++score.right;
    }
}

// Counts lengths that lie on another line, in space.
void count_twice(const std::vector<DrawnPiece>& pieces, double diagonal, bool tell, Score& score) {
    const std::vector<PiecePlace> places = places_along(pieces, 2.0);
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
    const auto cell = [](double x) { return static_cast<int>(std::floor(x / 4.0)); };
    for (std::size_t i = 0; i < places.size(); ++i)
        cells[{cell(places[i].pixel.x), cell(places[i].pixel.y)}].push_back(i);
    for (const PiecePlace& a : places) {
        score.length += 2.0;
        if (pieces[a.piece].kind == HRBFNPR_LINE_KIND_SECTION) continue;
        bool twice = false;
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (const std::size_t k : cells[{cell(a.pixel.x) + x, cell(a.pixel.y) + y}]) {
                    const PiecePlace& b = places[k];
                    if (pieces[b.piece].kind == HRBFNPR_LINE_KIND_SECTION) continue;
                    if (a.piece == b.piece && std::abs(a.at - b.at) < 12.0) continue;
                    if (std::min(a.from_end, b.from_end) < 3.0) continue;
                    const glm::dvec2 away = b.pixel - a.pixel;
                    const double beside = std::abs(away.x * a.way.y - away.y * a.way.x);
                    twice =
                        twice || (beside < 0.3 && glm::length(away) < 2.0 && std::abs(glm::dot(a.way, b.way)) > 0.97 &&
                                  glm::distance(a.place, b.place) < 5e-4 * diagonal);
                }
        if (!twice) continue;
        score.twice += 2.0;
        if (tell)
            std::printf("   twice: kind %u at pixel (%.1f %.1f), place (%.4f %.4f %.4f)\n", pieces[a.piece].kind,
                        a.pixel.x, a.pixel.y, a.place.x, a.place.y, a.place.z);
    }
}

void count_missing(const std::vector<DrawnPiece>& pieces, const TechnicalReference& reference, const glm::dvec3& to_eye,
                   bool tell, Score& score) {
    const double reach = reference.margin * 2.5;
    const std::vector<PiecePlace> drawn = places_along(pieces, 2.0);
    for (const glm::dvec3& place : reference.edge_places(to_eye)) {
        const std::optional<bool> hidden = reference.hidden(place, to_eye);
        if (!hidden) continue;
        ++score.edges;
        const bool found = std::any_of(drawn.begin(), drawn.end(), [&](const PiecePlace& p) {
            if (!*hidden && pieces[p.piece].hidden) return false;
            const glm::dvec3 away = p.place - place;
            return glm::length(away - glm::dot(away, to_eye) * to_eye) < reach;
        });
        if (found) continue;
        ++(*hidden ? score.missing_hidden : score.missing_visible);
        if (tell)
            std::printf("   missing: %s edge at (%.4f %.4f %.4f)\n", *hidden ? "hidden" : "visible", place.x, place.y,
                        place.z);
    }
}

std::set<LineClass> classes_in(const std::vector<DrawnPiece>& pieces) {
    std::set<LineClass> found;
    for (const DrawnPiece& piece : pieces) {
        if (piece.hidden) found.insert(LineClass::hidden);
        switch (piece.kind) {
        case HRBFNPR_LINE_KIND_CONTOUR: found.insert(LineClass::outline); break;
        case HRBFNPR_LINE_KIND_CREASE: found.insert(LineClass::sharp); break;
        case HRBFNPR_LINE_KIND_SECTION: found.insert(LineClass::section); break;
        case HRBFNPR_LINE_KIND_BORDER: found.insert(LineClass::border); break;
        case kind_intersection: found.insert(LineClass::intersection); break;
        case kind_tangent: found.insert(LineClass::tangent); break;
        default: break;
        }
    }
    return found;
}

struct Results {
    Score drawn, verified;
    std::map<LineClass, std::pair<int, int>> classes; // the number of parts with the class, and of those that show it
};

void print_score(const char* name, const Score& score) {
    std::printf("%-28s %6lld %6lld %6lld %8.4f %7.1f %7lld %7lld %7lld\n", name, static_cast<long long>(score.pieces),
                static_cast<long long>(score.decided), static_cast<long long>(score.decided - score.right),
                score.share_right(), score.twice, static_cast<long long>(score.edges),
                static_cast<long long>(score.missing_visible), static_cast<long long>(score.missing_hidden));
}

void measure_part(hrbfnpr_context* context, const TechnicalPart& part, bool tell, Results& results) {
    const Picture surface = part.is_mesh() ? picture_of(context, part, nullptr) : Picture();
    const PartModels made = models_of(context, part, surface);
    const TechnicalReference reference(part);
    Score drawn;
    Score verified;
    std::set<LineClass> found;
    for (const glm::dvec3& direction :
         {glm::dvec3(-0.52, 0.61, -0.45), glm::dvec3(0.35, -0.83, -0.31), glm::dvec3(0.21, 0.4, 0.77)}) {
        const glm::dvec3 sight = glm::normalize(direction);
        if (tell) std::printf("%s from (%.2f %.2f %.2f)\n", part.name.c_str(), -sight.x, -sight.y, -sight.z);
        scenes::Check check;
        auto camera = scenes::made(hrbfnpr_camera_init);
        const glm::dvec3 up(0.0, 0.0, 1.0);
        const glm::dvec3 low = reference.low();
        const glm::dvec3 high = reference.high();
        check(hrbfnpr_camera_fit_bounds(&camera, &low.x, &high.x, &sight.x, &up.x, 0.0, picture, picture, 0.05,
                                        check.error()));
        for (const bool verify : {false, true}) {
            const PartDrawing drawing = draw(context, made, camera, verify);
            Score& score = verify ? verified : drawn;
            judge_pieces(drawing.pieces, reference, -sight, !tell ? nullptr : verify ? "verified" : "wrong", score);
            score.proved += drawing.info.line_pieces;
            score.proof_agrees += drawing.info.line_agreeing;
            score.proof_undecided += drawing.info.line_undecided;
            score.proof_repaired += drawing.info.line_repaired;
            if (verify) continue;
            count_twice(drawing.pieces, reference.diagonal, tell, score);
            count_missing(drawing.pieces, reference, -sight, tell, score);
            found.merge(classes_in(drawing.pieces));
        }
    }
    std::vector<LineClass> wanted = part.classes;
    wanted.push_back(LineClass::sharp);
    wanted.push_back(LineClass::hidden);
    const bool is_round = part.is_mesh() && std::find(wanted.begin(), wanted.end(), LineClass::border) != wanted.end();
    for (const LineClass one : wanted) {
        if (is_round && one == LineClass::sharp) continue; // an open round shell has no edge
        auto& [parts, shown] = results.classes[one];
        ++parts;
        shown += found.count(one) > 0 ? 1 : 0;
    }
    print_score(part.name.c_str(), drawn);
    if (verified.right != verified.decided || verified.proof_repaired > 0)
        std::printf("   verified: %lld of %lld pieces right; rays: %lld of %lld agree, %lld undecided, %lld repaired\n",
                    static_cast<long long>(verified.right), static_cast<long long>(verified.decided),
                    static_cast<long long>(verified.proof_agrees),
                    static_cast<long long>(verified.proved - verified.proof_undecided),
                    static_cast<long long>(verified.proof_undecided), static_cast<long long>(verified.proof_repaired));
    std::fflush(stdout);
    results.drawn.add(drawn);
    results.verified.add(verified);
}

// ---- Sheets

struct SheetResult {
    hrbfnpr_views_info info;
    double seconds; // processor time
};

SheetResult write_sheet(hrbfnpr_context* context, const TechnicalPart& part, bool verify) {
    scenes::Check check;
    const std::clock_t begin = std::clock();
    const scenes::Model model = part.is_mesh() ? scenes::Model() : bench::model_of(context, part.items.front());
    const Picture surface = picture_of(context, part, model.get());
    auto desc = scenes::made(hrbfnpr_views_desc_init);
    desc.flags = verify ? HRBFNPR_VIEWS_VERIFY : 0;
    desc.unit_mm = 20.0;
    SheetResult result{scenes::made(hrbfnpr_views_info_init), 0.0};
    const auto write = [](void*, const void*, std::uint64_t) -> std::int32_t { return 0; };
    check(hrbfnpr_picture_write_views(surface.get(), &desc, write, nullptr, &result.info, nullptr, check.error()));
    result.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return result;
}

// The parts of sheets: every fourth one of a single item.
std::vector<TechnicalPart> parts_of_sheets(const std::vector<TechnicalPart>& parts) {
    std::vector<TechnicalPart> chosen;
    for (std::size_t i = 1; i < parts.size() && chosen.size() < 10; i += 4)
        if (parts[i].items.size() < 2) chosen.push_back(parts[i]);
    for (std::size_t i = 2; i < parts.size() && chosen.size() < 10; i += 4)
        if (parts[i].items.size() < 2) chosen.push_back(parts[i]);
    return chosen;
}

void measure_sheets(hrbfnpr_context* context, const std::vector<TechnicalPart>& parts) {
    std::printf("\nISO views of sheets\n%-28s %7s %7s %9s %8s %9s %9s\n", "part", "pieces", "agree", "undecided",
                "repaired", "s", "verified");
    std::int64_t decided = 0;
    std::int64_t agreeing = 0;
    double seconds = 0.0;
    for (const TechnicalPart& part : parts_of_sheets(parts)) {
        const SheetResult plain = write_sheet(context, part, false);
        const SheetResult sheet = write_sheet(context, part, true);
        std::printf("%-28s %7lld %7lld %9lld %8lld %9.2f %9.2f\n", part.name.c_str(),
                    static_cast<long long>(sheet.info.pieces), static_cast<long long>(sheet.info.agreeing),
                    static_cast<long long>(sheet.info.undecided), static_cast<long long>(sheet.info.repaired),
                    plain.seconds, sheet.seconds);
        std::fflush(stdout);
        decided += sheet.info.pieces - sheet.info.undecided;
        agreeing += sheet.info.agreeing;
        seconds += sheet.seconds;
    }
    std::printf("technical.sheets_agree %.4f\n",
                static_cast<double>(agreeing) / static_cast<double>(std::max<std::int64_t>(decided, 1)));
    std::printf("technical.sheets_seconds %.2f\n", seconds);
}

int run(int argc, char** argv) {
    const std::string only = bench::option(argc, argv, "--only=");
    const std::string named = bench::option(argc, argv, "--named=");
    const bool tell = std::any_of(argv + 1, argv + argc, [](const char* arg) { return std::string(arg) == "--wrong"; });
    const scenes::Context context = bench::make_context();
    std::vector<TechnicalPart> parts;
    for (TechnicalPart& part : bench::technical_parts())
        if (part.name.find(named) != std::string::npos) parts.push_back(std::move(part));
    if (only.empty() || only.find("drawings") != std::string::npos) {
        std::printf("%-28s %6s %6s %6s %8s %7s %7s %7s %7s\n", "part, three views", "pieces", "judged", "wrong",
                    "right", "twice", "edges", "missing", "hidden");
        Results results;
        for (const TechnicalPart& part : parts) measure_part(context.get(), part, tell, results);
        print_score("all", results.drawn);
        int found = 0;
        for (const auto& [one, parts_with] : results.classes) {
            std::printf("class %-12s shown by %d of %d parts\n", bench::line_class_names[static_cast<int>(one)],
                        parts_with.second, parts_with.first);
            found += parts_with.second > 0 ? 1 : 0;
        }
        const Score& verified = results.verified;
        std::printf("technical.right %.4f\n", results.drawn.share_right());
        std::printf("technical.right_verified %.4f\n", verified.share_right());
        std::printf("technical.agree %.4f\n",
                    static_cast<double>(verified.proof_agrees) /
                        static_cast<double>(std::max<std::int64_t>(verified.proved - verified.proof_undecided, 1)));
        std::printf("technical.repaired %lld\n", static_cast<long long>(verified.proof_repaired));
        std::printf("technical.undecided %.4f\n", static_cast<double>(verified.proof_undecided) /
                                                      static_cast<double>(std::max<std::int64_t>(verified.proved, 1)));
        std::printf("technical.classes %d\n", found);
        std::printf("technical.twice %.1f\n", results.drawn.twice);
        std::printf("technical.missing %.4f\n", results.drawn.share_missing());
    }
    if (only.empty() || only.find("sheets") != std::string::npos || only.find("times") != std::string::npos)
        measure_sheets(context.get(), parts);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

// SPDX-License-Identifier: MIT
#include "picture/view_lines.h"

#include "picture/tuning_views.h"
#include "picture/view_verify.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace hrbfnpr::picture {
namespace {

constexpr const ViewLinesTuning& tuned_lines = view_lines_tuning;

// A line of a view.
struct TracedLine {
    explicit TracedLine(Pool& pool) : places(&pool), points(&pool), hidden(&pool) {}

    Points places;    // places in the model
    PaperLine points; // the same places on the paper, in mm
    Flags hidden;     // true if the piece from point i to point i + 1 is hidden
};
using TracedLines = Vector<TracedLine>;

bool is_round(const TracedLine& line) noexcept {
    return line.points.size() > 3 && glm::length(line.points.front() - line.points.back()) < tuned_lines.meet;
}

void turn_round(TracedLine& line) {
    std::reverse(line.places.begin(), line.places.end());
    std::reverse(line.points.begin(), line.points.end());
    std::reverse(line.hidden.begin(), line.hidden.end());
}

// Appends a part, which begins at the end of the line.
void append(TracedLine& line, const TracedLine& part) {
    line.places.insert(line.places.end(), part.places.begin() + 1, part.places.end());
    line.points.insert(line.points.end(), part.points.begin() + 1, part.points.end());
    line.hidden.insert(line.hidden.end(), part.hidden.begin(), part.hidden.end());
}

// ---- Joining parts of lines

// Finds the ends of lines by their positions on the paper.
class LineEnds {
public:
    LineEnds(TracedLines& lines, Pool& pool) : lines_(&lines), taken_(lines.size(), 0, &pool), cells_(&pool) {
        for (std::size_t i = 0; i < lines.size(); ++i) {
            HRBFNPR_ASSERT(!lines[i].points.empty());
            for (const bool at_end : {false, true})
                cells_[cell_of(place_of({i, at_end}), tuned_lines.meet)].push_back({i, at_end});
        }
    }

    // Returns a line and marks it as used, or returns nullopt if it was used before.
    [[nodiscard]] std::optional<TracedLine> take(std::size_t number) {
        if (taken_[number] != 0) return std::nullopt;
        taken_[number] = 1;
        return std::move((*lines_)[number]);
    }

    // Takes the line with the end nearest to a place, and turns it so that it begins there. Returns nullopt if no end
    // is near.
    [[nodiscard]] std::optional<TracedLine> take_next_at(const glm::dvec2& place) {
        const PaperCell middle = cell_of(place, tuned_lines.meet);
        std::optional<std::pair<double, LineEnd>> best;
        for (std::int64_t column = middle.column - 1; column <= middle.column + 1; ++column)
            for (std::int64_t row = middle.row - 1; row <= middle.row + 1; ++row) {
                const auto found = cells_.find({column, row});
                if (found == cells_.end()) continue;
                for (const LineEnd& end : found->second) {
                    if (taken_[end.line] != 0) continue;
                    const double away = glm::length(place_of(end) - place);
                    if (!best || is_before(away, end, best->first, best->second)) best = {away, end};
                }
            }
        if (!best || best->first > tuned_lines.meet) return std::nullopt;
        std::optional<TracedLine> line = take(best->second.line);
        if (best->second.is_last) turn_round(*line);
        return line;
    }

private:
    struct LineEnd {
        std::size_t line;
        bool is_last; // true for the last point of the line, false for the first
    };

    [[nodiscard]] const glm::dvec2& place_of(const LineEnd& end) const noexcept {
        const PaperLine& points = (*lines_)[end.line].points;
        return end.is_last ? points.back() : points.front();
    }
    [[nodiscard]] static bool is_before(double away, const LineEnd& a, double than, const LineEnd& b) noexcept {
        return std::tuple(away, a.line, !a.is_last) < std::tuple(than, b.line, !b.is_last);
    }

    TracedLines* lines_;
    Flags taken_;
    HashMap<PaperCell, Vector<LineEnd>, PaperCellHash> cells_;
};

// Joins parts whose ends meet. Long parts are joined first. A line is closed if its two ends meet.
TracedLines joined(TracedLines parts, Pool& pool) {
    Vector<std::size_t> order(&pool);
    for (std::size_t i = 0; i < parts.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto key = [&](std::size_t i) {
            const PaperLine& points = parts[i].points;
            return std::tuple(-static_cast<std::int64_t>(points.size()), points.front().x, points.front().y);
        };
        return key(a) < key(b);
    });
    LineEnds ends(parts, pool);
    TracedLines found(&pool);
    for (const std::size_t number : order) {
        std::optional<TracedLine> line = ends.take(number);
        if (!line) continue;
        // The line is extended at one end, then turned and extended at the other end.
        for (const bool is_turned : {false, true}) {
            if (is_turned) turn_round(*line);
            while (!is_round(*line)) {
                const std::optional<TracedLine> part = ends.take_next_at(line->points.back());
                if (!part) break;
                append(*line, *part);
            }
        }
        if (is_round(*line)) {
            line->points.back() = line->points.front();
            line->places.back() = line->places.front();
        }
        found.push_back(std::move(*line));
    }
    return found;
}

// ---- Lines of a drawing

// Returns a camera that sees the whole model, with the middle of the view in the middle of the picture.
hrbfnpr_camera camera_of_view(const SheetView& view, const Solid& solid, double scale) {
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    const double reach = tuned_lines.picture * solid.diagonal;
    const double size = std::max(tuned_lines.least_picture,
                                 2.0 * std::nearbyint(reach * view.factor * scale / tuned_lines.pixel / 2.0));
    const double height = size * tuned_lines.pixel / (view.factor * scale);
    const glm::dvec3 eye = solid.middle + tuned_lines.eye * solid.diagonal * view.eye;
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_camera_look_at(&camera, &eye.x, &solid.middle.x, &view.up.x, error);
    });
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_camera_orthographic(&camera, height, size, size, tuned_lines.nearest * solid.diagonal,
                                           tuned_lines.farthest * solid.diagonal, error);
    });
    return camera;
}

Drawing draw_view_lines(const SheetView& view, const char* section, const Solid& solid, const hrbfnpr_camera& camera,
                        hrbfnpr_operation* operation, Pool& pool) {
    Vector<hrbfnpr_line_style> lines(&pool);
    const auto add = [&](std::uint32_t kind, const char* name) {
        auto& line = lines.emplace_back(defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init));
        line.kind = kind;
        line.name = name;
        line.hidden = HRBFNPR_HIDDEN_PARTS_SHOWN;
        line.width = 1.0F;
        // Lines are not tapered and have no halos, because the gaps would look like hidden parts.
        line.taper = 0.0F;
        line.shortest = 0.0F;
    };
    for (const std::uint32_t kind : {HRBFNPR_LINE_KIND_CONTOUR, HRBFNPR_LINE_KIND_BORDER, HRBFNPR_LINE_KIND_CREASE,
                                     HRBFNPR_LINE_KIND_INTERSECTION})
        add(kind, nullptr);
    for (const std::uint32_t kind : solid.smooth) add(kind, nullptr);
    if (solid.has_tangents) add(HRBFNPR_LINE_KIND_TANGENT_EDGE, nullptr);
    if (view.is_section()) add(HRBFNPR_LINE_KIND_SECTION, section);

    auto marks = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    marks.shown = 0;
    marks.contours = 0;
    auto style = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    style.layers = &marks;
    style.layer_count = 1;
    style.lines = lines.data();
    style.line_count = static_cast<std::int64_t>(lines.size());
    style.halo_width = 0.0F;
    style.tone = HRBFNPR_TONE_NONE;
    Vector<hrbfnpr_item> items(&pool);
    solid.for_surfaces([&](const Solid& surface) {
        hrbfnpr_item& item = items.emplace_back(defaults<hrbfnpr_item>(hrbfnpr_item_init));
        item.point_set = surface.marks.get();
        item.style = &style;
        item.line_set = surface.lines.get();
    });
    return make<Drawing>([&](hrbfnpr_drawing** out, hrbfnpr_error* error) {
        return hrbfnpr_renderer_draw_with_operation(solid.renderer.get(), items.data(),
                                                    static_cast<std::int64_t>(items.size()), 0, &camera, operation, out,
                                                    error);
    });
}

// A point of a stroke.
struct StrokePoint {
    float window[3];
    float position[3];
    std::uint32_t layer;
    std::uint32_t hidden_layers;
};

struct DrawnViewStrokes {
    Vector<StrokePoint> points;
    Vector<std::uint32_t> strips; // indices of points; a restart index ends each strip
    Vector<std::uint32_t> kinds;  // the kind of each layer, HRBFNPR_LINE_KIND_*
};

DrawnViewStrokes strokes_of_drawing(const Drawing& drawing, Pool& pool) {
    const auto attribute = [](std::uint32_t what, std::uint32_t scalar, std::size_t offset) {
        auto made = defaults<hrbfnpr_vertex_attribute>(hrbfnpr_vertex_attribute_init);
        made.attribute = what;
        made.scalar = scalar;
        made.offset = static_cast<std::uint32_t>(offset);
        return made;
    };
    const std::array attributes{
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(StrokePoint, window)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, offsetof(StrokePoint, position)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_LAYER, HRBFNPR_SCALAR_UINT32, offsetof(StrokePoint, layer)),
        attribute(HRBFNPR_VERTEX_ATTRIBUTE_HIDDEN_LAYERS, HRBFNPR_SCALAR_UINT32, offsetof(StrokePoint, hidden_layers))};
    auto layout = defaults<hrbfnpr_vertex_layout>(hrbfnpr_vertex_layout_init);
    layout.primitive = HRBFNPR_PRIMITIVE_LINE_STRIPS;
    layout.attributes = attributes.data();
    layout.attribute_count = static_cast<std::int64_t>(attributes.size());
    layout.stride = sizeof(StrokePoint);
    std::int64_t points = 0;
    std::int64_t indices = 0;
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_drawing_vertex_bound(drawing.get(), layout.primitive, &points, &indices, error);
    });
    DrawnViewStrokes strokes{Vector<StrokePoint>(static_cast<std::size_t>(points), &pool),
                             Vector<std::uint32_t>(static_cast<std::size_t>(indices), &pool),
                             Vector<std::uint32_t>(&pool)};
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_drawing_write_vertices(drawing.get(), &layout, strokes.points.data(), points, &points,
                                              strokes.strips.data(), indices, &indices, error);
    });
    strokes.strips.resize(static_cast<std::size_t>(indices));
    auto info = defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_info(drawing.get(), &info, error); });
    for (std::int64_t i = 0; i < info.layers; ++i) {
        auto layer = defaults<hrbfnpr_drawing_layer_info>(hrbfnpr_drawing_layer_info_init);
        call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_layer_info(drawing.get(), i, &layer, error); });
        strokes.kinds.push_back(layer.kind);
    }
    return strokes;
}

using LinesByKind = Map<std::uint32_t, TracedLines>;

// Returns all lines of a drawing. Parts that follow each other are joined.
LinesByKind traced_lines(const Drawing& drawing, double picture_size, Pool& pool) {
    const DrawnViewStrokes strokes = strokes_of_drawing(drawing, pool);
    const double half = picture_size / 2.0;
    LinesByKind parts(&pool);
    TracedLine line(pool);
    const StrokePoint* first = nullptr; // the first point of the line
    for (const std::uint32_t index : strokes.strips) {
        if (index == static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART)) {
            if (line.points.size() > 1) {
                line.hidden.assign(line.points.size() - 1, first->hidden_layers != 0 ? 1 : 0);
                HRBFNPR_ASSERT(first->layer < strokes.kinds.size());
                parts[strokes.kinds[first->layer]].push_back(std::move(line));
            }
            line = TracedLine(pool);
            continue;
        }
        const StrokePoint& point = strokes.points[index];
        if (line.points.empty()) first = &point;
        line.points.push_back(tuned_lines.pixel * (glm::dvec2(point.window[0], point.window[1]) - half));
        line.places.emplace_back(point.position[0], point.position[1], point.position[2]);
    }
    for (auto& [kind, lines] : parts) lines = joined(std::move(lines), pool);
    return parts;
}

// ---- Sight: whether places are visible from the eye of a view, or from a cutting plane

// Rays to the eye. f is evaluated at many places of many rays at once, which is faster than following each ray. Walls
// thinner than 1 / (steps * finer) diagonals may be missed. For open surfaces, two sheets may be missed if they are
// nearer to each other than 1 / (2 * steps) diagonals.
struct Sight {
    const Solid& solid;
    const Solid& surface; // the surface that the rays meet: `solid`, or one of its others
    const SheetView& view;
    const CutPlane* plane;             // may be null
    const Vector<PaperLine>& outlines; // closed outlines of the cut, in units of the model
    hrbfnpr_operation* operation;
    Pool& pool;
};

void evaluate(const Sight& sight, const Points& points, Vector<double>& values, Points* gradients) {
    values.resize(points.size());
    if (points.empty()) return;
    const hrbfnpr_array at = view_of(points);
    const hrbfnpr_array_out value{values.data(), at.count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    hrbfnpr_array_out gradient{};
    if (gradients != nullptr) {
        gradients->resize(points.size());
        gradient = room_in(*gradients);
    }
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_model_evaluate(sight.surface.model.get(), &at, &value,
                                      gradients != nullptr ? &gradient : nullptr, nullptr, sight.operation, error);
    });
}

// Places on rays: for each ray, `count` distances from its start.
struct RaySamples {
    std::size_t count;
    Vector<double> at;
    Vector<double> values; // values of f
};

// Evaluates f at the samples. `starts` has the start of each ray.
void look_up(const Sight& sight, const Points& starts, RaySamples& samples) {
    HRBFNPR_ASSERT(samples.at.size() == starts.size() * samples.count);
    Points points(&sight.pool);
    points.reserve(samples.at.size());
    for (std::size_t i = 0; i < samples.at.size(); ++i)
        points.push_back(starts[i / samples.count] + samples.at[i] * sight.view.eye);
    evaluate(sight, points, samples.values, nullptr);
}

RaySamples even_samples(const Vector<double>& lengths, std::size_t steps, Pool& pool) {
    RaySamples samples{steps + 1, Vector<double>(&pool), Vector<double>(&pool)};
    const Vector<double> shares = evenly(0.0, 1.0, samples.count, pool);
    samples.at.reserve(lengths.size() * samples.count);
    for (const double length : lengths)
        for (const double share : shares) samples.at.push_back(length * share);
    return samples;
}

// Finds whether f is below 0 somewhere on each ray. Around each minimum of f that is near 0, it uses finer steps.
void look_up_solid(const Sight& sight, const Points& starts, const Vector<double>& lengths, std::uint8_t* hidden) {
    const auto steps = static_cast<std::size_t>(sight_tuning.steps);
    RaySamples samples = even_samples(lengths, steps, sight.pool);
    look_up(sight, starts, samples);
    const std::size_t count = samples.count;
    const Vector<double> between = evenly(-1.0, 1.0, 2 * static_cast<std::size_t>(sight_tuning.finer) + 1, sight.pool);
    RaySamples finer{between.size(), Vector<double>(&sight.pool), Vector<double>(&sight.pool)};
    Points finer_starts(&sight.pool);
    Vector<std::size_t> rays(&sight.pool);
    for (std::size_t ray = 0; ray < starts.size(); ++ray) {
        const double* const value = samples.values.data() + ray * count;
        if (std::any_of(value, value + count, [](double f) { return f < 0.0; })) {
            hidden[ray] = 1;
            continue;
        }
        const double step = lengths[ray] / static_cast<double>(steps);
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_least =
                value[i] <= value[i > 0 ? i - 1 : count - 1] && value[i] <= value[i + 1 < count ? i + 1 : 0];
            if (!(is_least && value[i] < sight_tuning.near * step)) continue;
            rays.push_back(ray);
            finer_starts.push_back(starts[ray]);
            for (const double part : between)
                finer.at.push_back(std::min(std::max(samples.at[ray * count + i] + step * part, 0.0), lengths[ray]));
        }
    }
    look_up(sight, finer_starts, finer);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double* const value = finer.values.data() + i * finer.count;
        if (std::any_of(value, value + finer.count, [](double f) { return f < 0.0; })) hidden[rays[i]] = 1;
    }
}

// Finds whether each ray meets an open surface. The sign of f is not enough: f is negative on one whole side of the
// sheet, and beyond the end of the sheet it changes its sign where no surface is.
void follow_open(const Sight& sight, const Points& starts, const Vector<double>& lengths, std::uint8_t* hidden) {
    const auto steps = 2 * static_cast<std::size_t>(sight_tuning.steps);
    RaySamples samples = even_samples(lengths, steps, sight.pool);
    look_up(sight, starts, samples);
    Vector<std::size_t> rays(&sight.pool);
    Points origins(&sight.pool);
    double longest = 0.0;
    const auto step_of = [&](std::size_t ray) {
        return sight_tuning.step_room * lengths[ray] / static_cast<double>(steps);
    };
    for (std::size_t ray = 0; ray < starts.size(); ++ray)
        for (std::size_t i = ray * samples.count; i + 1 < (ray + 1) * samples.count; ++i) {
            if ((samples.values[i] < 0.0) == (samples.values[i + 1] < 0.0)) continue;
            rays.push_back(ray);
            origins.push_back(starts[ray] + samples.at[i] * sight.view.eye);
            longest = std::max(longest, step_of(ray));
        }
    if (rays.empty()) return;
    const Points directions(rays.size(), sight.view.eye, &sight.pool);
    auto desc = defaults<hrbfnpr_cast_desc>(hrbfnpr_cast_desc_init);
    desc.t_max = longest;
    desc.lipschitz = sight.surface.lipschitz;
    Vector<double> t(rays.size(), &sight.pool);
    Vector<std::uint32_t> hit(rays.size(), &sight.pool);
    auto hits = defaults<hrbfnpr_ray_hits>(hrbfnpr_ray_hits_init);
    const auto count = static_cast<std::int64_t>(rays.size());
    hits.count = {hit.data(), count, 0, HRBFNPR_SCALAR_UINT32, 1};
    hits.t = {t.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    const hrbfnpr_array from = view_of(origins);
    const hrbfnpr_array along = view_of(directions);
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_model_cast_rays(sight.surface.model.get(), &from, &along, &desc, &hits, sight.operation, error);
    });
    for (std::size_t i = 0; i < rays.size(); ++i)
        if (hit[i] > 0 && t[i] <= step_of(rays[i])) hidden[rays[i]] = 1;
}

// Returns whether a place, as seen in the view, is inside an odd number of outlines.
bool is_in_cut(const Sight& sight, const glm::dvec3& place) noexcept {
    const glm::dvec2 p = sight.view.flat(place, sight.solid.middle);
    bool is_odd = false;
    for (const PaperLine& outline : sight.outlines)
        for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
            const glm::dvec2& a = outline[i];
            const glm::dvec2& b = outline[i + 1];
            if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) is_odd = !is_odd;
        }
    return is_odd;
}

// Returns the starts of rays from places on surfaces: `outside` away from each surface on which the place lies. A place
// lies on the only surface, or on those that are nearer than `outside`.
Points starts_outside(const Sight& sight, const Points& places, double outside) {
    Points starts(places.begin(), places.end(), &sight.pool);
    Vector<double> values(&sight.pool);
    Points gradients(&sight.pool);
    sight.solid.for_surfaces([&](const Solid& surface) {
        evaluate({sight.solid, surface, sight.view, sight.plane, sight.outlines, sight.operation, sight.pool}, places,
                 values, &gradients);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double slope = std::max(glm::length(gradients[i]), 1e-300);
            if (!sight.solid.others.empty() && !(std::abs(values[i]) <= outside * slope)) continue;
            glm::dvec3 outward = gradients[i] / slope;
            if (surface.is_open && glm::dot(outward, sight.view.eye) < 0.0) outward = -outward;
            starts[i] += outside * outward;
        }
    });
    return starts;
}

void hides_some(const Sight& sight, const Points& places, double off, std::uint8_t* hidden) {
    const Points starts = starts_outside(sight, places, off * sight.solid.diagonal);
    Vector<double> lengths(&sight.pool);
    for (const glm::dvec3& start : starts) {
        const double to_plane =
            sight.plane == nullptr ? sight.solid.diagonal : sight.plane->place - glm::dot(start, sight.plane->normal);
        lengths.push_back(std::max(to_plane, 0.0));
    }
    bool is_open = false;
    sight.solid.for_surfaces([&](const Solid& surface) {
        const Sight one{sight.solid, surface, sight.view, sight.plane, sight.outlines, sight.operation, sight.pool};
        is_open = is_open || surface.is_open;
        (surface.is_open ? follow_open : look_up_solid)(one, starts, lengths, hidden);
    });
    if (!is_open || sight.plane == nullptr) return;
    const double behind = sight_tuning.behind * sight.solid.diagonal;
    for (std::size_t i = 0; i < places.size(); ++i) // The area of the cut is solid, so it hides the places beyond it.
        if (sight.plane->place - glm::dot(places[i], sight.plane->normal) > behind && is_in_cut(sight, places[i]))
            hidden[i] = 1;
}

// Finds whether surface is in front of each place. A ray begins `off` diagonals outside the surface, so that the
// surface at the place does not hide it.
Flags hides(const Sight& sight, const Points& places, double off) {
    Flags hidden(places.size(), 0, &sight.pool);
    const auto at_once = static_cast<std::size_t>(sight_tuning.at_once);
    for (std::size_t begin = 0; begin < places.size(); begin += at_once) {
        const std::size_t end = std::min(begin + at_once, places.size());
        const Points part(places.begin() + static_cast<std::ptrdiff_t>(begin),
                          places.begin() + static_cast<std::ptrdiff_t>(end), &sight.pool);
        hides_some(sight, part, off, hidden.data() + begin);
    }
    return hidden;
}

// ---- Hidden parts

// Returns the line through the places with the given fractional indices, which ascend from 0 to the index of the last
// point.
TracedLine line_at(const TracedLine& line, const Vector<double>& at, Pool& pool) {
    TracedLine made(pool);
    const double last = static_cast<double>(line.hidden.size()) - 0.5;
    for (std::size_t i = 0; i < at.size(); ++i) {
        made.places.push_back(at_number<glm::dvec3>(line.places, at[i]));
        made.points.push_back(at_number<glm::dvec2>(line.points, at[i]));
        if (i + 1 < at.size())
            made.hidden.push_back(line.hidden[static_cast<std::size_t>(std::min((at[i] + at[i + 1]) / 2.0, last))]);
    }
    return made;
}

// Returns the integer indices of the line's points together with other, fractional indices, in ascending order.
Vector<double> with_numbers(const TracedLine& line, std::span<const double> others, Pool& pool) {
    Vector<double> numbers(&pool);
    for (std::size_t i = 0; i < line.points.size(); ++i) numbers.push_back(static_cast<double>(i));
    numbers.insert(numbers.end(), others.begin(), others.end());
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

// Inserts points into the line where it becomes hidden or visible. `is_hidden` is the state at its beginning.
TracedLine cut_at(const TracedLine& line, std::span<const double> cuts, bool is_hidden, Pool& pool) {
    HRBFNPR_ASSERT(std::is_sorted(cuts.begin(), cuts.end()));
    const Vector<double> at = with_numbers(line, cuts, pool);
    TracedLine made = line_at(line, at, pool);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const auto turns = std::upper_bound(cuts.begin(), cuts.end(), at[i]) - cuts.begin();
        made.hidden[i] = (turns % 2 == 1) != is_hidden ? 1 : 0;
    }
    return made;
}

// The places on lines from which rays are cast, each with the index of its line.
struct AskedPlaces {
    Vector<std::size_t> line;
    Vector<double> number; // fractional indices of the line's points
    Points places;
};

AskedPlaces places_to_ask(const TracedLines& lines, Pool& pool) {
    AskedPlaces asked{Vector<std::size_t>(&pool), Vector<double>(&pool), Points(&pool)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Vector<double> along = lengths_along(lines[i].points, pool);
        Vector<double> numbers(&pool);
        for (std::size_t k = 0; k < along.size(); ++k) numbers.push_back(static_cast<double>(k));
        for (const double length : evenly(0.0, along.back(), count_on(along.back(), tuned_lines.asked), pool)) {
            asked.line.push_back(i);
            asked.number.push_back(interpolated<double>(along, numbers, length));
            asked.places.push_back(at_number<glm::dvec3>(lines[i].places, asked.number.back()));
        }
    }
    return asked;
}

// Finds the hidden parts of the lines by rays. All rays are cast together, which is much faster.
TracedLines asked_lines(const TracedLines& lines, const Sight& sight, double off) {
    Pool& pool = sight.pool;
    TracedLines made(&pool);
    if (lines.empty()) return made;
    const AskedPlaces asked = places_to_ask(lines, pool);
    const Flags hidden = hides(sight, asked.places, off);
    Vector<std::size_t> changes(&pool); // indices of the places between which visibility changes
    for (std::size_t i = 0; i + 1 < hidden.size(); ++i)
        if (hidden[i] != hidden[i + 1] && asked.line[i] == asked.line[i + 1]) changes.push_back(i);
    Vector<double> low(changes.size(), 0.0, &pool);
    Vector<double> high(changes.size(), 1.0, &pool);
    for (int turn = 0; turn < tuned_lines.halvings && !changes.empty(); ++turn) {
        Points between(&pool);
        for (std::size_t i = 0; i < changes.size(); ++i) {
            const glm::dvec3& from = asked.places[changes[i]];
            between.push_back(from + (low[i] + high[i]) / 2.0 * (asked.places[changes[i] + 1] - from));
        }
        const Flags found = hides(sight, between, off);
        for (std::size_t i = 0; i < changes.size(); ++i)
            (found[i] == hidden[changes[i]] ? low[i] : high[i]) = (low[i] + high[i]) / 2.0;
    }
    Vector<double> cuts(&pool);
    std::size_t place = 0;
    std::size_t change = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const bool is_hidden = hidden[place] != 0;
        cuts.clear();
        for (; change < changes.size() && asked.line[changes[change]] == i; ++change) {
            const double from = asked.number[changes[change]];
            cuts.push_back(from + (low[change] + high[change]) / 2.0 * (asked.number[changes[change] + 1] - from));
        }
        std::sort(cuts.begin(), cuts.end()); // Rounding may have changed the order of the cuts.
        made.push_back(cut_at(lines[i], cuts, is_hidden, pool));
        while (place < asked.line.size() && asked.line[place] == i) ++place;
    }
    return made;
}

// Adds the parts of a line that are behind a cutting plane, as the viewer of the section sees it.
void add_parts_behind(const TracedLine& line, const CutPlane& plane, TracedLines& to, Pool& pool) {
    Vector<double> away(&pool);
    for (const glm::dvec3& place : line.places) away.push_back(glm::dot(place, plane.normal) - plane.place);
    Vector<double> crossings(&pool);
    for (std::size_t i = 0; i + 1 < away.size(); ++i)
        if ((away[i] <= 0.0) != (away[i + 1] <= 0.0))
            crossings.push_back(static_cast<double>(i) + away[i] / (away[i] - away[i + 1]));
    const TracedLine whole = line_at(line, with_numbers(line, crossings, pool), pool);
    const double rounding = 1e-9 * std::max(1.0, std::abs(plane.place));
    const auto is_behind = [&](std::size_t i) {
        return glm::dot(whole.places[i], plane.normal) - plane.place <= rounding;
    };
    for (std::size_t begin = 0; begin + 1 < whole.points.size(); ++begin) {
        std::size_t end = begin;
        while (end + 1 < whole.points.size() && is_behind(end) && is_behind(end + 1)) ++end;
        if (end == begin) continue;
        TracedLine part(pool);
        for (std::size_t i = begin; i <= end; ++i) {
            part.places.push_back(whole.places[i]);
            part.points.push_back(whole.points[i]);
            if (i < end) part.hidden.push_back(whole.hidden[i]);
        }
        to.push_back(std::move(part));
        begin = end;
    }
}

TracedLines parts_behind(const TracedLines& lines, const CutPlane& plane, Pool& pool) {
    TracedLines parts(&pool);
    for (const TracedLine& line : lines) add_parts_behind(line, plane, parts, pool);
    return parts;
}

// ---- All lines of a view

TracedLines creases_in(const SheetView& view, const Solid& solid, double scale, Pool& pool) {
    TracedLines lines(&pool);
    solid.for_surfaces([&](const Solid& surface) {
        for (const Points& crease : surface.creases) {
            TracedLine line(pool);
            line.places.assign(crease.begin(), crease.end());
            for (const glm::dvec3& place : crease) line.points.push_back(scale * view.flat(place, solid.middle));
            line.hidden.assign(crease.size() - 1, 0);
            lines.push_back(std::move(line));
        }
    });
    return lines;
}

// Moves all lines of one kind from `found` to the end of `to`.
void take_kind(LinesByKind& found, std::uint32_t kind, TracedLines& to) {
    const auto lines = found.find(kind);
    if (lines == found.end()) return;
    for (TracedLine& line : lines->second) to.push_back(std::move(line));
    found.erase(lines);
}

void add_curves(TracedLines&& lines, int rank, double reach, double lift, ViewClass of_class, ViewLines& to,
                Pool& pool) {
    for (TracedLine& line : lines) {
        ViewCurve curve(pool);
        curve.points = std::move(line.points);
        curve.hidden = std::move(line.hidden);
        curve.places = std::move(line.places);
        curve.rank = rank;
        curve.reach = reach;
        curve.lift = lift;
        curve.of_class = of_class;
        to.curves.push_back(std::move(curve));
    }
}

double size_of_line(const PaperLine& points) noexcept {
    glm::dvec2 low = points.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return glm::length(high - low);
}

} // namespace

Vector<Points> without_loose_edges(Vector<Points> creases, double diagonal, Pool& pool) {
    const auto less = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    // For each end of an edge: the number of edges that end there.
    Map<glm::dvec3, int, decltype(less)> uses(less, &pool);
    for (const Points& line : creases) {
        HRBFNPR_ASSERT(line.size() > 1);
        ++uses[line.front()];
        ++uses[line.back()];
    }
    const auto is_loose = [&](const Points& line) {
        return std::min(uses[line.front()], uses[line.back()]) <= 1 &&
               !(length_of_line(line) > tuned_lines.shortest_edge * diagonal);
    };
    creases.erase(std::remove_if(creases.begin(), creases.end(), is_loose), creases.end());
    return creases;
}

ViewLines lines_of_view(const SheetView& view, const Vector<CutPlane>& planes, const Solid& solid, double scale,
                        hrbfnpr_operation* operation, Pool& pool) {
    HRBFNPR_ASSERT(!view.is_section() || view.plane < planes.size());
    HRBFNPR_ASSERT(scale > 0.0 && solid.diagonal > 0.0);
    const CutPlane* const plane = view.is_section() ? &planes[view.plane] : nullptr;
    const hrbfnpr_camera camera = camera_of_view(view, solid, scale);
    const Drawing drawing =
        draw_view_lines(view, plane != nullptr ? plane->name.c_str() : nullptr, solid, camera, operation, pool);
    LinesByKind found = traced_lines(drawing, std::ceil(camera.viewport[0] + camera.viewport[2]), pool);

    ViewLines made(pool);
    TracedLines sections(&pool);
    take_kind(found, HRBFNPR_LINE_KIND_SECTION, sections);
    Vector<PaperLine> closed(&pool);
    for (const TracedLine& line : sections) {
        if (solid.is_shell || !is_round(line)) continue;
        PaperLine& outline = closed.emplace_back();
        for (const glm::dvec2& p : line.points) outline.push_back(p / scale);
    }
    const Sight sight{solid, solid, view, plane, closed, operation, pool};

    TracedLines contours(&pool);
    for (const std::uint32_t kind : {HRBFNPR_LINE_KIND_CONTOUR, HRBFNPR_LINE_KIND_BORDER, HRBFNPR_LINE_KIND_CREASE,
                                     HRBFNPR_LINE_KIND_INTERSECTION})
        take_kind(found, kind, contours);
    TracedLines smooth(&pool);
    for (const std::uint32_t kind : solid.smooth) take_kind(found, kind, smooth);
    TracedLines tangents(&pool);
    take_kind(found, HRBFNPR_LINE_KIND_TANGENT_EDGE, tangents);
    TracedLines creases = creases_in(view, solid, scale, pool);
    if (plane != nullptr) {
        contours = asked_lines(parts_behind(contours, *plane, pool), sight, tuned_lines.off_surface);
        creases = parts_behind(creases, *plane, pool);
        smooth = asked_lines(parts_behind(smooth, *plane, pool), sight, tuned_lines.off_surface);
        tangents = asked_lines(parts_behind(tangents, *plane, pool), sight, tuned_lines.off_edge);
    }
    const bool has_edges = !creases.empty();
    creases = asked_lines(creases, sight, tuned_lines.off_edge);

    if (has_edges)
        contours.erase(std::remove_if(contours.begin(), contours.end(),
                                      [](const TracedLine& line) {
                                          return !(size_of_line(line.points) > tuned_lines.smallest_contour);
                                      }),
                       contours.end());
    const double beside =
        std::max(view_order_tuning.reach, tuned_lines.near_edge * solid.diagonal * (scale * view.factor));
    const double off_edge = tuned_lines.off_edge * solid.diagonal;
    const double off_surface = tuned_lines.off_surface * solid.diagonal;
    add_curves(std::move(creases), 1, beside, off_edge, ViewClass::edge, made, pool);
    add_curves(std::move(contours), 2, view_order_tuning.reach, off_surface, ViewClass::edge, made, pool);
    add_curves(std::move(tangents), 3, view_order_tuning.reach, off_surface, ViewClass::tangent, made, pool);
    add_curves(std::move(smooth), 4, view_order_tuning.smooth_reach, off_surface, ViewClass::smooth, made, pool);
    if (solid.is_verified) made.proof = verify_curves(made.curves, view, plane, solid, scale, operation, pool);
    for (const TracedLine& line : sections) {
        ViewCurve curve(pool);
        curve.points.assign(line.points.begin(), line.points.end());
        curve.hidden.assign(line.points.size() - 1, 0);
        curve.rank = 0;
        made.curves.push_back(std::move(curve));
        made.outlines.emplace_back(line.points.begin(), line.points.end());
    }
    return made;
}

} // namespace hrbfnpr::picture

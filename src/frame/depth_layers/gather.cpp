// SPDX-License-Identifier: MIT
// gather, step by step:
//
// 1. set_up_items: how each item is seen, how much ink it has, and what its layers let through
// 2. add_tasks: divides the clusters of each run into tasks
// 3. ask_tones: tau of the marks whose tone a callback gives
// 4. gather_cluster, on threads: skips clusters outside the picture; makes splats of a cluster's first marks
//    (add_splats), and ink of the marks that the tone selects (add_dots)
#include "frame/depth_layers/gather.h"

#include "base/prefetch.h"
#include "base/scratch.h"
#include "frame/depth_layers/tuning.h"

#include <bit>
#include <numbers>

namespace hrbfnpr::frame {
namespace {

using marks::MarkBlock;

constexpr std::int64_t clusters_a_task = 64; // A task has this many clusters. A cluster has at most 128 marks.

// ---- Items

[[nodiscard]] TransmittanceTable transmittance_table(const ItemView& item) noexcept {
    TransmittanceTable table{};
    for (std::size_t i = 0; i <= TransmittanceTable::steps; ++i) {
        const float nu = static_cast<float>(i) / TransmittanceTable::steps;
        table.front[i] = layer_transmittance(item.style, -nu, item.both_sides);
        table.back[i] = layer_transmittance(item.style, nu, item.both_sides);
    }
    table.halo = layer_transmittance(item.style, layer_tuning.halo_angle, false);
    return table;
}

// Returns whether two items have the same table of transmittances.
[[nodiscard]] bool have_same_transmittance(const ItemView& one, const ItemView& other) noexcept {
    const Style& a = one.style;
    const Style& b = other.style;
    return one.both_sides == other.both_sides && a.hidden_lines == b.hidden_lines &&
           a.attenuation_front == b.attenuation_front && a.attenuation_back == b.attenuation_back &&
           a.splat_overlap == b.splat_overlap;
}

// Returns the ink of an item. `first` is the index of the item's first run.
[[nodiscard]] ItemInk ink_of(const Scene& scene, std::int64_t first, base::Array<ItemInk::Term>& terms) {
    ItemInk ink;
    ink.first = terms.size();
    bool even = true;
    float lines = 0.0F;
    for (std::int64_t r = first; r < scene.runs.size() && scene.runs[r].item == scene.runs[first].item; ++r) {
        const Run& run = scene.runs[r];
        // The marks of hatching are not counted, because the widths of its lines make its tone. The marks of runs that
        // make no tone are not counted either.
        if (!run.draws_front || !run.makes_tone || run.shape == Shape::hatch) continue;
        // The strokes of blue-noise hatching have one direction. Other strokes have two directions, each with half of
        // the marks.
        const bool has_one = run.is_scattered() || (run.is_even() && run.marks->kind == marks::Kind::hatch);
        const float spacing = run.discs.spacing;
        ItemInk::Term term{&run.discs,
                           (has_one || run.directions == 3U ? 1.0F : 0.5F) * run.style->share / (spacing * spacing)};
        // Lines with the same direction are one separation apart.
        if (run.discs.separation > 0.0F) term.step = (has_one ? 1.0F : 2.0F) * spacing * spacing / run.discs.separation;
        if (!run.is_scattered()) lines += has_one || run.directions != 3U ? 1.0F : 2.0F;
        terms.push_back(term);
        even = even && run.is_even();
    }
    ink.end = terms.size();
    const Overlap overlap = !even ? Overlap::random : lines > 0.0F ? Overlap::lines : Overlap::blue_noise;
    const float layers = lines + (ink.end - ink.first > 1 ? 1.0F : 0.0F);
    for (std::size_t i = 0; i < ink.needed.size(); ++i)
        ink.needed[i] = ink_for(static_cast<float>(i) / needed_steps, overlap, layers);
    return ink;
}

void set_up_items(const Scene& scene, Gathering& all) {
    all.frustum = frustum_of(scene.lens);
    for (std::size_t i = 0; i < all.flat_places.size(); ++i)
        all.flat_places[i] = flat_place(static_cast<float>(i) / needed_steps);
    base::resize_scratch(all.sights, scene.items.size());
    base::resize_scratch(all.inks, scene.items.size());
    base::resize_scratch(all.transmittance_of, scene.items.size());
    all.terms.clear();
    all.transmittances.clear();
    for (std::int64_t i = 0; i < scene.items.size(); ++i) {
        all.sights[i] = sight_of(scene.items[i], scene.lens, all.frustum);
        if (i == 0 || !have_same_transmittance(scene.items[i], scene.items[i - 1]))
            all.transmittances.push_back(transmittance_table(scene.items[i]));
        all.transmittance_of[i] = static_cast<std::int32_t>(all.transmittances.size() - 1);
    }
    for (std::int64_t r = 0; r < scene.runs.size(); ++r)
        if (r == 0 || scene.runs[r - 1].item != scene.runs[r].item)
            all.inks[scene.runs[r].item] = ink_of(scene, r, all.terms);
}

[[nodiscard]] float ink_per_pixel(std::span<const ItemInk::Term> terms, float pixels_per_unit) noexcept {
    float ink = 0.0F;
    for (const ItemInk::Term& t : terms) {
        const float radius = t.discs->front_ink(pixels_per_unit);
        float area = disc_ink(radius);
        // The discs along a stroke overlap and form a line.
        if (t.step > 0.0F) area = std::min(area, 2.0F * radius * t.step * pixels_per_unit);
        ink += t.marks_per_area * area;
    }
    return ink / (pixels_per_unit * pixels_per_unit);
}

// ---- Tasks and tones

// Adds the tasks. Returns the number of marks that are in no task. Hatching has separate code for its marks, so a run
// of hatching is in a task only if its marks are splats.
std::int64_t add_tasks(const Scene& scene, base::Array<GatherTask>& tasks) {
    tasks.clear();
    std::int64_t unused = 0;
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        const bool is_used = run.shape != Shape::hatch || run.splats;
        const std::int64_t clusters = is_used ? run.clusters->cluster.size() : 0;
        if (!is_used) unused += run.count;
        for (std::int64_t c = 0; c < clusters; c += clusters_a_task)
            tasks.push_back({r, c, std::min(c + clusters_a_task, clusters)});
    }
    return unused;
}

// Asks the callback for the tones of those marks in a cluster that may show as ink.
void ask_cluster(const Scene& scene, const ProjectionLoops& loops, const Run& run, const marks::Cluster& cluster,
                 Gathering& all) {
    const ItemSight& sight = all.sights[run.item];
    const ClusterView view = view_cluster(cluster, sight, scene.lens, all.frustum);
    if (!run.draws_direction(cluster.direction) || view.beyond > scene.lens.diagonal || view.nu_min > 0.0F) return;
    const MarkBlock* const blocks = run.clusters->block.data() + cluster.block;
    ProjectedMarks projected;
    loops.project(sight.view_transform, {blocks, cluster.count}, projected);
    for (std::int64_t i = 0; i < cluster.count; ++i) {
        if (!(projected.pixels_per_unit[i] > 0.0F && projected.nu[i] < 0.0F)) continue;
        const MarkBlock& m = blocks[i / MarkBlock::size];
        const std::int64_t at = i % MarkBlock::size;
        all.tone_calls.add(m.place_at(at), run.tone_normal_of(m.mark[at]),
                           run.first_place + cluster.block * MarkBlock::size + i);
    }
}

void ask_tones(const Scene& scene, const ProjectionLoops& loops, Gathering& all) {
    const auto asks = [&](const Run& run) { return scene.item_of(run).style.tone == Tone::callback; };
    if (!std::any_of(scene.runs.begin(), scene.runs.end(), asks)) return;
    base::resize_scratch(all.tau, scene.place_count());
    // Tones that no callback computes are set to 0, because the loops read them, although they do not use them.
    std::fill(all.tau.begin(), all.tau.end(), 0.0F);
    for (const Run& run : scene.runs) {
        if (!asks(run) || !run.draws_front) continue;
        all.tone_calls.begin(scene.item_of(run), all.tau.data(), 1);
        for (const marks::Cluster& cluster : run.clusters->cluster) ask_cluster(scene, loops, run, cluster, all);
        all.tone_calls.end();
    }
}

// ---- Clusters

// The data for gathering the clusters of a run.
struct RunView {
    const Scene& scene;
    const Run& run;
    const ItemView& item;
    const ItemSight& sight;
    const ItemInk& ink;
    const TransmittanceTable& transmittance;
    const Gathering& all;
    std::uint32_t layer;         // the index of the run's layer in the drawing
    const NearerEdges* contours; // the lines that have halos; NULL if contours are not drawn as lines
};

// Returns whether contours of an item are drawn as lines.
[[nodiscard]] bool draws_contours(const ItemView& item) noexcept {
    const auto is_contour = [](const LineStyle& line) { return line.kind == LineKind::contour; };
    return item.lines != nullptr && std::any_of(item.style.lines.begin(), item.style.lines.end(), is_contour);
}

// Where the next dot and the next splat are stored, and the current counts.
struct GatherOutput {
    Dot* dot;
    EvenMark* even; // NULL if the run is not even in the picture
    Splat* splat;
    Counts counts;
};

// A cluster that may be in the picture.
struct VisibleCluster {
    const marks::Cluster& cluster;
    const MarkBlock* blocks;
    ClusterView view;
    float pixel_curvature; // converts a curvature in the set's unit into one per pixel
    // All marks are in the picture, none is near a contour, and all face the eye or all face away.
    bool is_uniform;
    // Marks with a larger square of n . v are farther from the contour than halos reach.
    float halo_nu_squared;

    [[nodiscard]] std::uint32_t mark(std::int64_t i) const noexcept {
        return blocks[i / MarkBlock::size].mark[i % MarkBlock::size];
    }
};

// Returns an upper bound for the share of front marks that select() shows. `fields` bounds the effects of fields.
[[nodiscard]] float largest_shown_share(const RunView& v, const Selection& selection, const VisibleCluster& visible,
                                        const FieldBounds& fields) noexcept {
    const ClusterView& view = visible.view;
    const Style& style = v.item.style;
    if (selection.is_published || style.tone == Tone::callback) return 1.0F;
    // For other tones, the cone of normals gives no bound.
    const bool is_bounded = style.tone == Tone::light && !v.run.has_tone_normals();
    const Shading* const shading = v.run.shading_of(v.item);
    const SeenShares seen =
        shading != nullptr ? shading->layers[v.run.layer].of_cluster[&visible.cluster - v.run.clusters->cluster.data()]
                           : SeenShares();
    float shown = 1.0F - fields.least_tone(is_bounded ? least_tau(visible.cluster, v.sight, seen) : 0.0F);
    if (selection.coverage) {
        const float nu = std::max(-view.nu_min, -view.nu_max);
        const auto cell = static_cast<std::size_t>(shown * needed_steps);
        const float needed = v.ink.needed[std::min<std::size_t>(cell + 1, needed_steps)];
        shown = std::min(1.0F, needed * nu * selection.per_ink);
        if (v.run.even_in_picture) {
            const bool turns = view.nu_min < 0.0F && view.nu_max > 0.0F;
            const float least = turns ? 0.0F : std::min(std::abs(view.nu_min), std::abs(view.nu_max));
            shown = needed * selection.per_ink * most_shown(std::min(least, 1.0F), std::min(nu, 1.0F));
        }
    }
    return 1.001F * selection.share * selection.fade_factor * fields.most_density * shown + 1e-5F;
}

// Returns the rules for drawing a cluster. `reach` is the largest radius of a mark's disc, including its rim.
[[nodiscard]] Selection selection_of(const RunView& v, const VisibleCluster& visible, float reach) noexcept {
    const glm::vec4& viewport = v.scene.lens.viewport;
    const float pixels_per_unit = visible.view.pixels_per_unit;
    const Style& style = v.item.style;
    Selection selection{};
    selection.left = viewport.x - reach;
    selection.right = viewport.x + viewport.z + reach;
    selection.top = viewport.y - reach;
    selection.bottom = viewport.y + viewport.w + reach;
    selection.all_inside = visible.view.inside;
    selection.is_published = style.tone_rule == ToneRule::published;
    selection.coverage = style.tone_curve == ToneCurve::coverage;
    selection.needed = v.ink.needed.data();
    constexpr auto darkest = static_cast<std::size_t>(scene_tuning.darkest * needed_steps);
    const std::span terms(v.all.terms.data() + v.ink.first, v.all.terms.data() + v.ink.end);
    if (selection.coverage)
        selection.per_ink = 1.0F / std::max(ink_per_pixel(terms, pixels_per_unit), v.ink.needed[darkest]);
    selection.share = v.run.style->share;
    selection.fade = style.tone_fade;
    selection.fade_factor =
        1.0F / (1.0F - 0.5F * selection.fade); // Marks that fade in are small, so more of them are shown.
    selection.scale = v.run.discs.scale(pixels_per_unit);
    // The tone curve by coverage already takes foreshortening into account. With the other tone curves, the ink of
    // front marks fades near the contour.
    const bool vanishes = selection.fade > 0.0F && !selection.coverage && !selection.is_published;
    selection.vanishing_nu = vanishes ? layer_tuning.front_fade : 0.0F;
    selection.flat_places = v.run.even_in_picture ? v.all.flat_places.data() : nullptr;
    return selection;
}

// Returns how many marks of a cluster are shown if the share `shown` of all marks is shown. These are the first marks
// of the cluster.
[[nodiscard]] std::int64_t count_shown(const VisibleCluster& visible, float shown) noexcept {
    if (!(shown > 0.0F)) return 0;
    std::int64_t low = 0;
    std::int64_t high = visible.cluster.count;
    while (low < high) {
        const std::int64_t middle = (low + high) / 2;
        if (1.0F - visible.blocks[middle / MarkBlock::size].rank[middle % MarkBlock::size] <= shown)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

// ---- Splats

[[nodiscard]] float least_splat_spacing(const VisibleCluster& visible) noexcept {
    return visible.is_uniform ? scene_tuning.splat_spacing : scene_tuning.contour_splat_spacing;
}

// Returns how many marks of a cluster are splats. These are the first marks of the cluster.
[[nodiscard]] std::int64_t count_splats(const Run& run, const VisibleCluster& visible) noexcept {
    if (!run.splats) return 0;
    // The first lines of a nested set leave gaps for the other lines, so all marks are needed as splats.
    if (run.marks->kind == marks::Kind::hatch || (!run.is_even() && !run.is_scattered())) return visible.cluster.count;
    const float pixels = run.discs.spacing * visible.view.pixels_per_unit / least_splat_spacing(visible);
    // The comparison is also true for NaN, which occurs if the spacing does not fit into a float.
    if (!(pixels < 1.0F)) return visible.cluster.count;
    // The first marks of a cluster are spread as evenly as the first marks of the layer. If marks that a still picture
    // does not need are missing, the ranks tell which are the first.
    const auto begin = static_cast<float>(run.marks->tone_begin);
    if (run.marks->whole > 0) return count_shown(visible, begin + (1.0F - begin) * pixels * pixels);
    return static_cast<std::int64_t>(std::ceil(pixels * pixels * static_cast<float>(visible.cluster.count)));
}

// Returns an upper bound for the square of n . v of marks that get halos. No curvature of the map is larger than its
// Frobenius norm.
[[nodiscard]] float largest_halo_nu_squared(const marks::NormalVariation& turn, float pixel_curvature) noexcept {
    const auto& s = turn.shape;
    const float squares = s[0] * s[0] + s[3] * s[3] + s[5] * s[5] + 2.0F * (s[1] * s[1] + s[2] * s[2] + s[4] * s[4]);
    return 2.001F * layer_tuning.contour_band * std::sqrt(squares) * pixel_curvature;
}

// Sets the halo of a splat near the contour. The halo starts at the contour, and must not be nearer to the eye than the
// contour's own line, even where the depth along that line changes fast. The contour's direction is conjugate to the
// line of sight, because the normal stays perpendicular to the line of sight along the contour. [Koenderink 1984, "What
// does the occluding contour tell us about solid shape?"]
void set_halo(const RunView& v, const VisibleCluster& visible, const ProjectedMarks& projected, std::int64_t i,
              Splat& c) noexcept {
    const float nu = projected.nu[i];
    const float width = v.item.style.halo_width;
    c.halo = 0.0F;
    // `away` below is at least nu^2 / (2 bend), which is too large for most marks.
    if (!(width > 0.0F) || visible.cluster.max_curvature < 0.0F || nu * nu > visible.halo_nu_squared) return;
    const MarkBlock& m = visible.blocks[i / MarkBlock::size];
    const std::int64_t at = i % MarkBlock::size;
    const glm::vec3 n = m.normal_at(at);
    const glm::vec3 sight = v.sight.view_transform.parallel ? v.sight.eye : m.place_at(at) - v.sight.eye;
    const glm::vec3 w = sight - glm::dot(sight, n) * n; // the line of sight along the surface
    const auto& s = visible.cluster.shape;
    const glm::vec3 turn(s[0] * w.x + s[1] * w.y + s[2] * w.z, s[1] * w.x + s[3] * w.y + s[4] * w.z,
                         s[2] * w.x + s[4] * w.y + s[5] * w.z); // the change of the normal along w
    // The radial curvature in object space; positive where the surface is convex.
    const float curvature = glm::dot(w, turn) / glm::dot(w, w);
    // The surface is taken as a circle of this curvature. `away` is the distance in the picture from the mark to the
    // contour, in pixels. It is infinite where the surface is flat.
    const float bend = std::abs(curvature) * visible.pixel_curvature;
    const float away = nu * nu / ((1.0F + std::sqrt(std::max(0.0F, 1.0F - nu * nu))) * bend);
    if (!(away <= layer_tuning.contour_band)) return;
    const glm::vec3 along = v.item.to_eye * glm::cross(n, turn);
    const float across = std::sqrt(along.x * along.x + along.y * along.y);
    const float slope = -along.z / across;
    const float side = std::sqrt(projected.side_x[i] * projected.side_x[i] + projected.side_y[i] * projected.side_y[i]);
    // There is no halo where the depth changes too fast along the contour, or where the normal has no direction in the
    // picture.
    if (!(std::abs(slope) <= layer_tuning.steepest_contour) || !(side > 0.0F)) return;
    c.halo_transmittance = v.transmittance.halo;
    c.halo_x = c.x + away * projected.side_x[i] / side;
    c.halo_y = c.y - away * projected.side_y[i] / side;
    c.halo = width;
    // The halo ends where the line ends, and narrows where it fades.
    if (v.contours != nullptr)
        c.halo = std::min(width, layer_tuning.halo_per_width *
                                     v.contours->width_near({c.halo_x, c.halo_y}, layer_tuning.farthest_line + width));
    if (!(c.halo > 0.0F)) return;
    // Where the surface bends little, its marks give only a rough distance to the contour. The slack moves the halo
    // away from the eye, so that it is behind the contour's own line and behind surfaces at nearly the same depth.
    const float slack = std::sqrt(2.0F * layer_tuning.contour_band * (1.0F / bend)) + std::abs(slope) * c.halo;
    c.halo_depth = c.depth + -nu * v.sight.scale / curvature + slack / c.pixels_per_unit;
    c.halo_slope_x = slope * along.x / (across * c.pixels_per_unit);
    c.halo_slope_y = -slope * along.y / (across * c.pixels_per_unit);
}

void add_splats(const RunView& v, const VisibleCluster& visible, const ProjectedMarks& projected, std::int64_t count,
                GatherOutput& out) noexcept {
    HRBFNPR_ASSERT(v.run.splats && count > 0 && count <= visible.cluster.count);
    const DiscSizes& discs = v.run.discs;
    const float own = discs.spacing * visible.view.pixels_per_unit;
    const float spacing = v.run.is_scattered() ? std::max(own, least_splat_spacing(visible)) : own;
    const bool even = v.run.is_even() && v.run.is_scattered();
    const float own_radius =
        (even ? layer_tuning.even_splat_radius : layer_tuning.random_splat_radius) * spacing + 0.5F;
    const float given = v.item.style.splat_radius;
    const float radius = std::min(given > 0.0F ? given : own_radius, discs.largest_splat);
    const bool has_items = v.scene.items.size() > 1;
    for (std::int64_t i = 0; i < count; ++i) {
        const float nu = projected.nu[i];
        // For NaN the comparisons are false.
        if (!(projected.pixels_per_unit[i] > 0.0F) || !(std::abs(nu) <= 1.001F) ||
            !(projected.window[i] >= 0.0F && projected.window[i] <= 1.0F))
            continue;
        Splat& c = *out.splat++;
        c.x = projected.x[i];
        c.y = projected.y[i];
        c.radius = radius;
        c.depth = projected.depth[i];
        c.pixels_per_unit = projected.pixels_per_unit[i];
        const float turn = -projected.along[i] / (std::abs(nu) > 1e-3F ? nu : 1e-3F);
        const float x = projected.side_x[i] * turn;
        const float y = -projected.side_y[i] * turn;
        const float slope = std::sqrt(x * x + y * y);
        const float shrink =
            (slope > drawing::steepest_slope ? drawing::steepest_slope / slope : 1.0F) / c.pixels_per_unit;
        c.slope_x = x * shrink;
        c.slope_y = y * shrink;
        c.transmittance = v.transmittance.at(nu);
        if (has_items) c.transmittance = with_item(c.transmittance, v.run.item);
        c.window = projected.window[i];
        set_halo(v, visible, projected, i, c);
        c.id = v.run.first_id + visible.mark(i);
        c.faces_back = nu > 0.0F;
        ++out.counts.splats;
    }
}

// ---- Ink

// Returns tau of the marks. If no callback gave it, it is computed into `scratch`.
[[nodiscard]] const float* tones_of(const RunView& v, const VisibleCluster& visible, const ProjectedMarks& projected,
                                    std::int64_t count, const ProjectionLoops& loops, float* scratch) noexcept {
    const Style& style = v.item.style;
    if (style.tone == Tone::callback)
        return v.all.tau.data() + v.run.first_place + visible.cluster.block * MarkBlock::size;
    if (style.tone != Tone::light) {
        std::fill_n(scratch, count, 0.0F);
        return scratch;
    }
    const Lighting& lighting = v.sight.lighting;
    const Shading* const shading = v.run.shading_of(v.item);
    const std::int64_t first_place = visible.cluster.block * MarkBlock::size;
    if (!v.run.has_tone_normals()) {
        const LightShares shares = shading != nullptr ? shading->in_blocks(v.run.layer, first_place) : LightShares();
        loops.light(lighting, {visible.blocks, count}, projected.nu, shares, scratch);
        return scratch;
    }
    // The normals are scattered in memory.
    MarkBlock block;
    for (std::int64_t first = 0; first < count; first += MarkBlock::size) {
        const MarkBlock& own = visible.blocks[first / MarkBlock::size];
        const std::int64_t size = std::min(count - first, MarkBlock::size);
        for (std::int64_t i = 0; i < size; ++i) {
            const glm::vec3 normal = v.run.tone_normal_of(own.mark[i]);
            block.nx[i] = normal.x;
            block.ny[i] = normal.y;
            block.nz[i] = normal.z;
        }
        const LightShares shares =
            shading != nullptr ? shading->in_blocks(v.run.layer, first_place + first) : LightShares();
        loops.light_rows(lighting, {own.x, own.y, own.z, block.nx, block.ny, block.nz, size}, projected.nu + first,
                         shares, scratch + first);
    }
    return scratch;
}

[[nodiscard]] EvenMark even_mark(const RunView& v, const ProjectedMarks& projected, const Selected& selected,
                                 std::int64_t i, float place) noexcept {
    const glm::vec4& window = v.scene.lens.viewport;
    const glm::vec2 corner(window);
    const glm::vec2 at(projected.x[i], projected.y[i]);
    const glm::vec2 beyond = glm::max(corner - at, at - corner - glm::vec2(window.z, window.w));
    const float facing = std::min(std::abs(projected.nu[i]), 1.0F);
    const float spacing = v.run.discs.spacing * projected.pixels_per_unit[i];
    const float limit = selected.limit[i] * (1.0F - 0.5F * v.item.style.tone_fade);
    const glm::vec2 normal(projected.side_x[i], projected.side_y[i]);
    const float turn = -projected.along[i] / std::min(projected.nu[i], -scene_tuning.smallest_cosine);
    return {place,
            spacing * own_distance(facing) / std::sqrt(std::max(place, 1e-9F)),
            spacing * std::sqrt(facing / std::max(limit, 1e-9F)),
            selected.flat[i],
            selected.limit[i],
            facing,
            normal,
            turn * glm::vec2(normal.x, -normal.y),
            std::max({beyond.x, beyond.y, 0.0F}),
            v.item.style.tone_fade};
}

// Adds the dots of the first `count` marks. `fields` has the effects of fields, or is NULL if the run has none.
void add_dots(const RunView& v, const VisibleCluster& visible, const Selection& selection,
              const ProjectedMarks& projected, std::int64_t count, const FieldRows* fields,
              const ProjectionLoops& loops, GatherOutput& out) noexcept {
    HRBFNPR_ASSERT(v.run.draws_front && count > 0 && count <= visible.cluster.count);
    std::array<float, ProjectedMarks::most> tau;
    const float* tones = tones_of(v, visible, projected, count, loops, tau.data());
    if (v.run.fields.tone != nullptr) {
        for (std::int64_t i = 0; i < count; ++i) tau[static_cast<std::size_t>(i)] = fields->effect[i].tone(tones[i]);
        tones = tau.data();
    }
    const InkChoice* const inks = v.scene.inks_of(v.run);
    std::array<float, ProjectedMarks::most> tau_depth;
    const DepthTone depth_tone(v.item.style, v.scene.lens.eye_per_world);
    for (std::int64_t i = 0; depth_tone.is_on && i < count; ++i)
        tau_depth[static_cast<std::size_t>(i)] = depth_tone(projected.distance[i]);
    Selected selected;
    loops.select(selection, {visible.blocks, count}, projected, tones, fields != nullptr ? fields->density : nullptr,
                 depth_tone.is_on ? tau_depth.data() : nullptr, selected);
    if (!visible.is_uniform) {
        out.counts.outside += selected.outside;
        out.counts.front += selected.fronts;
        out.counts.back += selected.backs;
    }
    out.counts.dropped_tone += selected.dropped_tone;
    out.counts.dropped_zoom += selected.dropped_zoom;
    out.counts.dropped_depth += selected.dropped_depth;
    const base::Array<float>& width = v.run.clusters->width;
    for (std::int64_t first = 0, word = 0; first < count; first += selected.lanes, ++word) {
        for (unsigned bits = selected.drawn[word]; bits != 0; bits &= bits - 1) {
            const std::int64_t i = first + std::countr_zero(bits);
            const std::int64_t place = visible.cluster.block * MarkBlock::size + i;
            const float radius = v.run.discs.front_ink(projected.pixels_per_unit[i]) *
                                 (width.empty() ? 1.0F : width[place]) *
                                 (fields == nullptr ? 1.0F : fields->effect[i].width);
            // The runs of the other side of a surface have opposite normals. The flag refers to the normals of the
            // front side, as for splats.
            const bool faces_back = (projected.nu[i] > 0.0F) != v.run.turned;
            const auto flags = static_cast<std::uint8_t>((faces_back ? dot_faces_back : 0) |
                                                         (v.item.model != nullptr ? dot_is_exact : 0));
            if (out.even != nullptr)
                *out.even++ = even_mark(v, projected, selected, i,
                                        1.0F - visible.blocks[i / MarkBlock::size].rank[i % MarkBlock::size]);
            *out.dot++ = {projected.x[i],
                          projected.y[i],
                          std::sqrt(radius * radius * selected.front[i]),
                          1.0F,
                          projected.depth[i],
                          projected.window[i],
                          projected.pixels_per_unit[i],
                          v.run.first_id + visible.mark(i),
                          v.layer,
                          MarkClass::front,
                          flags,
                          inks == nullptr ? std::uint8_t{0} : inks->of_mark(visible.mark(i), place)};
        }
    }
}

void gather_cluster(const RunView& v, const marks::Cluster& cluster, const ProjectionLoops& loops,
                    GatherOutput& out) noexcept {
    HRBFNPR_ASSERT(cluster.count > 0 && cluster.count <= ProjectedMarks::most);
    const std::int64_t marks = cluster.count;
    Counts& counts = out.counts;
    counts.marks += marks;
    VisibleCluster visible{cluster,
                           v.run.clusters->block.data() + cluster.block,
                           view_cluster(cluster, v.sight, v.scene.lens, v.all.frustum),
                           0.0F,
                           false,
                           0.0F};
    const ClusterView& view = visible.view;
    const float ink = v.run.draws_front ? v.run.discs.front_ink(view.pixels_per_unit) : 0.0F;
    const bool has_widths = v.run.fields.width != nullptr;
    const float margin = v.run.even_in_picture ? layer_tuning.even_margin : 0.0F;
    if (view.beyond > (has_widths ? RunFields::most_factor : 1.0F) * ink + soft_rim + margin) {
        counts.outside += marks;
        return;
    }
    visible.pixel_curvature = 1.0F / (v.sight.scale * view.pixels_per_unit);
    // A mark may be near the contour if its |nu| is at most this, because curvatures are below the cluster's bound.
    const float q = layer_tuning.contour_band * (cluster.max_curvature * visible.pixel_curvature);
    const float rim = q < 1.0F ? std::sqrt(q * (2.0F - q)) : 1.0F;
    const float band = cluster.max_curvature >= 0.0F ? rim : layer_tuning.unknown_rim_nu;
    if (view.inside && view.nu_max < -band) counts.front += marks;
    if (view.inside && view.nu_min > band) counts.back += marks;
    visible.is_uniform = view.inside && (view.nu_max < -band || view.nu_min > band);
    visible.halo_nu_squared = largest_halo_nu_squared(cluster, visible.pixel_curvature);
    const bool tone = v.run.draws_front && v.run.shape != Shape::hatch && v.run.draws_direction(cluster.direction) &&
                      view.nu_min < 0.0F;
    FieldRows rows;
    FieldBounds fields;
    const bool has_fields = tone && v.run.fields.any();
    if (has_fields)
        fields = v.run.fields.effects_on(
            marks, [&](std::int64_t i) { return visible.mark(i); }, rows);
    const Selection selection = selection_of(v, visible, fields.most_width * ink + soft_rim + margin);
    const std::int64_t inks = tone ? count_shown(visible, largest_shown_share(v, selection, visible, fields)) : 0;
    if (!visible.is_uniform)
        counts.culled += marks - inks;
    else if (tone)
        counts.dropped_tone += marks - inks;
    const std::int64_t splats = count_splats(v.run, visible);
    if (std::max(splats, inks) == 0) return;
    ProjectedMarks projected;
    loops.project(v.sight.view_transform, {visible.blocks, std::max(splats, inks)}, projected);
    if (splats > 0) add_splats(v, visible, projected, splats, out);
    if (inks > 0) add_dots(v, visible, selection, projected, inks, has_fields ? &rows : nullptr, loops, out);
}

} // namespace

void gather(const base::Runtime& runtime, const Scene& scene, const NearerEdges& edges, Gathering& all,
            drawing::Drawing& drawing) {
    const ProjectionLoops loops = projection_loops(runtime.instruction_set);
    set_up_items(scene, all);
    const std::int64_t unused = add_tasks(scene, all.tasks);
    ask_tones(scene, loops, all);
    base::resize_scratch(drawing.dots, scene.place_count());
    base::resize_scratch(drawing.splats, scene.place_count());
    const bool any_even =
        std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& r) { return r.even_in_picture; });
    base::resize_scratch(all.even, any_even ? scene.place_count() : 0);
    base::resize_scratch(drawing.dot_ranges, all.tasks.size());
    base::resize_scratch(drawing.splat_ranges, all.tasks.size());
    base::resize_scratch(all.counts, all.tasks.size());
    runtime.parallel.for_each(all.tasks.size(), [&](std::int64_t i) {
        const GatherTask& task = all.tasks[i];
        const Run& run = scene.runs[task.run];
        const marks::MarkClusters& clusters = *run.clusters;
        const RunView view{scene,
                           run,
                           scene.item_of(run),
                           all.sights[run.item],
                           all.inks[run.item],
                           all.transmittances[all.transmittance_of[run.item]],
                           all,
                           static_cast<std::uint32_t>(task.run),
                           draws_contours(scene.item_of(run)) ? &edges : nullptr};
        const std::int64_t place = run.first_place + clusters.cluster[task.begin].block * MarkBlock::size;
        GatherOutput out{drawing.dots.data() + place,
                         run.even_in_picture ? all.even.data() + place : nullptr,
                         drawing.splats.data() + place,
                         {}};
        for (std::int64_t c = task.begin; c < task.end; ++c) {
            if (c + 4 < clusters.cluster.size()) base::prefetch(&clusters.block[clusters.cluster[c + 4].block], 1);
            gather_cluster(view, clusters.cluster[c], loops, out);
        }
        drawing.dot_ranges[i] = {place, out.dot - drawing.dots.data()};
        drawing.splat_ranges[i] = {place, out.splat - drawing.splats.data()};
        all.counts[i] = out.counts;
    });
    drawing.counts = {};
    drawing.counts.marks = drawing.counts.culled = unused;
    for (const Counts& counts : all.counts) drawing.counts += counts;
}

} // namespace hrbfnpr::frame

// SPDX-License-Identifier: MIT
#include "frame/depth_layers/gatherer.h"

#include "base/prefetch.h"
#include "frame/scene/splat_law.h"
#include "frame/scene/tone.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr std::size_t darkest_step = needed_steps * 6 / 10;

using marks::MarkBlock;

// Marks within this many pixels of the contour are near it. Larger: more splats beside contours.
constexpr float rim_width = 1.05F;
// Marks of a larger |n . v| are not near a contour, whatever the curvature.
constexpr float widest_band = 0.9F;
// ... nor are marks of a larger |n . v| than this where the curvature is not known.
constexpr float unknown_band = 0.2F;
// Dot of the front vanishes towards the contour over this much of n . v, where nothing else makes it vanish.
constexpr float front_fade = 0.08F;
// A halo goes out from marks within this many pixels of the contour.
constexpr float halo_band = 1.0F;
// A contour that runs into the depth more steeply has no halo.
constexpr float steepest_contour = 8.0F;

} // namespace

Gatherer::Gatherer(Gather& all, const Scene& scene, const Run& run, std::int32_t run_number, Dot* inks,
                   Splat* splats) noexcept
    : all_(all), scene_(scene), run_(run), item_(scene.item_of(run)), style_(item_.style),
      sight_(all.sights_[run.item]), item_ink_(all.item_inks_[run.item]),
      transmittance_(all.transmittances_[all.transmittance_of_[run.item]]), marks_(*run.clusters),
      layer_(2U * static_cast<std::uint32_t>(run_number)), selection_(common_selection()), ink_(inks), splat_(splats) {}

Selection Gatherer::common_selection() const noexcept {
    Selection selection{};
    selection.by_published = style_.tone_rule == ToneRule::published;
    selection.coverage = style_.tone_curve == ToneCurve::coverage;
    selection.needed = item_ink_.needed.data();
    selection.share = run_.style->share;
    selection.fade = style_.tone_fade;
    selection.more = 1.0F / (1.0F - 0.5F * selection.fade); // marks that fade in are small
    // Coverage counts on foreshortening; else the ink of the front vanishes where it turns away.
    selection.turn = selection.fade > 0.0F && !selection.coverage && !selection.by_published ? front_fade : 0.0F;
    return selection;
}

// The largest disc that a mark can bring decides whether it can reach the viewport.
float Gatherer::reach(float pixels_per_unit) const noexcept {
    return (run_.draws_front ? run_.pen.front_ink(pixels_per_unit) : 0.0F) + soft_rim;
}

Gatherer::Local Gatherer::local_of(const marks::Cluster& cluster) const noexcept {
    Local local{&cluster, {}, selection_};
    const float reach_there = reach(pixels_per_unit_at(cluster, sight_, scene_.lens));
    local.view = view_cluster(cluster, sight_, scene_.lens, all_.frustum_, reach_there);
    const ClusterView& view = local.view;
    Selection& selection = local.selection;
    const glm::vec4& v = scene_.lens.viewport;
    selection.left = v.x - reach_there;
    selection.right = v.x + v.z + reach_there;
    selection.top = v.y - reach_there;
    selection.bottom = v.y + v.w + reach_there;
    selection.all_inside = view.inside;
    selection.front_ink =
        run_.draws_front && !run_.as_hatch && (run_.directions == 3U || (run_.directions >> cluster.set & 1U) != 0);
    selection.scale = run_.pen.scale(view.pixels_per_unit);
    if (selection.coverage)
        // Marks that cover less than 0.6 are shown as if they covered that: their dark tones still differ.
        selection.per_ink =
            1.0F / std::max(all_.ink_per_pixel(item_ink_, view.pixels_per_unit), item_ink_.needed[darkest_step]);
    set_rim(local);
    selection.most_shown = most_shown(local);
    return local;
}

void Gatherer::set_rim(Local& local) const noexcept {
    const marks::Cluster& cluster = *local.cluster;
    local.pixel_curvature = 1.0F / (sight_.scale * local.view.pixels_per_unit);
    local.rim_band = cluster.bend >= 0.0F
                         ? std::min(contour_band(rim_width, cluster.bend * local.pixel_curvature), widest_band)
                         : unknown_band;
}

void Gatherer::operator()(const marks::Cluster& cluster) noexcept {
    const std::int64_t marks = cluster.count;
    info_.marks += marks;
    Local local = local_of(cluster);
    if (local.view.outside) {
        info_.outside += marks;
        return;
    }
    const bool whole = count_whole(local);
    local.splat_spacing = whole ? splat_spacing : contour_splat_spacing;
    const std::int64_t splats = splats_of(local);
    const bool tone = local.selection.front_ink && local.view.nu_min < 0.0F;
    const std::int64_t inks = tone ? shown_of(cluster, local.selection.most_shown) : 0;
    if (!whole)
        info_.culled += marks - inks;
    else if (tone)
        info_.dropped_tone += marks - inks;
    const std::int64_t count = std::max(splats, inks);
    if (count == 0) return;
    Seen seen;
    all_.loops_.see(sight_.seer, {marks_.block.data() + cluster.block, count}, seen);
    if (splats > 0) splat(local, seen, splats);
    if (inks > 0) ink(local, seen, inks, whole);
}

void Gatherer::expect(std::int64_t cluster) const noexcept {
    if (cluster >= marks_.cluster.size()) return;
    base::prefetch(&marks_.block[marks_.cluster[cluster].block], 1);
}

// Whether all marks of the cluster are of one class, which is then counted.
bool Gatherer::count_whole(const Local& local) noexcept {
    if (!local.view.inside) return false;
    const bool front = local.view.nu_max < -local.rim_band;
    const bool back = local.view.nu_min > local.rim_band;
    if (front) info_.front += local.cluster->count;
    if (back) info_.back += local.cluster->count;
    return front || back;
}

// How many of a cluster's marks are among the share `shown` of all.
std::int64_t Gatherer::shown_of(const marks::Cluster& cluster, float shown) const noexcept {
    if (!(shown > 0.0F)) return 0;
    const MarkBlock* const blocks = marks_.block.data() + cluster.block;
    std::int64_t low = 0;
    std::int64_t high = cluster.count;
    while (low < high) {
        const std::int64_t middle = (low + high) / 2;
        if (1.0F - blocks[middle / MarkBlock::size].rank[middle % MarkBlock::size] <= shown)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

// A bound on what select() shows of the front.
float Gatherer::most_shown(const Local& local) const noexcept {
    const Selection& selection = local.selection;
    if (selection.by_published || style_.tone == Tone::callback) return 1.0F;
    // Without the fill light, which no cluster need have everywhere.  Its cone holds no normals for tone.
    const float tau = style_.tone == Tone::light && !run_.has_tone_normals()
                          ? light_tone(local.view.lit_min, static_cast<float>(style_.tone_exponent))
                          : 0.0F;
    float shown = 1.0F - tau;
    if (selection.coverage) {
        const float nu = std::max(-local.view.nu_min, -local.view.nu_max);
        const auto cell = static_cast<std::size_t>(shown * needed_steps);
        const float needed = item_ink_.needed[std::min<std::size_t>(cell + 1, needed_steps)];
        shown = std::min(1.0F, needed * nu * selection.per_ink);
    }
    return 1.001F * selection.share * selection.more * shown + 1e-5F;
}

std::int64_t Gatherer::splats_of(const Local& local) const noexcept {
    if (!run_.splats) return 0;
    // The first of nested lines leave the others' places open.
    if (run_.marks->kind == marks::Kind::hatch || (!run_.spread_evenly && !run_.scattered)) return local.cluster->count;
    const float pixels = run_.pen.spacing * local.view.pixels_per_unit / local.splat_spacing;
    if (!(pixels < 1.0F)) return local.cluster->count; // NaN: of a spacing that floats do not hold
    // The first of a cluster are as even as the first of all.
    return static_cast<std::int64_t>(std::ceil(pixels * pixels * static_cast<float>(local.cluster->count)));
}

void Gatherer::splat(const Local& local, const Seen& seen, std::int64_t count) noexcept {
    const float spacing = run_.scattered ? std::max(run_.pen.spacing * local.view.pixels_per_unit, local.splat_spacing)
                                         : run_.pen.spacing * local.view.pixels_per_unit;
    const bool even = run_.spread_evenly && run_.scattered;
    const float own_radius = (even ? even_splat : random_splat) * spacing + 0.5F;
    const float radius =
        std::min(run_.pen.splat_radius > 0.0F ? run_.pen.splat_radius : own_radius, run_.pen.largest_splat);
    const MarkBlock* const blocks = marks_.block.data() + local.cluster->block;
    for (std::int64_t i = 0; i < count; ++i) {
        const float nu = seen.nu[i];
        if (!(seen.pixels_per_unit[i] > 0.0F) || !(std::abs(nu) <= 1.001F) ||
            !(seen.window[i] >= 0.0F && seen.window[i] <= 1.0F))
            continue;
        Splat& c = *splat_++;
        c.x = seen.x[i];
        c.y = seen.y[i];
        c.radius = radius;
        c.depth = seen.depth[i];
        c.pixels_per_unit = seen.pixels_per_unit[i];
        const float turn = -seen.along[i] / (std::abs(nu) > 1e-3F ? nu : 1e-3F);
        const float x = seen.side_x[i] * turn;
        const float y = -seen.side_y[i] * turn;
        const float slope = std::sqrt(x * x + y * y);
        const float shrink = (slope > drawing::steepest ? drawing::steepest / slope : 1.0F) / c.pixels_per_unit;
        c.slope_x = x * shrink;
        c.slope_y = y * shrink;
        c.transmittance = transmittance_.at(nu);
        if (scene_.items.size() > 1) c.transmittance = of_item(c.transmittance, run_.item);
        c.window = seen.window[i];
        set_halo(c, local, seen, i);
        c.id = run_.first_id + blocks[i / MarkBlock::size].mark[i % MarkBlock::size];
        c.faces_back = nu > 0.0F;
        ++info_.splats;
    }
}

Gatherer::Rim Gatherer::rim_of(const Local& local, std::int64_t i) const noexcept {
    const MarkBlock& m = marks_.block[local.cluster->block + i / MarkBlock::size];
    const std::int64_t at = i % MarkBlock::size;
    const glm::vec3 n(m.nx[at], m.ny[at], m.nz[at]);
    const glm::vec3 v = sight_.seer.parallel ? sight_.eye : glm::vec3(m.x[at], m.y[at], m.z[at]) - sight_.eye;
    return {n, v, radial_curvature(*local.cluster, n, v)};
}

// A halo goes out from the contour, and may be nowhere in front of its own line, which may run into the depth.
void Gatherer::set_halo(Splat& c, const Local& local, const Seen& seen, std::int64_t i) const noexcept {
    const float nu = seen.nu[i];
    c.halo = 0.0F;
    if (!(style_.halo_width > 0.0F) || !(std::abs(nu) <= widest_band) || local.cluster->bend < 0.0F) return;
    const Rim rim = rim_of(local, i);
    const float away = contour_distance(nu, std::abs(rim.curvature) * local.pixel_curvature);
    if (!(away <= halo_band)) return;
    const glm::vec3 along = item_.to_eye * contour_direction(*local.cluster, rim.normal, rim.sight);
    const float across = std::sqrt(along.x * along.x + along.y * along.y);
    const float slope = -along.z / across;
    const float side = std::sqrt(seen.side_x[i] * seen.side_x[i] + seen.side_y[i] * seen.side_y[i]);
    if (!(std::abs(slope) <= steepest_contour) || !(side > 0.0F)) return; // it ends here
    c.halo = style_.halo_width;
    c.halo_transmittance = transmittance_.halo;
    c.halo_x = c.x + away * seen.side_x[i] / side;
    c.halo_y = c.y - away * seen.side_y[i] / side;
    // Where a surface bends little, its marks tell little of how far away the contour is: its own line stays before
    // the halo, and so does what is hardly behind.
    const float pixel_radius = 1.0F / (std::abs(rim.curvature) * local.pixel_curvature);
    const float slack = std::sqrt(2.0F * halo_band * pixel_radius) + std::abs(slope) * c.halo;
    c.halo_depth = c.depth + to_rim(rim, nu) + slack / c.pixels_per_unit;
    c.halo_slope_x = slope * along.x / (across * c.pixels_per_unit);
    c.halo_slope_y = -slope * along.y / (across * c.pixels_per_unit);
}

// How much farther than the mark its contour is: n . v turns with the curvature along the line of sight.
float Gatherer::to_rim(const Rim& rim, float nu) const noexcept { return -nu * sight_.scale / rim.curvature; }

const float* Gatherer::taus(const Local& local, const Seen& seen, std::int64_t count, float* scratch) const noexcept {
    if (style_.tone == Tone::callback)
        return all_.tau_.data() + run_.first_place + local.cluster->block * MarkBlock::size;
    const LightTone tone(style_);
    const MarkBlock* const blocks = marks_.block.data() + local.cluster->block;
    const auto lit = [&](std::int64_t i) {
        if (!run_.has_tone_normals()) return seen.lit[i];
        return lit_of(item_, sight_.seer, run_.tone_normal_of(blocks[i / MarkBlock::size].mark[i % MarkBlock::size]));
    };
    for (std::int64_t i = 0; i < count; ++i) scratch[i] = style_.tone == Tone::light ? tone(lit(i)) : 0.0F;
    return scratch;
}

const float* Gatherer::depth_tones(const Seen& seen, std::int64_t count, float* scratch) const noexcept {
    if (!(style_.depth_min > 0.0 && style_.depth_max > style_.depth_min)) return nullptr;
    for (std::int64_t i = 0; i < count; ++i)
        scratch[i] = depth_tone(static_cast<double>(seen.distance[i] / scene_.lens.eye_per_world), style_.depth_min,
                                style_.depth_max);
    return scratch;
}

// counted: the class of all marks already is.
void Gatherer::ink(const Local& local, const Seen& seen, std::int64_t count, bool counted) noexcept {
    std::array<float, Seen::most> tau;
    std::array<float, Seen::most> tau_depth;
    Selected selected;
    all_.loops_.select(local.selection, {marks_.block.data() + local.cluster->block, count}, seen,
                       taus(local, seen, count, tau.data()), depth_tones(seen, count, tau_depth.data()), selected);
    if (!counted) {
        info_.outside += selected.outside;
        info_.front += selected.fronts;
        info_.back += selected.backs;
    }
    info_.dropped_tone += selected.dropped_tone;
    info_.dropped_zoom += selected.dropped_zoom;
    info_.dropped_depth += selected.dropped_depth;
    for (std::int64_t first = 0, word = 0; first < count; first += selected.lanes, ++word) {
        for (unsigned bits = selected.drawn[word]; bits != 0; bits &= bits - 1) {
            const std::int64_t i = first + std::countr_zero(bits);
            const std::int64_t place = local.cluster->block * MarkBlock::size + i;
            const float radius =
                run_.pen.front_ink(seen.pixels_per_unit[i]) * (marks_.width.empty() ? 1.0F : marks_.width[place]);
            put(local, seen, i, std::sqrt(radius * radius * selected.front[i]));
        }
    }
}

void Gatherer::put(const Local& local, const Seen& seen, std::int64_t i, float radius) noexcept {
    const MarkBlock& m = marks_.block[local.cluster->block + i / MarkBlock::size];
    Dot& ink = *ink_++;
    ink.x = seen.x[i];
    ink.y = seen.y[i];
    ink.radius = radius;
    ink.opacity = 1.0F;
    ink.depth = seen.depth[i];
    ink.window = seen.window[i];
    ink.pixels_per_unit = seen.pixels_per_unit[i];
    ink.id = run_.first_id + m.mark[i % MarkBlock::size];
    ink.layer = layer_;
    ink.mark_class = MarkClass::front;
    // By the side that the splats are of.
    ink.flags = static_cast<std::uint8_t>(((seen.nu[i] > 0.0F) != run_.turned ? dot_faces_back : 0) |
                                          (item_.model != nullptr ? dot_is_exact : 0));
}

} // namespace hrbfnpr::frame

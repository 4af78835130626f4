#include "frame/gatherer.h"

#include "frame/cover_law.h"
#include "frame/tone.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

// Marks farther round the contour than this are none of its, whatever the curvature.
constexpr float widest_band = 0.9F;
// Ink of the front vanishes towards the contour over this much of n . v, where nothing else makes it vanish.
constexpr float front_fade = 0.08F;
// Contours are asked for what hides them so many pixels outside of their own sheet.
constexpr float probe = 2.0F;
// A halo goes out from marks within this many pixels of the contour.
constexpr float halo_band = 1.0F;
// Marks of a contour for each of its pixels.
constexpr float contour_marks = 3.0F;
constexpr float behind = 1.001F; // |nu| of a number that is one

[[nodiscard]] MarkBlock block(const sampling::MarkClusters& m, std::int64_t begin, std::int64_t count) noexcept {
    return {m.x.data() + begin,
            m.y.data() + begin,
            m.z.data() + begin,
            m.nx.data() + begin,
            m.ny.data() + begin,
            m.nz.data() + begin,
            count};
}

} // namespace

Gatherer::Gatherer(Gather& all, const Scene& scene, const Run& run, std::int32_t run_number,
                   std::int64_t first_place) noexcept
    : all_(all), scene_(scene), run_(run), item_(scene.item_of(run)), style_(item_.style),
      sight_(all.sights_[run.item]), item_ink_(all.item_inks_[run.item]), clear_(all.clears_[all.clear_of_[run.item]]),
      marks_(run.marks->clusters), color_(2U * static_cast<std::uint32_t>(run_number)),
      share_(style_.group[static_cast<std::size_t>(run.group)].share),
      more_for_fade_(1.0F / (1.0F - 0.5F * style_.tone_fade)),
      depth_active_(style_.depth_min > 0.0 && style_.depth_max > style_.depth_min),
      ink_(all.inks_.data() + first_place), cover_(all.covers_.data() + first_place) {}

// The largest disc that a mark can bring decides whether it can reach the viewport.
float Gatherer::reach(float ppe) const noexcept {
    float radius = 0.0F;
    if (run_.draws_front) radius = run_.pen.front_ink(ppe);
    if (run_.draws_silhouettes) radius = std::max(radius, run_.pen.silhouette_ink(ppe));
    return radius + 0.5F; // the soft rim
}

Gatherer::Local Gatherer::local_of(const sampling::Cluster& cluster) const noexcept {
    Local local;
    local.cluster = &cluster;
    local.view = view_cluster(cluster, sight_, scene_.lens, all_.frustum_, 1.25F * reach(1.0F) + 1.0F);
    const ClusterView& view = local.view;
    local.pixel_curvature = 1.0F / (sight_.scale * view.ppe);
    local.front_ink = run_.draws_front && (run_.sets == 3U || (run_.sets >> cluster.set & 1U) != 0);
    const bool by_width = style_.silhouette_law == SilhouetteLaw::width && cluster.bend >= 0.0F;
    local.band =
        by_width
            ? std::min(contour_band(1.05F * style_.silhouette_width, cluster.bend * local.pixel_curvature), widest_band)
            : static_cast<float>(style_.silhouette_threshold);
    if (style_.tone_curve == ToneCurve::coverage) local.per_ink = 1.0F / item_ink_.per_pixel(view.ppe);
    local.most_shown = most_shown(local);
    return local;
}

void Gatherer::operator()(const sampling::Cluster& cluster) noexcept {
    const std::int64_t marks = cluster.end - cluster.begin;
    info_.marks += marks;
    const Local local = local_of(cluster);
    if (local.view.outside) {
        info_.outside += marks;
        return;
    }
    const std::int64_t covers = covers_of(local);
    const bool whole = count_whole(local, marks);
    const bool tone = local.front_ink && local.view.nu_min < 0.0F;
    const bool contour = run_.draws_silhouettes && !whole;
    const std::int64_t inks = std::max(tone ? first_hidden(cluster, local.most_shown) : 0,
                                       contour ? first_hidden(cluster, most_of_contour(local)) : 0);
    if (!whole)
        info_.culled += marks - inks;
    else if (tone)
        info_.dropped_tone += marks - inks;
    const std::int64_t count = std::max(covers, inks);
    if (count == 0) return;
    Seen seen;
    all_.loops_.see(sight_.seer, block(marks_, cluster.begin, count), seen);
    if (covers > 0) cover(local, seen, covers);
    for (std::int64_t i = 0; i < inks; ++i) mark(local, seen, i, whole);
}

void Gatherer::expect(std::int64_t cluster) const noexcept {
    if (cluster >= marks_.cluster.size()) return;
    const std::int64_t at = marks_.cluster[cluster].begin;
    for (const base::Array<float>* array :
         {&marks_.x, &marks_.y, &marks_.z, &marks_.nx, &marks_.ny, &marks_.nz, &marks_.rank})
    {
        __builtin_prefetch(array->data() + at);
        __builtin_prefetch(array->data() + at + 16);
    }
    __builtin_prefetch(marks_.mark.data() + at);
}

// Whether all marks of the cluster are of one class, which is then counted.
bool Gatherer::count_whole(const Local& local, std::int64_t marks) noexcept {
    if (!local.view.inside) return false;
    if (local.view.nu_max < -local.band) {
        info_.front += marks;
        return true;
    }
    if (local.view.nu_min > local.band) {
        info_.back += marks;
        return true;
    }
    return false;
}

// The first of a cluster's marks that is not among the share `shown` of all.
std::int64_t Gatherer::first_hidden(const sampling::Cluster& cluster, float shown) const noexcept {
    const float* const begin = marks_.rank.data() + cluster.begin;
    const float* const end = marks_.rank.data() + cluster.end;
    return std::partition_point(begin, end, [&](float rank) { return rank > 1.0F - shown; }) - begin;
}

// The share of the marks that a contour may take, wherever it bends the most.
float Gatherer::most_of_contour(const Local& local) const noexcept {
    if (style_.silhouette_law == SilhouetteLaw::angle || local.cluster->bend < 0.0F) return 1.0F;
    return 1.01F * contour_shown(local, local.cluster->bend * local.pixel_curvature) + 1e-4F;
}

float Gatherer::most_shown(const Local& local) const noexcept {
    if (style_.tone_rule == ToneRule::paper || style_.tone == Tone::callback) return 1.0F;
    const float tau =
        style_.tone == Tone::light ? light_tone(local.view.lit_min, static_cast<float>(style_.tone_exponent)) : 0.0F;
    // Marks nearer than the centre are fewer for the same tone; a cluster's depth is small.
    const float nu = std::max(std::abs(local.view.nu_min), std::abs(local.view.nu_max));
    return 1.02F * share_ * shown_for(local, tau, nu) + 1e-4F;
}

// The share of the marks that makes up a tone; with a fade a little more, as those that fade in are small.
float Gatherer::shown_for(const Local& local, float tau, float nu) const noexcept {
    float shown = 1.0F - tau;
    if (style_.tone_curve == ToneCurve::coverage)
        shown = std::min(1.0F, item_ink_.needed(shown) * std::abs(nu) * local.per_ink);
    return shown * more_for_fade_;
}

std::int64_t Gatherer::covers_of(const Local& local) const noexcept {
    if (!run_.covers) return 0;
    const std::int64_t marks = local.cluster->end - local.cluster->begin;
    if (!run_.spread_evenly && run_.group != 0) return marks;
    const float pixels = run_.pen.spacing * local.view.ppe / cover_spacing;
    return pixels >= 1.0F ? marks : first_hidden(*local.cluster, pixels * pixels);
}

void Gatherer::cover(const Local& local, const Seen& seen, std::int64_t count) noexcept {
    const float spacing = run_.group == 0 ? std::max(run_.pen.spacing * local.view.ppe, cover_spacing)
                                          : run_.pen.spacing * local.view.ppe;
    const float own_radius =
        run_.spread_evenly && run_.group == 0 ? even_cover * spacing + 0.5F : random_cover * spacing + 0.5F;
    const float radius =
        std::min(run_.pen.cover_radius > 0.0F ? run_.pen.cover_radius : own_radius, run_.pen.largest_cover);
    for (std::int64_t i = 0; i < count; ++i) {
        const float nu = seen.nu[i];
        if (!(seen.ppe[i] > 0.0F) || !(std::abs(nu) <= behind) || !(seen.window[i] >= 0.0F && seen.window[i] <= 1.0F))
            continue;
        Cover& c = *cover_++;
        c.x = seen.x[i];
        c.y = seen.y[i];
        c.radius = radius;
        c.depth = seen.depth[i];
        c.ppe = seen.ppe[i];
        const float turn = -seen.along[i] / (std::abs(nu) > 1e-3F ? nu : 1e-3F);
        float x = seen.side_x[i] * turn;
        float y = -seen.side_y[i] * turn;
        const float slope = std::sqrt(x * x + y * y);
        const float shrink = slope > steepest ? steepest / slope : 1.0F;
        c.slope_x = x * shrink / c.ppe;
        c.slope_y = y * shrink / c.ppe;
        c.clear = clear_.at(nu);
        c.window = seen.window[i];
        c.halo = bears_halo(local, nu, local.cluster->begin + i) ? style_.halo_width : 0.0F;
        c.halo_clear = clear_.halo;
        c.id = run_.first_id + marks_.mark[local.cluster->begin + i];
        c.faces_back = nu > 0.0F;
        ++info_.painted;
    }
}

// Normal curvature along the line of sight, per pixel; < 0: not known.
float Gatherer::radial_curvature(const Local& local, std::int64_t place) const noexcept {
    const sampling::Cluster& cluster = *local.cluster;
    if (cluster.bend < 0.0F) return -1.0F;
    const glm::vec3 own(marks_.x[place], marks_.y[place], marks_.z[place]);
    const glm::vec3 n(marks_.nx[place], marks_.ny[place], marks_.nz[place]);
    const glm::vec3 v = sight_.seer.parallel ? sight_.eye : own - sight_.eye;
    const glm::vec3 w = v - glm::dot(v, n) * n; // the line of sight along the surface
    const auto& s = cluster.shape;
    const float turn = w.x * (s[0] * w.x + 2.0F * (s[1] * w.y + s[2] * w.z)) + w.y * (s[3] * w.y + 2.0F * s[4] * w.z) +
                       w.z * s[5] * w.z;
    return std::abs(turn) / glm::dot(w, w) * local.pixel_curvature;
}

// The share of the marks that a line of `contour_marks` for each pixel takes: around a circle the band is
// sqrt(2 width / curvature) wide on either side.  Groups that come first go first.
float Gatherer::contour_shown(const Local& local, float pixel_curvature) const noexcept {
    if (!(pixel_curvature > 0.0F)) return 1.0F;
    const float ppe = local.view.ppe;
    const float area = 2.0F * std::sqrt(2.0F * style_.silhouette_width / pixel_curvature) / (ppe * ppe);
    const float wanted = contour_marks - area * run_.earlier_contours;
    return std::clamp(wanted * run_.pen.spacing * run_.pen.spacing / area, 0.0F, 1.0F);
}

Gatherer::Contour Gatherer::contour_of(const Local& local, float nu, std::int64_t place) const noexcept {
    if (!(std::abs(nu) <= local.band)) return {};
    const bool fades = style_.tone_fade > 0.0F;
    const float curvature = style_.silhouette_law == SilhouetteLaw::width ? radial_curvature(local, place) : -1.0F;
    if (curvature < 0.0F) return {fades ? std::min(1.0F, 4.0F * (1.0F - std::abs(nu) / local.band)) : 1.0F, 1.0F};
    const float rest = 1.0F - contour_distance(nu, curvature) / style_.silhouette_width;
    if (!(rest > 0.0F)) return {};
    return {fades ? std::min(1.0F, 2.0F * rest) : 1.0F, contour_shown(local, curvature)};
}

bool Gatherer::bears_halo(const Local& local, float nu, std::int64_t place) const noexcept {
    if (!(style_.halo_width > 0.0F) || !(std::abs(nu) <= widest_band)) return false;
    const float curvature = radial_curvature(local, place);
    return curvature < 0.0F ? std::abs(nu) <= 0.5F * local.band : contour_distance(nu, curvature) <= halo_band;
}

// Everything is asked so that a value that is not a number answers "outside".
bool Gatherer::inside(const Seen& seen, std::int64_t i) const noexcept {
    if (!(seen.ppe[i] > 0.0F)) return false; // behind the camera
    const glm::vec4& v = scene_.lens.viewport;
    const float radius = reach(seen.ppe[i]);
    return seen.x[i] > v.x - radius && seen.x[i] < v.x + v.z + radius && seen.y[i] > v.y - radius &&
           seen.y[i] < v.y + v.w + radius && seen.window[i] >= 0.0F && seen.window[i] <= 1.0F &&
           std::abs(seen.nu[i]) <= behind;
}

void Gatherer::mark(const Local& local, const Seen& seen, std::int64_t i, bool counted) noexcept {
    if (!local.view.inside && !inside(seen, i)) {
        ++info_.outside;
        return;
    }
    const float nu = seen.nu[i];
    const std::int64_t place = local.cluster->begin + i;
    const Contour contour = counted ? Contour{} : contour_of(local, nu, place);
    if (!counted) ++(contour.share > 0.0F ? info_.silhouette : nu < 0.0F ? info_.front : info_.back);
    // Areas: a mark on its way from the front into the contour's band is as large as the larger of both.
    float front = 0.0F;
    if (nu < 0.0F && local.front_ink && (contour.share <= 0.0F || style_.tone_fade > 0.0F)) {
        FrameInfo ignored;
        const float radius = run_.pen.front_ink(seen.ppe[i]) * (marks_.width.empty() ? 1.0F : marks_.width[place]);
        front = radius * radius * tone_share(local, seen, i, contour.share > 0.0F ? ignored : info_);
    }
    float line = 0.0F;
    if (contour.share > 0.0F && run_.draws_silhouettes) {
        const float radius = run_.pen.silhouette_ink(seen.ppe[i]);
        line = radius * radius * contour.share * silhouette_share(seen, i, place, contour.shown);
        if (!(line > 0.0F))
            ++(silhouette_share(seen, i, place, 1.0F) > 0.0F ? info_.dropped_tone : info_.dropped_depth);
    }
    if (line > 0.0F || front > 0.0F)
        put(local, seen, i, std::sqrt(std::max(line, front)), line > 0.0F ? MarkClass::silhouette : MarkClass::front);
}

// The share of its area at which a mark is drawn: it grows while the last `fade` of the marks shown come in.
float Gatherer::grown(float rank, float shown) const noexcept {
    const float place = 1.0F - rank;
    if (!(place < shown)) return place == shown && shown > 0.0F && style_.tone_fade == 0.0F ? 1.0F : 0.0F;
    return style_.tone_fade > 0.0F ? std::min(1.0F, (shown - place) / (style_.tone_fade * shown)) : 1.0F;
}

float Gatherer::depth_tone_of(const Seen& seen, std::int64_t i) const noexcept {
    if (!depth_active_) return 1.0F;
    const double distance = static_cast<double>(seen.distance[i] / scene_.lens.eye_per_world);
    return depth_tone(distance, style_.depth_min, style_.depth_max);
}

float Gatherer::silhouette_share(const Seen& seen, std::int64_t i, std::int64_t place, float most) const noexcept {
    const float rank = marks_.rank[place];
    const float tau_depth = depth_tone_of(seen, i);
    if (style_.tone_rule == ToneRule::paper) return silhouette_shown(rank, tau_depth, ToneRule::paper) ? 1.0F : 0.0F;
    const float shown = tau_depth * most;
    return shown >= 1.0F ? 1.0F : grown(rank, shown);
}

float Gatherer::tau_of(const Seen& seen, std::int64_t i, std::int64_t place) const noexcept {
    switch (style_.tone) {
    case Tone::light: return light_tone(seen.lit[i], static_cast<float>(style_.tone_exponent));
    case Tone::callback: return all_.tau_[run_.first + place];
    case Tone::none: break;
    }
    return 0.0F;
}

float Gatherer::tone_share(const Local& local, const Seen& seen, std::int64_t i, FrameInfo& info) const noexcept {
    const std::int64_t place = local.cluster->begin + i;
    const float rank = marks_.rank[place];
    if (!(1.0F - rank <= local.most_shown)) {
        ++info.dropped_tone;
        return 0.0F;
    }
    const float tau = tau_of(seen, i, place);
    const float scale = run_.pen.scale(seen.ppe[i]);
    if (style_.tone_rule == ToneRule::paper) {
        const Verdict verdict = front_verdict(rank, {tau, depth_tone_of(seen, i), scale, share_}, ToneRule::paper);
        info.dropped_tone += verdict == Verdict::tone;
        info.dropped_zoom += verdict == Verdict::zoom;
        info.dropped_depth += verdict == Verdict::depth;
        return verdict == Verdict::shown ? 1.0F : 0.0F;
    }
    const float shown = share_ * shown_for(local, tau, seen.nu[i]);
    const float area = grown(rank, shown * scale * depth_tone_of(seen, i));
    if (!(area > 0.0F)) {
        const bool tone = !(grown(rank, shown) > 0.0F);
        const bool zoom = !tone && !(grown(rank, shown * scale) > 0.0F);
        ++(tone ? info.dropped_tone : zoom ? info.dropped_zoom : info.dropped_depth);
        return 0.0F;
    }
    // Coverage counts on foreshortening; else the ink of the front vanishes where it turns away.
    const bool turns = style_.tone_fade > 0.0F && style_.tone_curve == ToneCurve::linear;
    return turns ? area * std::min(1.0F, -seen.nu[i] / front_fade) : area;
}

void Gatherer::put(const Local& local, const Seen& seen, std::int64_t i, float radius, MarkClass mark_class) noexcept {
    Ink& ink = *ink_++;
    ink.x = seen.x[i];
    ink.y = seen.y[i];
    ink.radius = radius;
    ink.alpha = 1.0F;
    ink.depth = seen.depth[i];
    ink.window = seen.window[i];
    ink.ppe = seen.ppe[i];
    ink.id = run_.first_id + marks_.mark[local.cluster->begin + i];
    const bool contour = mark_class == MarkClass::silhouette;
    ink.color = color_ + (contour ? 1U : 0U);
    ink.mark_class = mark_class;
    ink.faces_back = seen.nu[i] > 0.0F;
    const float side = std::sqrt(seen.side_x[i] * seen.side_x[i] + seen.side_y[i] * seen.side_y[i]);
    const float step = contour && side > 0.0F ? probe * probe_steps / side : 0.0F;
    ink.probe_x = static_cast<std::int8_t>(seen.side_x[i] * step);
    ink.probe_y = static_cast<std::int8_t>(-seen.side_y[i] * step);
}

} // namespace hrbfnpr::frame

// SPDX-License-Identifier: MIT
#include "frame/hatch/strokes.h"

#include "base/assert.h"
#include "base/scratch.h"
#include "frame/hatch/presence.h"
#include "frame/hatch/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::frame {

using drawing::Stroke;
using drawing::StrokePoint;

namespace {

// The distances from a tip at which points are added, in pixels. They are small, because the width changes like a
// square root near the tip.
constexpr std::array<float, 3> tip_points = {0.3F, 1.25F, hatch_tuning.tip_reach};

// The directions in which a line may continue from a point. They must pass close enough to all points taken after it.
struct AllowedSlopes {
    // The allowed errors of a point's x, y and radius.
    static constexpr std::array<float, 3> even = {hatch_tuning.place_tolerance, hatch_tuning.place_tolerance,
                                                  hatch_tuning.radius_tolerance};

    explicit AllowedSlopes(const StrokePoint& first) noexcept : from(first) {
        least.fill(-std::numeric_limits<float>::infinity());
        most.fill(std::numeric_limits<float>::infinity());
    }
    [[nodiscard]] std::array<float, 3> difference(const StrokePoint& to) const noexcept {
        return {to.x - from.x, to.y - from.y, to.radius - from.radius};
    }
    // Returns whether all points taken are close enough to the line from the first point to `to`, and have the same
    // opacity.
    [[nodiscard]] bool allows(const StrokePoint& to) const noexcept {
        const float way = to.length - from.length;
        bool holds = way > 0.0F && to.opacity == from.opacity;
        for (std::size_t k = 0; k < 3; ++k)
            holds = holds && difference(to)[k] > least[k] * way && difference(to)[k] < most[k] * way;
        return holds;
    }
    void take(const StrokePoint& to) noexcept {
        const float way = to.length - from.length;
        if (!(way > 0.0F)) return;
        const float scale = 1.0F / way;
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::max(least[k], (difference(to)[k] - even[k]) * scale);
            most[k] = std::min(most[k], (difference(to)[k] + even[k]) * scale);
        }
    }

    StrokePoint from;
    std::array<float, 3> least, most; // the least and the largest slopes
};

// Returns the width of a line at a distance from its end, as a share of its full width. It is sharper than a quarter of
// an ellipse.
[[nodiscard]] float narrowed(float from_end, float taper) noexcept {
    return from_end < taper ? std::sqrt(std::max(from_end, 0.0F) / taper) : 1.0F;
}

// The presences and other rows of a chain. Each row has a number for each sample.
enum Presence : std::size_t {
    by_tone = margin_tone,
    by_level = margin_level,
    by_rim = margin_rim,
    by_picture = margin_picture,
    by_hiding,
    total,
    scratch,
    beyond_tone,
    full_width, // the width of the line; all widths above a limit count as this limit
    filling,    // the weight of the line's length; it is smaller for a level that is still fading in
    presences
};

// Makes the strokes of one chain.
class ChainStrokes {
public:
    // `inks` is NULL if the run has no inks.
    ChainStrokes(const Run& run, const InkChoice* inks, float halo, const Hiding& hiding, const HatchChain& chain,
                 std::span<const HatchSample> samples, std::span<Dot> dots, HatchStrokePart& part)
        : run_(run), style_(*run.style), inks_(inks), halo_(halo), hiding_(hiding), chain_(chain), samples_(samples),
          dots_(dots), part_(part) {
        HRBFNPR_ASSERT(samples.size() == dots.size() && samples.size() >= 2);
        const std::int64_t count = size();
        part.length.clear();
        float length = 0.0F;
        for (std::int64_t i = 0; i < count; ++i) {
            if (i > 0) length += glm::length(glm::vec2(dot(i).x - dot(i - 1).x, dot(i).y - dot(i - 1).y));
            part.length.push_back(length);
        }
        line_ = {part.length.span(), chain.ring};
        if (part.row.size() < static_cast<std::int64_t>(presences) * count)
            base::resize_scratch(part.row, static_cast<std::int64_t>(presences) * count);
    }

    void operator()() {
        find_presences();
        if (std::none_of(row(by_tone), row(by_tone) + size(), [](float p) { return p > 0.0F; })) return;
        // Gaps that the tone makes in a line look like mistakes if they are no longer than the line's width, so they
        // are closed. Where other lines leave no space for lines of this level, the line has no width, so its gaps are
        // not visible.
        close_gaps(by_tone, [&](std::int64_t i) {
            const float most = std::max(hatch_tuning.least_gap * sample(i).width, hatch_tuning.least_gap_pixels);
            return std::pair(0.5F * most, most);
        });
        close_hidden();
        for (std::int64_t i = 0; i < size(); ++i)
            row(total)[i] =
                std::min({row(by_tone)[i], row(by_level)[i], row(by_rim)[i], row(by_picture)[i], row(by_hiding)[i]});
        leave_out_short();
        add_parts();
    }

private:
    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(samples_.size()); }
    [[nodiscard]] const Dot& dot(std::int64_t i) const noexcept { return dots_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const HatchSample& sample(std::int64_t i) const noexcept {
        return samples_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] float* row(Presence which) const noexcept {
        return part_.row.data() + static_cast<std::int64_t>(which) * size();
    }
    [[nodiscard]] bool is_seen(std::int64_t i) const noexcept { return dot(i).opacity > 0.0F; }

    // ---- Presences

    void find_presences() {
        for (std::int64_t i = 0; i < size(); ++i) {
            const auto& margin = sample(i).margin;
            row(by_tone)[i] = std::clamp(margin[margin_tone] * (1.0F / hatch_tuning.tone_ramp), 0.0F, 1.0F);
            row(by_level)[i] = std::clamp(margin[margin_level] * (1.0F / hatch_tuning.level_ramp), 0.0F, 1.0F);
            row(by_rim)[i] = std::clamp(margin[margin_rim] * (1.0F / hatch_tuning.rim_ramp), 0.0F, 1.0F);
            row(by_picture)[i] = margin[margin_picture] > 0.0F ? 1.0F : 0.0F;
        }
        if (style_.hatch_overshoot > 0.0F) overshoot();
        part_.cuts.clear();
        if (!hiding_.edges.empty()) find_cuts(hiding_, halo_, dots_, part_.length, part_.cuts);
        for (std::int64_t i = 0; i < size(); ++i) row(by_hiding)[i] = is_seen(i) ? 1.0F : 0.0F;
    }

    // Extends the line beyond the end of its tone, as a quick hand does. `left` is the rest of the length beyond the
    // last sample that is reached.
    void overshoot() {
        float* const tone = row(by_tone);
        float* const left = row(beyond_tone);
        std::fill_n(left, size(), 0.0F);
        for (const int way : {1, -1}) {
            for (std::int64_t i = 0; i < size(); ++i) {
                if (!(tone[i] > 0.0F) || left[i] > 0.0F) continue;
                float step = 0.0F;
                std::int64_t k = line_.next(i, way, step);
                if (k < 0 || tone[k] > 0.0F) continue;
                float most = sample(k).overshoot; // The tone ends at sample k.
                for (std::int64_t steps = 0; steps < size() && k >= 0 && !(tone[k] > 0.0F) && most > 0.0F; ++steps) {
                    tone[k] = 1.0F;
                    const std::int64_t last = k;
                    k = line_.next(k, way, step);
                    left[last] = most;
                    most -= step;
                }
            }
        }
    }

    // The line is drawn at sample j. For the given reason, it is not drawn at the neighbour k. Returns the share of the
    // way from j to k at which the line ends.
    [[nodiscard]] float end_share(Presence reason, std::int64_t j, std::int64_t k) const noexcept {
        if (reason == by_hiding) {
            const std::int64_t before = std::min(j, k);
            for (const HatchCut& cut : part_.cuts) {
                if (cut.before != before) continue;
                const float step = std::abs(line_.at(k) - line_.at(j));
                return step > 0.0F ? std::clamp(std::abs(cut.at - line_.at(j)) / step, 0.0F, 1.0F) : 0.0F;
            }
            return 0.5F;
        }
        if (reason == by_tone && style_.hatch_overshoot > 0.0F) {
            float step = std::abs(line_.at(k) - line_.at(j));
            return step > 0.0F ? std::clamp(row(beyond_tone)[j] / step, 0.0F, 1.0F) : 0.0F;
        }
        HRBFNPR_ASSERT(reason <= by_picture);
        const float from = sample(j).margin[reason];
        const float to = sample(k).margin[reason];
        return from > 0.0F && to < 0.0F ? from / (from - to) : from > 0.0F ? 1.0F : 0.0F;
    }
    // Returns the smallest share of the way from j to k at which the line ends for any reason.
    [[nodiscard]] float end_share(std::int64_t j, std::int64_t k) const noexcept {
        float share = 1.0F;
        for (const Presence reason : {by_tone, by_level, by_rim, by_picture, by_hiding})
            if (row(reason)[j] > 0.0F && !(row(reason)[k] > 0.0F)) share = std::min(share, end_share(reason, j, k));
        return share;
    }

    // Returns the held length around sample i, at most `most` on each side.
    template <class Of, class Weight, class Share>
    [[nodiscard]] float held_around(std::int64_t i, float most, float beyond, const Of& presence, const Weight& weight,
                                    const Share& share) const noexcept {
        const float length = held_length(line_, i, 1, most, beyond, presence, weight, share).length;
        return length + held_length(line_, i, -1, most, beyond, presence, weight, share).length;
    }
    static float unit_weight(std::int64_t) noexcept { return 1.0F; }

    // Closes the gaps of a presence that are shorter than limit(i).first at a sample i. Gaps shorter than
    // limit(i).second are partly open, so that gaps do not open suddenly.
    template <class Limit>
    void close_gaps(Presence reason, const Limit& limit) {
        float* const p = row(reason);
        float* const closed = row(scratch);
        std::copy_n(p, size(), closed);
        const auto absence = [&](std::int64_t k) { return p[k] > 0.0F ? 0.0F : 1.0F; };
        // A gap begins where the line ends, so its share of the step is the rest of the step.
        const auto share = [&](std::int64_t j, std::int64_t k) { return 1.0F - end_share(reason, k, j); };
        for (std::int64_t i = 0; i < size(); ++i) {
            if (p[i] > 0.0F) continue;
            const auto [from, to] = limit(i);
            closed[i] = 1.0F - ramp_between(held_around(i, to, to, absence, unit_weight, share), from, to);
        }
        std::copy_n(closed, size(), p);
    }

    // Closes short hidden gaps at the end of a contour and its halo. Leaves out short parts between hidden parts,
    // because they are in the halo of a contour beside them.
    void close_hidden() {
        float* const p = row(by_hiding);
        if (std::all_of(p, p + size(), [](float seen) { return seen == 1.0F; })) return;
        close_gaps(by_hiding, [&](std::int64_t i) {
            const float least = std::max(hatch_tuning.least_gap * sample(i).width, hatch_tuning.closed_halos * halo_);
            return std::pair(least, least * hatch_tuning.opened_halos / hatch_tuning.closed_halos);
        });
        const float shortest = hatch_tuning.shortest_between_hidden * style_.hatch_shortest;
        if (!(shortest > 0.0F)) return;
        float* const kept = row(scratch); // a copy of the presences before the change
        const auto seen = [&](std::int64_t k) { return p[k]; };
        const auto share = [&](std::int64_t j, std::int64_t k) { return end_share(by_hiding, j, k); };
        for (std::int64_t i = 0; i < size(); ++i)
            if (p[i] > 0.0F)
                kept[i] *= ramp_between(held_around(i, shortest, shortest, seen, unit_weight, share), 0.5F * shortest,
                                        shortest);
        std::copy_n(kept, size(), p);
    }

    // Returns the share of the width that remains. It depends on how far a gap is closed, and on how much of the line
    // is seen.
    [[nodiscard]] float ink(std::int64_t i) const noexcept {
        const float tone = sample(i).margin[margin_tone] > 0.0F ? 1.0F : row(by_tone)[i];
        return std::min(tone, row(by_hiding)[i]);
    }

    // Leaves out short parts. For each sample, the length of the part around it is measured. Where the line is thinner
    // than at the sample, length counts less, because a connection by a hairline hardly matters. All widths above half
    // a pen count the same. Lines with hardly any space between others count less, too.
    void leave_out_short() {
        const float shortest = style_.hatch_shortest;
        float* const p = row(total);
        if (!(shortest > 0.0F)) {
            for (std::int64_t i = 0; i < size(); ++i) p[i] = p[i] > 0.0F ? ink(i) : 0.0F;
            return;
        }
        float* const kept = row(scratch);
        const float full = hatch_tuning.full_width * style_.hatch_pen;
        float* const width = row(full_width);
        float* const level = row(filling);
        for (std::int64_t i = 0; i < size(); ++i) {
            width[i] = std::min(sample(i).width, full);
            level[i] =
                std::lerp(hatch_tuning.length_of_filling, 1.0F, std::clamp(sample(i).margin[margin_level], 0.0F, 1.0F));
        }
        const auto presence = [&](std::int64_t k) { return p[k]; };
        // From the point where the presence begins to fade to its end, half of the length counts.
        const auto share = [&](std::int64_t j, std::int64_t k) { return 0.5F * end_share(j, k); };
        const float most = 2.0F * shortest;
        // A line from crease to crease is as long as the face is wide, so its length is not compared. If a part of it
        // is hidden, the rest may be seen by mistake.
        const float* const seen = row(by_hiding);
        const bool crosses_face = chain_.has_begin && chain_.begins == StrokeEnd::crease && chain_.has_end &&
                                  chain_.ends == StrokeEnd::crease &&
                                  std::all_of(seen, seen + size(), [](float presence) { return presence == 1.0F; });
        const float beyond = crosses_face ? shortest : 0.0F;
        const auto is_solid = [&](std::int64_t k) { return p[k] == 1.0F && width[k] == full && level[k] == 1.0F; };
        std::int64_t solid = 0; // the end of the last stretch that is long enough on its own
        for (std::int64_t i = 0; i < size(); ++i) {
            if (i >= solid && is_solid(i)) {
                std::int64_t last = i;
                while (last + 1 < size() && is_solid(last + 1)) ++last;
                if (line_.at(last) - line_.at(i) >= most) solid = last + 1;
            }
            kept[i] = i < solid ? 1.0F : 0.0F;
            if (i < solid || !(p[i] > 0.0F)) continue;
            const float scale = 1.0F / std::max(width[i], 1e-6F);
            const auto weight = [&](std::int64_t k) { return std::min(width[k] * scale, 1.0F) * level[k]; };
            float length = held_length(line_, i, 1, most, beyond, presence, weight, share).length;
            if (length < most) length += held_length(line_, i, -1, most, beyond, presence, weight, share).length;
            kept[i] = ramp_between(length, shortest, most);
        }
        // A fading stretch gets at most the presence of the stronger stretch beside it, so that a part is drawn
        // entirely or not at all.
        for (const int way : {-1, 1}) {
            std::int64_t i = way > 0 ? 0 : size() - 1;
            for (std::int64_t steps = 0; steps < (chain_.ring ? 2 : 1) * size(); ++steps) {
                float step = 0.0F;
                const std::int64_t k = line_.next(i, way, step);
                if (k < 0) break;
                if (p[k] < p[i]) kept[k] = std::min(kept[k], kept[i]);
                i = k;
            }
        }
        for (std::int64_t i = 0; i < size(); ++i) p[i] = kept[i] > 0.0F ? ink(i) * kept[i] : 0.0F;
    }

    // ---- Tapers

    // Returns the length of the taper at an end of the line. If the line is followed in the direction `way`, it ends
    // before sample k for the given reason.
    [[nodiscard]] float taper(Presence reason, std::int64_t k, int way) const noexcept {
        if (reason == by_picture) return 0.0F;
        const float longest = longest_taper(reason);
        if (reason != by_rim) return longest;
        return longest *
               (1.0F - ramp_between(sine_at_rim(k, way), hatch_tuning.parallel_sine, hatch_tuning.crossing_sine));
    }

    // Returns the sine of the angle between a contour at sample k and the last part of a line. If the line is followed
    // in the direction `way`, it ends at sample k.
    [[nodiscard]] float sine_at_rim(std::int64_t k, int way) const noexcept {
        std::int64_t i = k;
        float length = 0.0F;
        for (std::int64_t steps = 0; steps < size() && length < hatch_tuning.chord_share * style_.hatch_taper;
             ++steps) {
            float step = 0.0F;
            const std::int64_t next = line_.next(i, -way, step);
            if (next < 0 || !(row(by_rim)[next] > 0.0F)) break;
            length += step;
            i = next;
        }
        const glm::vec2 chord(dot(i).x - dot(k).x, dot(i).y - dot(k).y);
        const glm::vec2 across = sample(k).across_rim();
        const float lengths = glm::length(chord) * glm::length(across);
        return lengths > 0.0F ? std::abs(glm::dot(chord, across)) / lengths : 0.0F;
    }

    // Returns the length of the taper at an end of the stroke, which is at sample i. In the dark, a long taper would
    // leave a white fleck between the lines beside it.
    [[nodiscard]] float taper(StrokeEnd end, std::int64_t i) const noexcept {
        const float blunt = hatch_tuning.blunt_taper * style_.hatch_taper;
        if (end == StrokeEnd::crease) return std::min(hatch_tuning.round_tip * sample(i).width, blunt);
        const float dark =
            std::clamp(sample(i).margin[margin_tone] / (style_.hatch_tone_end - style_.hatch_tone_begin), 0.0F, 1.0F);
        const float white = 1.0F - std::lerp(style_.hatch_coverage_begin, style_.hatch_coverage_end, dark);
        return blunt * white;
    }

    // Returns how far a reason narrows the line. Fading near a contour does not narrow it: a line across the contour
    // keeps its full width.
    [[nodiscard]] float tapering(Presence reason, std::int64_t i) const noexcept {
        const float p = row(reason)[i];
        const bool fades = reason == by_level || reason == by_hiding || sample(i).margin[reason] <= 0.0F;
        return fades ? p : 1.0F;
    }
    // Returns the longest taper of a reason.
    [[nodiscard]] float longest_taper(Presence reason) const noexcept {
        return reason == by_hiding ? hatch_tuning.hidden_taper
               : reason == by_tone ? style_.hatch_taper
                                   : hatch_tuning.blunt_taper * style_.hatch_taper;
    }

    // Sets for each sample a bit for each reason that may narrow the line there. Most samples are far from all ends of
    // the line.
    void find_near() {
        base::resize_scratch(part_.near, size());
        std::uint8_t* const near = part_.near.data();
        std::fill_n(near, size(), std::uint8_t{0});
        for (const Presence reason : {by_tone, by_level, by_rim, by_hiding}) {
            if (!ends_by_[reason]) continue;
            const auto bit = static_cast<std::uint8_t>(1U << reason);
            const float most = longest_taper(reason);
            for (std::int64_t i = 0; i < size(); ++i) {
                if (tapering(reason, i) == 1.0F) continue;
                near[i] = static_cast<std::uint8_t>(near[i] | bit);
                for (const int way : {1, -1}) {
                    float length = 0.0F; // the length from the last place where the line may end to sample i
                    float step = 0.0F;
                    std::int64_t k = line_.next(i, way, step);
                    for (std::int64_t steps = 0;
                         steps < size() && k >= 0 && length < most && tapering(reason, k) == 1.0F; ++steps) {
                        near[k] = static_cast<std::uint8_t>(near[k] | bit);
                        k = line_.next(k, way, step);
                        length += step;
                    }
                }
            }
        }
    }

    // Returns the width at sample i as a share of its full width, by the distances from the ends.
    [[nodiscard]] float profile(std::int64_t i) const noexcept {
        float least = 1.0F;
        for (const Presence reason : {by_tone, by_level, by_rim, by_hiding}) {
            if ((static_cast<unsigned>(part_.near[i]) >> reason & 1U) == 0) continue;
            const bool fades = reason == by_level;
            const auto presence = [&](std::int64_t k) { return tapering(reason, k); };
            const auto share = [&](std::int64_t j, std::int64_t k) {
                return (fades ? 0.5F : 1.0F) * end_share(reason, j, k);
            };
            const float most = longest_taper(reason);
            for (const int way : {1, -1}) {
                const HeldLength held = held_length(line_, i, way, most, most, presence, unit_weight, share);
                if (held.length >= most) continue;
                const float own = held.stopped_at >= 0 ? taper(reason, held.stopped_at, way) : most;
                least = std::min(least, narrowed(held.length, own));
            }
        }
        if (chain_.has_begin) least = std::min(least, narrowed(line_.at(i), taper(chain_.begins, i)));
        if (chain_.has_end)
            least = std::min(least, narrowed(line_.at(size() - 1) - line_.at(i), taper(chain_.ends, i)));
        return least;
    }

    // Returns the width at the end of the line between samples j and k, as a share of its full width. Samples alone
    // would miss tapers shorter than a pixel.
    [[nodiscard]] float profile_at_end(std::int64_t j, std::int64_t k, int way) const noexcept {
        float longest = -1.0F;
        for (const Presence reason : {by_tone, by_level, by_rim, by_picture, by_hiding})
            if (row(reason)[j] > 0.0F && !(row(reason)[k] > 0.0F)) longest = std::max(longest, taper(reason, k, way));
        if (longest < 0.0F) return 0.0F; // The line continues, but the drawn part is too short.
        return 1.0F - std::min(longest, 1.0F);
    }

    // ---- Strokes

    void add_parts() {
        const float* const p = row(total);
        const auto is_drawn = [](float presence) { return presence > 0.0F; };
        for (const Presence reason : {by_tone, by_level, by_rim, by_hiding})
            ends_by_[reason] = !std::all_of(row(reason), row(reason) + size(), is_drawn);
        find_near();
        std::int64_t start = 0; // a sample of the ring that is in a gap, if there is one
        bool whole = chain_.ring;
        for (std::int64_t i = 0; chain_.ring && i < size(); ++i) {
            if (is_drawn(p[i])) continue;
            start = i;
            whole = false;
            break;
        }
        const std::int64_t around = size() - 1; // the number of samples in the ring
        const bool turned = chain_.ring && !whole;
        order_ = {turned ? start : 0, turned ? around : 0};
        const std::int64_t count = turned ? around + 1 : size();
        for (std::int64_t k = 0; k < count; ++k) {
            if (!is_drawn(p[order_[k]])) continue;
            const std::int64_t first = k;
            while (k + 1 < count && is_drawn(p[order_[k + 1]])) ++k;
            add_part({first, k, first > 0, k + 1 < count, whole});
        }
    }

    // Consecutive samples, given by their positions in the order, and whether the line ends before and after them.
    struct Part {
        std::int64_t first, last;
        bool ends_before, ends_after;
        bool closed;
    };

    void add_part(const Part& drawn) {
        take_points(drawn);
        if (raw().size() < 2) return;
        Stroke stroke;
        stroke.first = part_.made.points.size();
        stroke.layer = run_.first_layer;
        stroke.closed = drawn.closed;
        const float whole = raw().back().length;
        const bool has_tips = whole > 4.0F * hatch_tuning.tip_reach;
        const bool begins_in_tip = has_tips && !drawn.closed && raw()[0].radius == 0.0F;
        const bool ends_in_tip = has_tips && !drawn.closed && raw().back().radius == 0.0F;
        const float low = begins_in_tip ? hatch_tuning.tip_reach : 0.0F;
        const float high = ends_in_tip ? whole - hatch_tuning.tip_reach : whole;
        base::Array<StrokePoint>& points = part_.made.points;
        points.push_back(raw()[0]);
        if (begins_in_tip)
            for (const float at : tip_points) points.push_back(tip_point(at, hatch_tuning.tip_reach, at));
        for (std::int64_t k = 1; k + 1 < raw().size(); ++k)
            if (raw()[k].length > low && raw()[k].length < high) points.push_back(raw()[k]);
        if (ends_in_tip)
            for (std::size_t k = tip_points.size(); k-- > 0;)
                points.push_back(tip_point(whole - tip_points[k], whole - hatch_tuning.tip_reach, tip_points[k]));
        points.push_back(raw().back());
        // Near a tip, even the point of a wide line is narrow.
        const float widest = 0.5F * hatch_tuning.widest_tip * style_.hatch_pen;
        if (begins_in_tip) points[stroke.first + 1].radius = std::min(points[stroke.first + 1].radius, widest);
        if (ends_in_tip) points[points.size() - 2].radius = std::min(points[points.size() - 2].radius, widest);
        keep_within_edges(stroke.first);
        if (inks_ == nullptr)
            finish(stroke, begins_in_tip, ends_in_tip);
        else
            cut_by_inks(stroke, begins_in_tip, ends_in_tip);
    }

    // Adds a stroke whose points, the last ones made, are complete.
    void finish(Stroke stroke, bool begins_in_tip, bool ends_in_tip) {
        const base::Array<StrokePoint>& points = part_.made.points;
        leave_out(stroke.first + (begins_in_tip ? 1 : 0), points.size() - (ends_in_tip ? 2 : 1));
        stroke.count = static_cast<std::int32_t>(points.size() - stroke.first);
        stroke.depth = points[stroke.first + stroke.count / 2].depth;
        part_.made.strokes.push_back(stroke);
    }

    // Adds a stroke for each part of one ink.
    void cut_by_inks(const Stroke& stroke, bool begins_in_tip, bool ends_in_tip) {
        base::Array<StrokePoint>& points = part_.made.points;
        raw().clear();
        part_.inks.clear();
        for (std::int64_t i = stroke.first; i < points.size(); ++i) {
            const bool is_same = !raw().empty() && raw().back().id == points[i].id;
            const std::uint8_t ink = is_same ? part_.inks.back() : inks_->of_mark(points[i].id - run_.first_id, 0);
            raw().push_back(points[i]);
            part_.inks.push_back(ink);
        }
        points.resize(stroke.first);
        settle_inks(raw().span(), part_.inks.span());
        add_in_inks(stroke, run_.first_layer, raw().span(), part_.inks.span(),
                    [&](Stroke part, std::span<const StrokePoint> own) {
                        part_.made.add_points(part, own);
                        finish(part, begins_in_tip && own.data() == raw().data(),
                               ends_in_tip && own.data() + own.size() == raw().data() + raw().size());
                    });
    }

    [[nodiscard]] base::Array<StrokePoint>& raw() const noexcept { return part_.raw; }

    // Fills raw() with a point for each sample of the part, and a point at each end of the line.
    void take_points(const Part& drawn) {
        base::Array<StrokePoint>& points = part_.raw;
        points.clear();
        float opacity = 1.0F;
        for (std::int64_t k = drawn.first; k <= drawn.last; ++k) {
            if (!is_seen(order_[k])) continue; // The line continues across a hidden sample.
            opacity = dot(order_[k]).opacity;
            break;
        }
        if (drawn.ends_before) points.push_back(end_point(order_[drawn.first], order_[drawn.first - 1], -1, opacity));
        for (std::int64_t k = drawn.first; k <= drawn.last; ++k) {
            const std::int64_t i = order_[k];
            const Dot& own = dot(i);
            if (is_seen(i)) opacity = own.opacity;
            const float radius = own.radius * row(total)[i] * profile(i);
            points.push_back({own.x, own.y, radius, opacity, own.depth, own.window, own.pixels_per_unit, 0.0F, own.id});
        }
        if (drawn.ends_after) points.push_back(end_point(order_[drawn.last], order_[drawn.last + 1], 1, opacity));
        for (std::int64_t k = 1; k < points.size(); ++k)
            points[k].length = points[k - 1].length +
                               glm::length(glm::vec2(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y));
    }

    [[nodiscard]] static StrokePoint between(const StrokePoint& a, const StrokePoint& b, float t) noexcept {
        const auto mixed = [t](float from, float to) { return from + t * (to - from); };
        StrokePoint point = t < 0.5F ? a : b;
        for (float StrokePoint::*const number :
             {&StrokePoint::x, &StrokePoint::y, &StrokePoint::opacity, &StrokePoint::depth, &StrokePoint::window,
              &StrokePoint::pixels_per_unit, &StrokePoint::length})
            point.*number = mixed(a.*number, b.*number);
        // Squares of radii are interpolated, because near an end they change linearly.
        point.radius = std::sqrt(mixed(a.radius * a.radius, b.radius * b.radius));
        return point;
    }

    // Returns the point at the end of the line, between sample j, which is drawn, and sample k, which is not.
    [[nodiscard]] StrokePoint end_point(std::int64_t j, std::int64_t k, int way, float opacity) const noexcept {
        const auto point = [&](const Dot& d) {
            return StrokePoint{d.x, d.y, 0.0F, opacity, d.depth, d.window, d.pixels_per_unit, 0.0F, d.id};
        };
        StrokePoint end = between(point(dot(j)), point(dot(k)), end_share(j, k));
        end.radius = dot(j).radius * row(total)[j] * profile_at_end(j, k, way);
        return end;
    }

    [[nodiscard]] StrokePoint raw_at(float length) const noexcept {
        const auto* const next = std::upper_bound(raw().begin() + 1, raw().end() - 1, length,
                                                  [](float wanted, const StrokePoint& p) { return wanted < p.length; });
        const StrokePoint& a = *(next - 1);
        const float way = next->length - a.length;
        return between(a, *next, way > 0.0F ? std::clamp((length - a.length) / way, 0.0F, 1.0F) : 0.0F);
    }

    // Returns the point at `length`, near a tip. The width is a square root that is 0 at the tip and equals the line's
    // width at `full`.
    [[nodiscard]] StrokePoint tip_point(float length, float full, float from_tip) const noexcept {
        StrokePoint point = raw_at(length);
        point.radius = raw_at(full).radius * std::sqrt(from_tip / hatch_tuning.tip_reach);
        return point;
    }

    // Narrows a line where it would cover an edge beside it.
    void keep_within_edges(std::int64_t first) noexcept {
        if (hiding_.edges.empty()) return;
        base::Array<StrokePoint>& points = part_.made.points;
        for (std::int64_t i = first; i < points.size(); ++i) {
            const StrokePoint& before = points[std::max(i - 1, first)];
            const StrokePoint& after = points[std::min(i + 1, points.size() - 1)];
            points[i].radius = hiding_.edges.clear_width(points[i], glm::vec2(after.x - before.x, after.y - before.y),
                                                         points[i].radius, std::min(halo_, hatch_tuning.widest_halo));
        }
    }

    // Leaves out points that are on the line between their neighbours. This makes fewer segments to draw.
    void leave_out(std::int64_t first, std::int64_t last) {
        base::Array<StrokePoint>& points = part_.made.points;
        std::int64_t kept = first;
        std::int64_t from = first; // the last point that is kept
        AllowedSlopes passage(points[first]);
        for (std::int64_t i = first + 1; i < points.size(); ++i) {
            passage.take(points[i]);
            if (i < last && i - from <= hatch_tuning.most_left_out && points[i].opacity == points[kept].opacity &&
                passage.allows(points[i + 1]))
                continue;
            if (++kept != i) points[kept] = points[i];
            from = i;
            passage = AllowedSlopes(points[kept]);
        }
        points.resize(kept + 1);
    }

    // The order in which samples are drawn. In a ring, it begins in a gap.
    struct SampleOrder {
        std::int64_t start = 0;
        std::int64_t around = 0; // the number of samples in a ring whose order is rotated; else 0

        [[nodiscard]] std::int64_t operator[](std::int64_t k) const noexcept {
            return around > 0 ? (start + k) % around : k;
        }
    };

    const Run& run_;
    const LayerStyle& style_;
    const InkChoice* inks_;
    float halo_;
    const Hiding& hiding_;
    const HatchChain& chain_;
    std::span<const HatchSample> samples_;
    std::span<Dot> dots_;
    HatchStrokePart& part_;
    SampledLine line_;
    SampleOrder order_;
    std::array<bool, presences> ends_by_{};
};

} // namespace

void make_strokes(const base::Runtime& runtime, const Scene& scene, const Hiding& hiding,
                  std::span<HatchPoints::Batch> batches, drawing::Drawing& drawing) {
    runtime.parallel.for_each(static_cast<std::int64_t>(batches.size()), [&](std::int64_t number) {
        HatchPoints::Batch& batch = batches[static_cast<std::size_t>(number)];
        const Run& run = scene.runs[batch.run];
        HatchStrokePart& part = batch.part;
        part.clear();
        Dot* const dots = drawing.dots.data() + batch.first_dot;
        for (const HatchChain& chain : batch.samples.chain) {
            const std::span<Dot> own(dots + chain.first, static_cast<std::size_t>(chain.count));
            const std::span<const HatchSample> samples(batch.samples.sample.data() + chain.first, own.size());
            std::uint32_t last = 0;
            for (std::size_t i = 0; i < own.size(); ++i) {
                const bool is_seen = own[i].opacity > 0.0F;
                part.seen += is_seen ? 1 : 0;
                if (std::exchange(last, own[i].id) == own[i].id || is_seen) continue;
                part.hidden += *std::min_element(samples[i].margin.begin(), samples[i].margin.end()) >= 0.0F ? 1 : 0;
            }
            ChainStrokes(run, scene.inks_of(run), scene.item_of(run).style.halo_width, hiding, chain, samples, own,
                         part)();
            for (Dot& dot : own) dot.opacity = 0.0F;
        }
        std::uint32_t last = 0;
        for (const StrokePoint& point : part.made.points) part.shown += std::exchange(last, point.id) != point.id;
    });
    for (const HatchPoints::Batch& batch : batches) {
        const HatchStrokePart& part = batch.part;
        drawing.dot_count -= part.seen;
        drawing.counts.shown += part.shown - part.seen;
        drawing.counts.dropped_hidden += part.hidden - (batch.samples.sample.size() - part.seen);
    }
}

} // namespace hrbfnpr::frame

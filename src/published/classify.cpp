// SPDX-License-Identifier: MIT
#include "published/classify.h"

#include <cmath>

namespace hrbfnpr::published {
namespace {

// The largest disc that the mark can paint decides whether it can reach the viewport.
[[nodiscard]] float reach(const Run& run, float pixels_per_unit) noexcept {
    float radius = 0.0F;
    if (run.draws_front) radius = run.pen.front_ink(pixels_per_unit);
    if (run.draws_silhouettes) radius = std::max(radius, run.pen.silhouette_ink(pixels_per_unit));
    if (run.paints_paper || run.occludes)
        radius = std::max({radius, run.pen.front_splat(pixels_per_unit), run.pen.back_splat(pixels_per_unit)});
    return radius + 0.5F; // the soft rim
}

// Everything is asked so that a value that is not a number answers "outside".
[[nodiscard]] bool inside(const glm::vec4& viewport, float x, float y, float window_depth, float radius) noexcept {
    return x > viewport.x - radius && x < viewport.x + viewport.z + radius && y > viewport.y - radius &&
           y < viewport.y + viewport.w + radius && window_depth >= 0.0F && window_depth <= 1.0F;
}

[[nodiscard]] MarkClass class_of(float nu, float threshold) noexcept {
    if (nu < -threshold) return MarkClass::front;
    return nu > threshold ? MarkClass::back : MarkClass::silhouette;
}

class Classifier {
public:
    Classifier(Scene& scene, const Chunk& chunk) noexcept
        : lens_(scene.lens), run_(scene.runs[chunk.run]), item_(scene.item_of(run_)), style_(item_.style),
          out_(scene.marks), threshold_(static_cast<float>(style_.silhouette_threshold)), tone_(style_),
          depth_tone_(style_, lens_.eye_per_world) {}

    void operator()(std::int64_t place) const noexcept {
        const std::int64_t mark = place - run_.first;
        out_.mark_class[place] = MarkClass::none;
        const glm::vec3 eye = item_.to_eye * run_.place_of(mark, item_.unit) + item_.eye_offset;
        const glm::vec4 clip = lens_.window * glm::vec4(eye, 1.0F);
        if (!(clip.w > 0.0F)) return; // behind the camera
        const float pixels_per_unit = lens_.pixels / clip.w;
        const glm::vec3 at = glm::vec3(clip) / clip.w;
        const glm::vec3 own_normal = run_.normal_of(mark);
        const glm::vec3 normal = glm::normalize(item_.normal_to_eye * own_normal);
        const float nu = glm::dot(normal, glm::normalize(lens_.sight(eye)));
        if (!inside(lens_.viewport, at.x, at.y, at.z, reach(run_, pixels_per_unit)) || !(std::abs(nu) <= 1.001F))
            return;
        out_.x[place] = at.x;
        out_.y[place] = at.y;
        out_.window_depth[place] = at.z;
        out_.depth[place] = -eye.z;
        out_.pixels_per_unit[place] = pixels_per_unit;
        out_.nu[place] = nu;
        out_.tau[place] = style_.tone == Tone::light ? tone_(lit(item_.light, own_normal)) : 0.0F;
        out_.tau_depth[place] = depth_tone_(lens_.centre.w == 0.0F ? -eye.z : glm::length(lens_.sight(eye)));
        out_.mark_class[place] = class_of(nu, threshold_);
    }

private:
    const Lens& lens_;
    const Run& run_;
    const ItemView& item_;
    const Style& style_;
    Marks& out_;
    float threshold_;
    LightTone tone_;
    DepthTone depth_tone_; // by the way from the eye, or from its plane where there is no eye
};

// Whether a front mark would be ink but for tone, depth, zoom and visibility.
[[nodiscard]] bool may_be_ink(const Run& run, std::int64_t mark) noexcept {
    return run.draws_front && (run.directions == 3U || run.draws_set(run.marks->stroke[2 * mark] & 1U));
}

class Decider {
public:
    Decider(Scene& scene, const Chunk& chunk, const VisibilityMap* visibility) noexcept
        : run_(scene.runs[chunk.run]), style_(scene.item_of(run_).style), marks_(scene.marks), visibility_(visibility),
          share_(run_.style->share) {}

    void operator()(std::int64_t place, Counts& info) const noexcept {
        const MarkClass mark_class = marks_.mark_class[place];
        std::uint8_t role = 0;
        switch (mark_class) {
        case MarkClass::none: ++info.outside; break;
        case MarkClass::back: ++info.back; break;
        case MarkClass::front:
            ++info.front;
            if (front_ink(place, info)) role = role_ink;
            break;
        case MarkClass::silhouette:
            ++info.silhouette;
            if (silhouette_ink(place, info)) role = role_ink;
            break;
        }
        if (role == role_ink) ++info.shown;
        if (paper(place, mark_class)) {
            ++info.splats;
            role |= role_paper;
        }
        marks_.role[place] = role;
    }

private:
    bool front_ink(std::int64_t place, Counts& info) const noexcept {
        const std::int64_t mark = place - run_.first;
        if (!may_be_ink(run_, mark)) return false;
        const float pixels_per_unit = marks_.pixels_per_unit[place];
        const ToneTerms terms{marks_.tau[place], marks_.tau_depth[place], run_.pen.scale(pixels_per_unit), share_};
        switch (front_verdict(run_.marks->rank[mark], terms, style_.tone_rule)) {
        case Verdict::shown: return visible(place, run_.front_ink(mark, pixels_per_unit), info);
        case Verdict::tone: ++info.dropped_tone; break;
        case Verdict::zoom: ++info.dropped_zoom; break;
        case Verdict::depth: ++info.dropped_depth; break;
        }
        return false;
    }
    bool silhouette_ink(std::int64_t place, Counts& info) const noexcept {
        if (!run_.draws_silhouettes) return false;
        const float rank = run_.marks->rank[place - run_.first];
        if (silhouette_shown(rank, marks_.tau_depth[place], style_.tone_rule))
            return visible(place, run_.pen.silhouette_ink(marks_.pixels_per_unit[place]), info);
        ++info.dropped_depth;
        return false;
    }
    bool visible(std::int64_t place, float radius, Counts& info) const noexcept {
        if (visibility_ == nullptr) return true;
        const float depth = ink_depth(marks_.depth[place], radius, marks_.pixels_per_unit[place]);
        if (!visibility_->hides(marks_.x[place], marks_.y[place], depth)) return true;
        ++info.dropped_hidden;
        return false;
    }
    [[nodiscard]] bool paper(std::int64_t place, MarkClass mark_class) const noexcept {
        if (!run_.paints_paper) return false;
        if (mark_class == MarkClass::front)
            return front_alpha(marks_.nu[place], static_cast<float>(style_.attenuation_front)) > 0.0F;
        return mark_class == MarkClass::back &&
               back_alpha(marks_.nu[place], static_cast<float>(style_.attenuation_back)) > 0.0F;
    }

    const Run& run_;
    const Style& style_;
    Marks& marks_;
    const VisibilityMap* visibility_;
    float share_;
};

} // namespace

void classify(const base::Parallel& parallel, Scene& scene) {
    parallel.for_each(scene.chunks.size(), [&](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Classifier one(scene, chunk);
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i) one(i);
    });
}

void ask_tones(Scene& scene, ToneCalls& calls) {
    for (const Run& run : scene.runs) {
        const ItemView& item = scene.item_of(run);
        if (item.style.tone != Tone::callback) continue;
        calls.begin(item, scene.marks.tau);
        for (std::int64_t i = 0; i < run.count; ++i) {
            if (scene.marks.mark_class[run.first + i] == MarkClass::front && may_be_ink(run, i))
                calls.add(run.place_of(i, item.unit), run.normal_of(i), run.first + i);
        }
        calls.end();
    }
}

void decide(const base::Parallel& parallel, Scene& scene, const VisibilityMap* visibility,
            base::Array<Counts>& counts) {
    counts.clear();
    counts.resize(scene.chunks.size());
    parallel.for_each(scene.chunks.size(), [&](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Decider one(scene, chunk, visibility);
        Counts info;
        info.marks = chunk.end - chunk.begin;
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i) one(i, info);
        counts[c] = info;
    });
}

} // namespace hrbfnpr::published

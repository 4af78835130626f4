#include "frame/frame.h"

#include "base/clock.h"
#include "frame/classify.h"
#include "frame/order.h"
#include "frame/scene.h"
#include "frame/scratch.h"
#include "frame/visibility.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t disc_grain = 4096;

[[nodiscard]] glm::vec3 unit_or_zero(const glm::vec3& v) noexcept {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(0.0F);
}

} // namespace

struct Frame::Impl {
    explicit Impl(const base::Runtime& host)
        : runtime(host), scene(host.memory), tone_calls(host.memory), visibility(host.memory), order(host.memory),
          counts(host.memory), first_key(host.memory), keys(host.memory), discs(host.memory) {}

    void run(std::span<const Item> items, const Camera& new_camera);
    [[nodiscard]] bool hides() const noexcept;
    void sum_counts();
    void emit_keys();
    void build_discs();
    [[nodiscard]] std::uint64_t ink_key(const Run& run, std::int64_t place) const noexcept;
    [[nodiscard]] std::uint64_t paper_key(const Run& run, std::int64_t place) const noexcept;
    [[nodiscard]] Disc disc_of(const Run& run, std::int64_t place, bool is_paper) const noexcept;
    [[nodiscard]] float ink_radius(const Run& run, std::int64_t place) const noexcept;
    [[nodiscard]] float cover_radius(const Run& run, std::int64_t place) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

    const base::Runtime& runtime;
    bool prepared = false;
    Camera camera;
    glm::vec4 paper{1.0F};
    FrameInfo info;
    Scene scene;
    ToneCalls tone_calls;
    VisibilityMap visibility;
    FarToNear order;
    base::Array<FrameInfo> counts;       // of each chunk
    base::Array<std::int64_t> first_key; // of each chunk
    base::Array<std::uint64_t> keys;
    base::Array<Disc> discs;
};

void Frame::Impl::run(std::span<const Item> items, const Camera& new_camera) {
    const base::Parallel& parallel = runtime.parallel;
    base::Stopwatch watch;
    set_up(scene, items, new_camera);
    camera = new_camera;
    paper = items.empty() ? Style{}.paper : items[0].style.paper;
    classify(parallel, scene);
    tone_calls.run(scene);
    const std::int64_t classified = watch.nanoseconds();

    watch.restart();
    const bool hiding = hides();
    if (hiding) visibility.build(parallel, scene);
    const std::int64_t seen = watch.nanoseconds();

    watch.restart();
    decide(parallel, scene, hiding ? &visibility : nullptr, counts);
    sum_counts();
    info.nanoseconds_classify = classified + watch.nanoseconds();
    info.nanoseconds_visibility = seen;

    watch.restart();
    emit_keys();
    order.sort(parallel, keys);
    build_discs();
    info.nanoseconds_sort = watch.nanoseconds();
    info.scratch_bytes = bytes();
}

bool Frame::Impl::hides() const noexcept {
    return std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.occludes; });
}

void Frame::Impl::sum_counts() {
    info = FrameInfo{};
    for (const FrameInfo& chunk : counts) {
        info.marks += chunk.marks;
        info.outside += chunk.outside;
        info.front += chunk.front;
        info.back += chunk.back;
        info.silhouette += chunk.silhouette;
        info.shown += chunk.shown;
        info.dropped_tone += chunk.dropped_tone;
        info.dropped_depth += chunk.dropped_depth;
        info.dropped_zoom += chunk.dropped_zoom;
        info.dropped_hidden += chunk.dropped_hidden;
        info.painted += chunk.painted;
    }
}

float Frame::Impl::ink_radius(const Run& run, std::int64_t place) const noexcept {
    const float ppe = scene.marks.ppe[place];
    return scene.marks.mark_class[place] == MarkClass::silhouette ? run.pen.silhouette_ink(ppe)
                                                                  : run.front_ink(place - run.first, ppe);
}

float Frame::Impl::cover_radius(const Run& run, std::int64_t place) const noexcept {
    const float ppe = scene.marks.ppe[place];
    return scene.marks.mark_class[place] == MarkClass::back ? run.pen.back_cover(ppe) : run.pen.front_cover(ppe);
}

std::uint64_t Frame::Impl::ink_key(const Run& run, std::int64_t place) const noexcept {
    const Marks& m = scene.marks;
    const float depth = ink_depth(m.depth[place], ink_radius(run, place), m.ppe[place]);
    return far_first_key(depth, static_cast<std::uint32_t>(place) << 1U);
}

std::uint64_t Frame::Impl::paper_key(const Run& run, std::int64_t place) const noexcept {
    const Marks& m = scene.marks;
    return far_first_key(paper_depth(m, place, cover_radius(run, place)), static_cast<std::uint32_t>(place) << 1U | 1U);
}

// A key for each disc, in the order of the marks.
void Frame::Impl::emit_keys() {
    resize_scratch(first_key, counts.size());
    std::int64_t total = 0;
    for (std::int64_t c = 0; c < counts.size(); ++c) {
        first_key[c] = total;
        total += counts[c].shown + counts[c].painted;
    }
    resize_scratch(keys, total);
    runtime.parallel.for_each(scene.chunks.size(), [this](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Run& run = scene.runs[chunk.run];
        std::int64_t next = first_key[c];
        for (std::int64_t place = chunk.begin; place < chunk.end; ++place) {
            const unsigned role = scene.marks.role[place];
            if ((role & role_paper) != 0) keys[next++] = paper_key(run, place);
            if ((role & role_ink) != 0) keys[next++] = ink_key(run, place);
        }
    });
}

void Frame::Impl::build_discs() {
    resize_scratch(discs, keys.size());
    runtime.parallel.for_chunks(keys.size(), disc_grain, [this](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto what = static_cast<std::uint32_t>(keys[i]);
            const std::int64_t place = what >> 1U;
            const Run* run = std::upper_bound(scene.runs.begin(), scene.runs.end(), place,
                                              [](std::int64_t p, const Run& r) { return p < r.first; }) -
                             1;
            discs[i] = disc_of(*run, place, (what & 1U) != 0);
        }
    });
}

Disc Frame::Impl::disc_of(const Run& run, std::int64_t place, bool is_paper) const noexcept {
    const Marks& m = scene.marks;
    const Style& style = scene.item_of(run).style;
    Disc disc;
    disc.x = m.x[place];
    disc.y = m.y[place];
    disc.depth = m.window_depth[place];
    disc.id = run.first_id + static_cast<std::uint32_t>(place - run.first);
    disc.mark_class = m.mark_class[place];
    disc.is_paper = is_paper;
    if (!is_paper) {
        disc.radius = ink_radius(run, place);
        disc.color = disc.mark_class == MarkClass::silhouette ? style.silhouette_ink
                                                              : style.group[static_cast<std::size_t>(run.group)].ink;
        return disc;
    }
    disc.radius = cover_radius(run, place);
    const float opacity = disc.mark_class == MarkClass::back
                              ? run.pen.back_opacity(m.nu[place], disc.radius, m.ppe[place])
                              : run.pen.front_opacity(m.nu[place], disc.radius, m.ppe[place]);
    disc.color = glm::vec4(glm::vec3(paper), opacity);
    return disc;
}

std::int64_t Frame::Impl::bytes() const noexcept {
    return scene.bytes() + tone_calls.bytes() + visibility.bytes() + order.bytes() + counts.bytes() +
           first_key.bytes() + keys.bytes() + discs.bytes();
}

Frame::Frame(const base::Runtime& runtime) : impl_(std::make_unique<Impl>(runtime)) {}
Frame::~Frame() = default;

void Frame::prepare(std::span<const Item> items, const Camera& camera) {
    impl_->prepared = false;
    impl_->discs.clear();
    impl_->run(items, camera);
    impl_->prepared = true;
}

bool Frame::prepared() const noexcept { return impl_->prepared; }
const Camera& Frame::camera() const noexcept { return impl_->camera; }
const glm::vec4& Frame::paper() const noexcept { return impl_->paper; }
std::span<const Disc> Frame::discs() const noexcept { return std::as_const(impl_->discs).span(); }
const FrameInfo& Frame::info() const noexcept { return impl_->info; }

Frame::MarkSource Frame::source(const Disc& disc) const noexcept {
    const Scene& scene = impl_->scene;
    const Run& run = *(std::upper_bound(scene.runs.begin(), scene.runs.end(), disc.id,
                                        [](std::uint32_t id, const Run& r) { return id < r.first_id; }) -
                       1);
    const ItemView& item = scene.item_of(run);
    const std::int64_t mark = disc.id - run.first_id;
    const auto at = [mark](const base::Array<float>& a) {
        return glm::vec3(a[3 * mark], a[3 * mark + 1], a[3 * mark + 2]);
    };
    MarkSource source;
    source.position = glm::vec3(item.to_world * glm::dvec4(at(run.marks->position), 1.0));
    source.normal = unit_or_zero(item.normal_to_world * at(run.marks->normal));
    source.direction = unit_or_zero(glm::mat3(glm::dmat3(item.to_world)) * at(run.marks->direction));
    return source;
}

} // namespace hrbfnpr::frame

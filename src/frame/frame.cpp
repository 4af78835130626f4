#include "frame/frame.h"

#include "frame/depth_layers/layer_frame.h"
#include "frame/published/published_frame.h"
#include "frame/scene/scene.h"
#include "geometry/unit.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

[[nodiscard]] glm::vec3 unit_or_zero(const glm::vec3& v) noexcept {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(0.0F);
}

// The linear part, so that squares of what it gives are floats: lengths do not matter.
[[nodiscard]] glm::mat3 of_moderate_scale(const glm::dmat4& m) noexcept {
    return glm::mat3(glm::dmat3(m) / geometry::unit_for(mean_scale(m)));
}

} // namespace

struct Frame::Impl {
    explicit Impl(const base::Runtime& host) : scene(host.memory), published_frame(host), layer_frame(host) {}

    bool prepared = false;
    bool published = false;
    Camera camera;
    glm::vec4 paper{1.0F};
    FrameInfo info;
    Scene scene;
    PublishedFrame published_frame;
    LayerFrame layer_frame;
};

Frame::Frame(const base::Runtime& runtime) : impl_(std::make_unique<Impl>(runtime)) {}
Frame::~Frame() = default;

void Frame::prepare(std::span<const Item> items, const Camera& camera) {
    Impl& own = *impl_;
    own.prepared = false;
    own.camera = camera;
    own.paper = items.empty() ? Style{}.paper : items[0].style.paper;
    own.published = !items.empty() && items[0].style.visibility == Visibility::published;
    set_up(own.scene, items, camera);
    if (own.published)
        own.published_frame.run(own.scene, own.paper);
    else
        own.layer_frame.run(own.scene);
    own.info = own.published ? own.published_frame.info() : own.layer_frame.info();
    own.info.scratch_bytes = own.scene.bytes() + own.published_frame.bytes() + own.layer_frame.bytes();
    own.prepared = true;
}

bool Frame::prepared() const noexcept { return impl_->prepared; }
const Camera& Frame::camera() const noexcept { return impl_->camera; }
const glm::vec4& Frame::paper() const noexcept { return impl_->paper; }
std::span<const Disc> Frame::discs() const {
    return impl_->published ? impl_->published_frame.discs() : impl_->layer_frame.discs();
}
const LayerFrame* Frame::layer_frame() const noexcept { return impl_->published ? nullptr : &impl_->layer_frame; }
const FrameInfo& Frame::info() const noexcept { return impl_->info; }

Frame::MarkSource Frame::source(const Disc& disc) const noexcept {
    const Scene& scene = impl_->scene;
    const Run& run = *(std::upper_bound(scene.runs.begin(), scene.runs.end(), disc.id,
                                        [](std::uint32_t id, const Run& r) { return id < r.first_id; }) -
                       1);
    const ItemView& item = scene.item_of(run);
    const std::int64_t mark = disc.id - run.first_id;
    MarkSource source;
    source.position = glm::vec3(item.to_world * glm::dvec4(item.place(*run.marks, mark), 1.0));
    source.normal = unit_or_zero(item.normal_to_world * marks::vector_at(run.marks->normal, mark));
    source.direction = unit_or_zero(of_moderate_scale(item.to_world) * marks::vector_at(run.marks->direction, mark));
    return source;
}

} // namespace hrbfnpr::frame

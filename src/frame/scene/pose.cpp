// SPDX-License-Identifier: MIT
#include "frame/scene/pose.h"

#include "marks/clusters.h"

#include <cmath>

namespace hrbfnpr::frame {
namespace {

// A normal's length may be off 1 by so much, as of floats that were turned.
constexpr double most_off_unit = 1e-2;

// Marks are floats.
constexpr double farthest = 1e33;

class Poser {
public:
    Poser(const Item& item, std::int64_t number, drawing::Drawing& drawing) noexcept
        : item_(item), number_(number), drawing_(drawing) {}

    void operator()(const Pose& pose, std::int64_t pose_number) {
        pose_number_ = pose_number;
        drawing::Run& run = run_of(pose.layer);
        if (run.posed >= 0) refuse("layer", pose.layer, "poses the same layer as one before");
        run.posed = drawing_.posed_position.size() / 3;
        run.poses_directions = !pose.direction.empty();
        for (std::int64_t i = 0; i < run.count; ++i) {
            add(drawing_.posed_position, vector(pose.position, i, "position") - item_.set->origin);
            add(drawing_.posed_normal, unit_vector(pose.normal, i, "normal"));
            add(drawing_.posed_direction,
                run.poses_directions ? unit_vector(pose.direction, i, "direction") : glm::dvec3(0.0));
        }
    }

private:
    [[nodiscard]] drawing::Run& run_of(std::int64_t layer) {
        for (drawing::Run& run : drawing_.runs)
            if (run.item == number_ && run.layer == layer) return run;
        refuse("layer", layer, "is no layer of the item's point set");
    }

    [[noreturn]] void refuse(const char* field, std::int64_t value, const char* why) const {
        fail(Status::invalid_argument, "items[%lld].poses[%lld].%s is %lld, which %s", static_cast<long long>(number_),
             static_cast<long long>(pose_number_), field, static_cast<long long>(value), why);
    }

    [[nodiscard]] glm::dvec3 vector(const base::InView& view, std::int64_t i, const char* name) const {
        const glm::dvec3 v(view.get(i, 0), view.get(i, 1), view.get(i, 2));
        // Also where one is not a number.
        if (std::abs(v.x) <= farthest && std::abs(v.y) <= farthest && std::abs(v.z) <= farthest) return v;
        fail(Status::invalid_argument,
             "items[%lld].poses[%lld].%s[%lld] is %g %g %g; numbers must be finite, of 1e33 at most",
             static_cast<long long>(number_), static_cast<long long>(pose_number_), name, static_cast<long long>(i),
             v.x, v.y, v.z);
    }

    [[nodiscard]] glm::dvec3 unit_vector(const base::InView& view, std::int64_t i, const char* name) const {
        const glm::dvec3 v = vector(view, i, name);
        const double length = glm::length(v);
        if (std::abs(length - 1.0) <= most_off_unit) return v / length;
        fail(Status::invalid_argument, "items[%lld].poses[%lld].%s[%lld] has the length %g; it must be 1",
             static_cast<long long>(number_), static_cast<long long>(pose_number_), name, static_cast<long long>(i),
             length);
    }

    static void add(base::Array<float>& array, const glm::dvec3& v) {
        for (int k = 0; k < 3; ++k) array.push_back(static_cast<float>(v[k]));
    }

    const Item& item_;
    std::int64_t number_;
    std::int64_t pose_number_ = 0;
    drawing::Drawing& drawing_;
};

// A ball around all marks of an item, wherever they are.
void enclose(const drawing::Drawing& drawing, const drawing::Run& run, ItemView& view) noexcept {
    for (std::int64_t i = 0; i < run.count; ++i) {
        const glm::vec3 place =
            glm::vec3(glm::dvec3(marks::vector_at(drawing.posed_position, run.posed + i)) / view.unit);
        view.radius = std::max(view.radius, 1.0001F * glm::length(place - view.centre));
    }
}

} // namespace

void pose(Scene& scene, std::span<const Item> items, drawing::Drawing& drawing) {
    std::int64_t posed = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        Poser poser(items[i], static_cast<std::int64_t>(i), drawing);
        for (std::size_t p = 0; p < items[i].poses.size(); ++p) {
            poser(items[i].poses[p], static_cast<std::int64_t>(p));
            ++posed;
        }
    }
    if (posed == 0) return;
    for (const drawing::Run& run : drawing.runs)
        if (run.posed >= 0) enclose(drawing, run, scene.items[run.item]);
    // All are there: from here on nothing moves any more.
    scene.posed.reserve(scene.runs.size());
    std::int64_t number = 0;
    for (Run& run : scene.runs) {
        const drawing::Run& source = *drawing.run_of(run.first_id);
        if (source.posed < 0) continue;
        run.position = drawing.posed_position.data() + 3 * source.posed;
        run.normal = drawing.posed_normal.data() + 3 * source.posed;
        if (source.poses_directions) run.posed_direction = drawing.posed_direction.data() + 3 * source.posed;
        if (number == scene.posed.size()) scene.posed.add(scene.items.memory());
        marks::MarkClusters& moved = scene.posed[number++];
        marks::move_clusters(*run.marks, run.position, run.normal, scene.items[run.item].unit, moved);
        run.clusters = &moved;
        run.is_posed = true;
    }
}

} // namespace hrbfnpr::frame

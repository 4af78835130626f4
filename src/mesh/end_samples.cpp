// SPDX-License-Identifier: MIT
#include "mesh/end_samples.h"

#include "geometry/point_tree.h"

#include <optional>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

// Of `closest`: how far beyond a row s is 1.5, measured, and how far apart its places are then.
constexpr double row_inset = 0.943;
constexpr double row_step = 0.15;
// Of the inset: what is nearer to the border than the first is not as far inside as a row shall be; even samples that
// are nearer than the second are in the row's place; a place of the border has a row if some of it is within the third.
constexpr double far_inside = 0.9;
constexpr double in_its_place = 1.7;
constexpr double covered = 2.0;
// Of the circumference of a circle of that radius: shorter borders are those of holes that stay closed.
constexpr double shortest = 1.5;
constexpr std::int64_t candidates_each = 4;
constexpr std::int64_t sides_a_task = 256;

// Lengths of the mesh's borders, by a vertex of each.
class Borders {
public:
    explicit Borders(const Mesh& mesh) : mesh_(mesh), of_(mesh.vertex.memory()), length_(mesh.vertex.memory()) {
        of_.resize_for_overwrite(mesh.vertex.size());
        for (std::int64_t i = 0; i < of_.size(); ++i) of_[i] = static_cast<std::int32_t>(i);
        length_.resize(mesh.vertex.size());
        for_sides([&](std::int64_t face, std::size_t k) {
            const auto [a, b] = ends(face, k);
            of_[root(a)] = root(b);
        });
        for_sides([&](std::int64_t face, std::size_t k) {
            const auto [a, b] = ends(face, k);
            length_[root(a)] += glm::distance(mesh_.vertex[a], mesh_.vertex[b]);
        });
    }
    template <class F>
    void for_sides(F&& work) const {
        for (std::int64_t face = 0; face < mesh_.faces(); ++face)
            for (std::size_t k = 0; k < 3; ++k)
                if ((mesh_.border[face] >> k & 1) != 0) work(face, k);
    }
    [[nodiscard]] double length(std::int64_t face, std::size_t k) { return length_[root(ends(face, k).first)]; }

private:
    [[nodiscard]] std::pair<std::int32_t, std::int32_t> ends(std::int64_t face, std::size_t k) const noexcept {
        const Triangle& t = mesh_.triangle[face];
        return {t[k], t[(k + 1) % 3]};
    }
    [[nodiscard]] std::int32_t root(std::int32_t vertex) noexcept {
        while (of_[vertex] != vertex) vertex = of_[vertex] = of_[of_[vertex]];
        return vertex;
    }

    const Mesh& mesh_;
    base::Array<std::int32_t> of_;
    base::Array<double> length_;
};

class Row {
public:
    Row(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, double closest)
        : mesh_(mesh), tree_(tree), inset_(row_inset * closest), border_(runtime.memory), inside_(runtime.memory) {
        place(row_step * closest, shortest * 6.283185307179586 * closest);
        edge_.emplace(border_.position, base::Progress{});
        for (std::int64_t i = 0; i < border_.position.size(); ++i) go_inside(i);
        row_.emplace(inside_.position, base::Progress{});
        // Where there is no room for a row, as on a narrow strip, the border itself stands for it.
        for (std::int64_t i = 0; i < border_.position.size(); ++i)
            if (!has_row(i)) add(inside_, border_.position[i], border_.face[i]);
    }

    [[nodiscard]] const MeshSamples& samples() const noexcept { return inside_; }
    // Whether a place is left to the row.
    [[nodiscard]] bool replaces(const glm::dvec3& p) const noexcept {
        const std::int64_t i = nearest(*edge_, p);
        return i >= 0 && glm::distance(border_.position[i], p) < in_its_place * inset_ && has_row(i);
    }

private:
    // Places along the border, `step` apart, with the way inside for their normals.
    void place(double step, double least) {
        Borders borders(mesh_);
        double along = 0.5 * step; // to the next place
        borders.for_sides([&](std::int64_t face, std::size_t k) {
            if (borders.length(face, k) < least) return;
            const auto p = mesh_.corners(face);
            const glm::dvec3 side = p[(k + 1) % 3] - p[k];
            const double length = glm::length(side);
            const glm::dvec3 in = glm::cross(doubled_area(p), side);
            for (; along < length; along += step) {
                border_.position.push_back(p[k] + along / length * side);
                border_.normal.push_back(glm::normalize(in));
                border_.face.push_back(static_cast<std::int32_t>(face));
            }
            along -= length;
        });
    }

    void go_inside(std::int64_t i) {
        const FaceTree::Nearest found = tree_.nearest(border_.position[i] + inset_ * border_.normal[i]);
        const std::int64_t beside = nearest(*edge_, found.place);
        if (glm::distance(border_.position[beside], found.place) >= far_inside * inset_)
            add(inside_, found.place, found.face);
    }

    void add(MeshSamples& to, const glm::dvec3& place, std::int64_t face) const {
        to.position.push_back(place);
        to.normal.push_back(normal_at(mesh_, face, shares_of(mesh_.corners(face), place)));
        to.face.push_back(static_cast<std::int32_t>(face));
    }

    [[nodiscard]] static std::int64_t nearest(const geometry::PointTree& tree, const glm::dvec3& p) {
        if (tree.size() == 0) return -1;
        std::int64_t at = -1;
        const auto any = [](std::int64_t) { return true; };
        return tree.nearest(p, 1, any, any, &at) == 1 ? tree.index(at) : -1;
    }

    [[nodiscard]] bool has_row(std::int64_t i) const noexcept {
        const std::int64_t at = nearest(*row_, border_.position[i]);
        return at >= 0 && glm::distance(inside_.position[at], border_.position[i]) < covered * inset_;
    }

    const Mesh& mesh_;
    const FaceTree& tree_;
    double inset_;
    MeshSamples border_, inside_;
    std::optional<geometry::PointTree> edge_, row_; // of them
};

} // namespace

double border_length(const Mesh& mesh) noexcept {
    double length = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const auto p = mesh.corners(face);
        for (std::size_t k = 0; k < 3; ++k)
            if ((mesh.border[face] >> k & 1) != 0) length += glm::distance(p[k], p[(k + 1) % 3]);
    }
    return length;
}

MeshSamples end_samples(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, std::int64_t count,
                        double closest, std::uint64_t seed, const base::Progress& progress) {
    const MeshSamples even = even_samples(runtime, mesh, count, candidates_each * count, seed, progress.part(0.0, 0.7));
    const Row row(runtime, mesh, tree, closest);
    base::Array<std::uint8_t> left_out(runtime.memory, even.position.size());
    runtime.parallel.for_chunks(left_out.size(), sides_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) left_out[i] = row.replaces(even.position[i]) ? 1 : 0;
    });
    MeshSamples all(runtime.memory);
    const auto add = [&](const MeshSamples& from, std::int64_t i) {
        all.position.push_back(from.position[i]);
        all.normal.push_back(from.normal[i]);
        all.face.push_back(from.face[i]);
    };
    for (std::int64_t i = 0; i < left_out.size(); ++i)
        if (left_out[i] == 0) add(even, i);
    for (std::int64_t i = 0; i < row.samples().position.size(); ++i) add(row.samples(), i);
    progress.update(1.0);
    return all;
}

} // namespace hrbfnpr::mesh

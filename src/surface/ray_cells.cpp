// SPDX-License-Identifier: MIT
// Cells are made level by level. Eight places of each cell, the middles of its octants, are evaluated with their second
// derivatives. The bound on the second derivatives of a cell is the largest that was found at these places and at the
// centres of the fit in and near the cell, times a factor. With it and the gradients at the eight places, f has no root
// in most cells; the others are divided.
#include "surface/ray_cells.h"

#include "base/clock.h"
#include "implicit/evaluate_all.h"
#include "surface/region.h"
#include "surface/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::surface {
namespace {

// The number of cells whose places are evaluated at a time. It limits the memory.
constexpr std::int64_t cells_at_a_time = 8192;

// The second derivative along any line is at most the Frobenius norm of the Hessian.
[[nodiscard]] double norm_of(const std::array<double, 6>& h) noexcept {
    const double diagonal = h[0] * h[0] + h[3] * h[3] + h[5] * h[5];
    return std::sqrt(diagonal + 2.0 * (h[1] * h[1] + h[2] * h[2] + h[4] * h[4]));
}

// Fields at many places.
struct Samples {
    Samples(base::Memory& memory, std::int64_t count) : columns(memory, 10 * count), size(count) {}

    base::Array<double> columns;
    std::int64_t size;

    [[nodiscard]] implicit::FieldBatch fields() noexcept {
        implicit::FieldBatch fields;
        fields.value = columns.data();
        for (std::size_t c = 0; c < 3; ++c) fields.gradient[c] = column(1 + c);
        for (std::size_t c = 0; c < 6; ++c) fields.hessian[c] = column(4 + c);
        return fields;
    }
    [[nodiscard]] double* column(std::size_t c) noexcept {
        return columns.data() + static_cast<std::int64_t>(c) * size;
    }
    [[nodiscard]] double value(std::int64_t i) const noexcept { return columns[i]; }
    [[nodiscard]] glm::dvec3 gradient(std::int64_t i) const noexcept {
        return {columns[size + i], columns[2 * size + i], columns[3 * size + i]};
    }
    [[nodiscard]] double bend(std::int64_t i) const noexcept {
        std::array<double, 6> h{};
        for (std::size_t c = 0; c < 6; ++c) h[c] = columns[static_cast<std::int64_t>(4 + c) * size + i];
        return norm_of(h);
    }
};

} // namespace

class RayCells::Builder {
public:
    Builder(const base::Work& work, RayCells& made)
        : work_(work), made_(made), near_(work.memory), place_(work.memory) {}

    void run() {
        add_roots();
        find_bends_of_centres();
        const double widest = std::max(ray_tuning.widest * made_.data_.spacing, 0.0);
        double width = made_.width_;
        for (int halvings = 0; begin_ < made_.cells_.size(); ++halvings, width *= 0.5) {
            const std::int64_t end = made_.cells_.size();
            raise_to_centres();
            for (std::int64_t at = begin_; at < end; at += cells_at_a_time)
                assess(at, std::min(end, at + cells_at_a_time), width);
            if (width > widest && halvings < ray_tuning.halvings) divide(end);
            begin_ = end;
        }
        made_.lipschitz_ =
            std::clamp(1.5 * steepest_, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
    }

private:
    void add_roots() {
        const std::array<std::int32_t, 3>& side = made_.side_;
        for (std::int32_t z = 0; z < side[2]; ++z)
            for (std::int32_t y = 0; y < side[1]; ++y)
                for (std::int32_t x = 0; x < side[0]; ++x) {
                    made_.cells_.push_back({});
                    place_.push_back({x, y, z});
                }
    }

    // At a centre, the Hessian without the centre's own term is known, and the own term is at most 6 |beta|.
    void find_bends_of_centres() {
        const implicit::HrbfData& data = made_.data_;
        const std::int64_t count = data.count();
        centres_ = geometry::VecArray(work_.memory, count);
        for (std::int64_t i = 0; i < count; ++i) centres_.set(i, data.centre + data.scale * data.centre_position[i]);
        Samples samples(work_.memory, count);
        implicit::evaluate_all(work_.part(0.0, 0.1), made_.prepared_, centres_, samples.fields());
        near_.resize(count);
        for (std::int64_t i = 0; i < count; ++i)
            near_[i] = samples.bend(i) + 6.0 * glm::length(data.beta[i]) / data.scale;
    }

    // Raises the bounds of the cells of the last level that are within a spacing of a centre.
    void raise_to_centres() {
        for (const std::int64_t i : work_.over(centres_.size())) {
            const glm::dvec3 middle = centres_[i] - made_.corner_;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 off(corner & 1, corner >> 1 & 1, corner >> 2);
                const Found found = made_.find(middle + made_.data_.spacing * (2.0 * off - 1.0));
                if (found.cell < begin_) continue; // that place is in a larger cell
                double& bend = made_.cells_[found.cell].bend;
                bend = std::max(bend, near_[i]);
            }
        }
    }

    // Finds the bounds and the kinds of the cells [from, to), which have this width.
    void assess(std::int64_t from, std::int64_t to, double width) {
        geometry::VecArray places(work_.memory);
        for (std::int64_t cell = from; cell < to; ++cell)
            for (int octant = 0; octant < 8; ++octant) {
                const glm::dvec3 off(octant & 1, octant >> 1 & 1, octant >> 2);
                const auto& at = place_[cell];
                places.push_back(made_.corner_ + width * (glm::dvec3(at[0], at[1], at[2]) + 0.25 + 0.5 * off));
            }
        Samples samples(work_.memory, places.size());
        implicit::evaluate_all(work_.without_progress(), made_.prepared_, places, samples.fields());
        for (std::int64_t cell = from; cell < to; ++cell)
            assess_cell(made_.cells_[cell], samples, 8 * (cell - from), width);
    }

    void assess_cell(Cell& cell, const Samples& samples, std::int64_t first, double width) {
        for (std::int64_t i = first; i < first + 8; ++i) {
            cell.bend = std::max(cell.bend, samples.bend(i));
            const double slope = glm::length(samples.gradient(i));
            if (std::isfinite(slope)) steepest_ = std::max(steepest_, slope);
        }
        cell.bend *= ray_tuning.safety;
        if (!std::isfinite(cell.bend)) cell.bend = std::numeric_limits<double>::infinity();
        const double half = 0.25 * width; // half the width of an octant
        const bool inside = samples.value(first) < 0.0;
        for (std::int64_t i = first; i < first + 8; ++i) {
            const glm::dvec3 slope = glm::abs(samples.gradient(i));
            const double change = half * (slope.x + slope.y + slope.z) + 1.5 * half * half * cell.bend;
            if (!(std::abs(samples.value(i)) > change) || (samples.value(i) < 0.0) != inside) return;
        }
        cell.kind = inside ? Kind::inside : Kind::outside;
    }

    // Gives children to the crossed cells of the last level, which ends at `end`.
    void divide(std::int64_t end) {
        for (std::int64_t cell = begin_; cell < end; ++cell) {
            if (made_.cells_[cell].kind != Kind::crossed) continue;
            made_.cells_[cell].first_child = static_cast<std::int32_t>(made_.cells_.size());
            const std::array<std::int32_t, 3> at = place_[cell];
            for (int octant = 0; octant < 8; ++octant) {
                made_.cells_.push_back({});
                place_.push_back({2 * at[0] + (octant & 1), 2 * at[1] + (octant >> 1 & 1), 2 * at[2] + (octant >> 2)});
            }
        }
    }

    const base::Work& work_;
    RayCells& made_;
    geometry::VecArray centres_{work_.memory};
    base::Array<double> near_;                       // a bound on the second derivatives around each centre
    base::Array<std::array<std::int32_t, 3>> place_; // place of each cell in the grid of its level
    std::int64_t begin_ = 0;                         // index of the first cell of the level
    double steepest_ = 0.0;                          // the largest |grad f| that was found
};

bool RayCells::pay(const implicit::HrbfData& data, std::int64_t rays) noexcept {
    return implicit::Prepared::pays(data, ray_tuning.evaluations * static_cast<double>(rays));
}

RayCells::RayCells(const base::Work& work, const implicit::Prepared& prepared, const implicit::HrbfData& data)
    : prepared_(prepared), data_(data), cells_(work.memory) {
    const geometry::Bounds region = search_region(prepared);
    const glm::dvec3 size = region.size();
    corner_ = region.min;
    width_ = std::max({size.x, size.y, size.z}) / ray_tuning.cells_across;
    for (glm::length_t c = 0; c < 3; ++c)
        side_[static_cast<std::size_t>(c)] = std::max(1, static_cast<std::int32_t>(std::ceil(size[c] / width_ - 1e-9)));
    const base::Stopwatch watch;
    Builder(work, *this).run();
    work.runtime().log(base::LogLevel::info, "rays: %lld cells made in %.3f s, %.1f MB",
                       static_cast<long long>(cells_.size()), watch.seconds(), static_cast<double>(bytes()) / 1e6);
}

RayCells::Found RayCells::find(const glm::dvec3& place) const noexcept {
    Found found{0, {}, width_};
    glm::dvec3 rest = place / width_;
    for (glm::length_t c = 0; c < 3; ++c) {
        const auto axis = static_cast<std::size_t>(c);
        found.place[axis] = static_cast<std::int32_t>(std::clamp(rest[c], 0.0, side_[axis] - 0.5));
        rest[c] -= found.place[axis];
    }
    found.cell = (std::int64_t{found.place[2]} * side_[1] + found.place[1]) * side_[0] + found.place[0];
    while (cells_[found.cell].first_child != 0) {
        std::int64_t octant = 0;
        for (glm::length_t c = 0; c < 3; ++c) {
            rest[c] *= 2.0;
            const int upper = rest[c] >= 1.0 ? 1 : 0;
            rest[c] -= upper;
            octant |= std::int64_t{upper} << c;
            auto& at = found.place[static_cast<std::size_t>(c)];
            at = 2 * at + upper;
        }
        found.cell = cells_[found.cell].first_child + octant;
        found.width *= 0.5;
    }
    return found;
}

RayCells::Line RayCells::line(const glm::dvec3& start, const glm::dvec3& direction) const noexcept {
    return {start - corner_, direction, 1.0 / direction, 1e-9 * width_ * glm::sign(direction)};
}

RayCells::Part RayCells::part(const Line& line, double from) const noexcept {
    // The nudge takes the place off the face through which the line comes. Without it, a line that is almost parallel
    // to the face would stay on the face's wrong side.
    const Found found = find(line.start + from * line.direction + line.nudge);
    double end = std::numeric_limits<double>::infinity();
    for (glm::length_t c = 0; c < 3; ++c) {
        if (line.direction[c] == 0.0) continue;
        const int upper = line.direction[c] > 0.0 ? 1 : 0;
        const double face = found.width * (found.place[static_cast<std::size_t>(c)] + upper);
        end = std::min(end, (face - line.start[c]) * line.inverse[c]);
    }
    return {&cells_[found.cell], std::max(end, from + 1e-9 * width_)};
}

} // namespace hrbfnpr::surface

// SPDX-License-Identifier: MIT
#include "visibility/pierced.h"

#include "curves/surface_end.h"
#include "implicit/evaluate_all.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::visibility {
namespace {

constexpr double known_piercing = 1e-10; // of a piece
constexpr int deepest_piece = 40;        // halvings of a piece
constexpr int deepest_outside = 6;       // of one whose ends lie outside the other's region
constexpr double in_surface = 1e-7;      // diagonals of the region: a line that stays nearer lies in the surface

// A place of a piece: f of the other surface there, its slope along the piece, and its gradient.
struct Place {
    double share;
    double value, slope;
    glm::dvec3 point, gradient; // in the other item's coordinates
    bool inside;                // the region where f is asked for

    [[nodiscard]] bool negative() const noexcept { return value < 0.0; }
};

struct PiercedPart {
    std::int32_t piece;
    int depth;
    Place low, high;
};

// Whether the cubic with these values and slopes (by the whole length) at its ends may have a root, for ends of one
// sign.
bool may_touch(double f0, double d0, double f1, double d1) noexcept {
    const double sign = f0 < 0.0 ? -1.0 : 1.0;
    return !(sign * f0 + sign * d0 / 3.0 > 0.0 && sign * f1 - sign * d1 / 3.0 > 0.0);
}

// Whether f, taken for a cubic, stays nearer to 0 than a distance.
bool stays_near(const Place& a, const Place& b, double length, double distance) noexcept {
    const auto near = [&](const Place& place) {
        const double most = distance * glm::length(place.gradient);
        return std::abs(place.value) <= most && std::abs(length * place.slope) <= most;
    };
    return near(a) && near(b);
}

// The lines of all other items against one surface.
class Search {
public:
    Search(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
           const Occluder& occluder, std::int32_t item)
        : runtime_(runtime), subjects_(subjects), lines_(lines), occluder_(occluder), item_(item),
          region_(occluder.sheets->mesh().region), in_surface_(in_surface * region_.diagonal()),
          from_world_(glm::inverse(occluder.to_world)), wanted_(runtime.memory), parts_(runtime.memory),
          next_(runtime.memory), sample_(runtime.memory) {}

    void run(base::Array<Pierced>& found, const base::Progress& progress);

private:
    struct Sample {
        std::int32_t piece;
        double share;
    };

    [[nodiscard]] const Subject& subject_of(std::int32_t piece) const noexcept {
        return subjects_[static_cast<std::size_t>(lines_.pieces[piece].subject)];
    }
    void want(std::int32_t piece, double share) { wanted_.push_back({piece, share}); }
    void evaluate(const base::Progress& progress);
    void start(const base::Progress& progress);
    [[nodiscard]] bool near_region(const PiercedPart& part) const noexcept;
    void judge(const PiercedPart& part, base::Array<Pierced>& found);
    void add(const PiercedPart& part, base::Array<Pierced>& found) const;

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    const ImageLines& lines_;
    const Occluder& occluder_;
    std::int32_t item_;
    geometry::Bounds region_;
    double in_surface_; // a length
    glm::dmat4 from_world_;
    base::Array<Sample> wanted_;
    base::Array<PiercedPart> parts_, next_; // to be halved
    base::Array<Place> sample_;             // at what was wanted
};

void Search::evaluate(const base::Progress& progress) {
    sample_.resize(wanted_.size());
    geometry::VecArray point(runtime_.memory);
    base::Array<glm::dvec3> way(runtime_.memory);
    for (std::int64_t i = 0; i < wanted_.size(); ++i) {
        const Subject& subject = subject_of(wanted_[i].piece);
        const glm::dmat4 to_other = from_world_ * subject.to_world;
        const curves::CubicPiece piece = cubic(subjects_, lines_.pieces[wanted_[i].piece]);
        Place& place = sample_[i];
        place = {};
        place.share = wanted_[i].share;
        place.point = glm::dvec3(to_other * glm::dvec4(piece.at(place.share), 1.0));
        place.inside = region_.contains(place.point);
        if (!place.inside) continue;
        point.push_back(place.point);
        way.push_back(glm::dmat3(to_other) * piece.derivative(place.share));
    }
    geometry::VecArray gradient(runtime_.memory, point.size());
    base::Array<double> value(runtime_.memory, point.size());
    implicit::evaluate_all(runtime_, *occluder_.surface, point,
                           {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}},
                           progress.part(0.0, 0.0));
    std::int64_t next = 0;
    for (Place& place : sample_) {
        if (!place.inside) continue;
        place.value = value[next];
        place.gradient = gradient[next];
        place.slope = glm::dot(place.gradient, way[next]);
        place.inside = std::isfinite(place.value) && std::isfinite(place.slope);
        ++next;
    }
    wanted_.clear();
}

// All pieces of other items, from end to end.
void Search::start(const base::Progress& progress) {
    for (std::int32_t p = 0; p < lines_.pieces.size(); ++p) {
        if (subject_of(p).item == item_) continue;
        want(p, 0.0);
        want(p, 1.0);
    }
    evaluate(progress);
    for (std::int64_t i = 0; i + 1 < sample_.size(); i += 2) {
        const auto piece = static_cast<std::int32_t>(parts_.size());
        parts_.push_back({piece, 0, sample_[i], sample_[i + 1]});
    }
    std::int64_t k = 0;
    for (std::int32_t p = 0; p < lines_.pieces.size(); ++p)
        if (subject_of(p).item != item_) parts_[k++].piece = p;
}

// The sheet lies before the line where the way back to the eye leads through it.
void Search::add(const PiercedPart& part, base::Array<Pierced>& found) const {
    const double rise = part.high.value - part.low.value;
    const double share = part.low.share - (part.high.share - part.low.share) * part.low.value / rise;
    const Place& at = part.low;
    const curves::SurfaceEnd* const end = occluder_.sheets->mesh().end;
    if (end != nullptr && !end->holds(at.point, at.gradient)) return;
    const glm::dvec3 sight = occluder_.eye.w == 0.0 ? glm::dvec3(occluder_.eye) : at.point - glm::dvec3(occluder_.eye);
    const bool faces_away = glm::dot(at.gradient, sight) > 0.0;
    found.push_back({part.piece, share, item_, faces_away != part.low.negative() ? -1 : 1});
}

// A cubic stays this near to its chord.
bool Search::near_region(const PiercedPart& part) const noexcept {
    geometry::Bounds box;
    box.extend(part.low.point);
    box.extend(part.high.point);
    box = box.grown(0.5 * glm::distance(part.low.point, part.high.point));
    return glm::all(glm::lessThanEqual(box.min, region_.max)) && glm::all(glm::lessThanEqual(region_.min, box.max));
}

void Search::judge(const PiercedPart& part, base::Array<Pierced>& found) {
    const Place& a = part.low;
    const Place& b = part.high;
    if (!a.inside && !b.inside && (part.depth >= deepest_outside || !near_region(part))) return;
    const double length = b.share - a.share;
    const bool last = part.depth >= deepest_piece || length <= known_piercing;
    if (a.inside && b.inside) {
        if (a.negative() != b.negative() && last) return add(part, found);
        if (a.negative() == b.negative() &&
            (!may_touch(a.value, length * a.slope, b.value, length * b.slope) || stays_near(a, b, length, in_surface_)))
            return;
    }
    if (last) return;
    next_.push_back(part);
    want(part.piece, 0.5 * (a.share + b.share));
}

void Search::run(base::Array<Pierced>& found, const base::Progress& progress) {
    start(progress);
    for (const PiercedPart& part : parts_) judge(part, found);
    while (!next_.empty()) {
        progress.check();
        evaluate(progress);
        std::swap(parts_, next_);
        next_.clear();
        for (std::int64_t i = 0; i < parts_.size(); ++i) {
            const PiercedPart& part = parts_[i];
            judge({part.piece, part.depth + 1, part.low, sample_[i]}, found);
            judge({part.piece, part.depth + 1, sample_[i], part.high}, found);
        }
    }
}

} // namespace

base::Array<Pierced> find_pierced(const base::Runtime& runtime, std::span<const Subject> subjects,
                                  std::span<const Occluder> occluders, const ImageLines& lines,
                                  const base::Progress& progress) {
    base::Array<Pierced> found(runtime.memory);
    for (std::size_t o = 0; o < occluders.size() && occluders.size() > 1; ++o)
        Search(runtime, subjects, lines, occluders[o], static_cast<std::int32_t>(o)).run(found, progress);
    std::sort(found.begin(), found.end(), [](const Pierced& a, const Pierced& b) {
        if (a.piece != b.piece) return a.piece < b.piece;
        return a.share != b.share ? a.share < b.share : a.item < b.item;
    });
    return found;
}

} // namespace hrbfnpr::visibility

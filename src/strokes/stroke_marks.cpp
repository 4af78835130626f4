// SPDX-License-Identifier: MIT
#include "strokes/stroke_marks.h"

#include "marks/assemble.h"
#include "marks/crease_ends.h"
#include "strokes/stroke_field.h"
#include "surface/curvature.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes {
namespace {

// The exact direction at a mark is taken where curvature is this sure of it ...
constexpr double unsure_direction = 0.02;
constexpr double sure_direction = 0.10;
// ... and where it is that of the stroke, within angles of these cosines (10 and 20 degrees).
constexpr double same = 0.985;
constexpr double other = 0.94;
// Neighbours on a stroke that are farther apart than this, in steps, or nearer, do not belong together.
constexpr double widest_step = 1.25;
constexpr double narrowest_step = 0.75;
constexpr std::int64_t fewest_marks = 3;
constexpr std::int64_t marks_a_look = 8192;
// Strokes end in this part of their width, and have it in full this many separations away from the end.
constexpr double tip_width = 0.3;
constexpr double taper = 2.0;

class Settling {
public:
    Settling(const marks::Site& site, const base::Array<OrderedStroke>& strokes, const StrokeMarkSettings& settings,
             marks::Marks& marks, marks::LayerReport& report)
        : site_(site), strokes_(strokes), settings_(settings), marks_(marks), report_(report), position_(site.memory()),
          normal_(site.memory()), placed_(site.memory()), ends_(site.memory()), curvature_(site.memory()),
          given_(site.memory()) {}

    void project(const base::Progress& progress);
    void append(const base::Progress& progress);
    void direct(const base::Progress& progress);
    void rank();

private:
    struct Piece {
        std::int64_t begin = 0, count = 0;
    };

    void settle(marks::Settler& settler, std::uint8_t pass, const base::Progress& progress);
    [[nodiscard]] Piece longest_piece(std::int64_t begin, std::int64_t count) const noexcept;
    [[nodiscard]] bool joined(std::int64_t i) const noexcept;
    void append(const OrderedStroke& stroke, std::uint32_t number, std::int64_t first, const Piece& piece);
    [[nodiscard]] glm::dvec3 exact(std::int64_t i, const glm::dvec3& along, double& weight) const noexcept;

    const marks::Site& site_;
    const base::Array<OrderedStroke>& strokes_;
    const StrokeMarkSettings& settings_;
    marks::Marks& marks_;
    marks::LayerReport& report_;
    geometry::VecArray position_, normal_; // of all points, in order
    base::Array<std::uint8_t> placed_;
    base::Array<std::uint8_t> ends_;            // of marks/crease_ends.h
    base::Array<surface::Curvature> curvature_; // at the marks
    geometry::VecArray given_;                  // ... the caller's directions
    std::uint32_t settled_ = 0;                 // strokes
};

void Settling::settle(marks::Settler& settler, std::uint8_t pass, const base::Progress& progress) {
    marks::LevelReport& level = report_.of(pass);
    settler.settle(settings_.separation, level, progress);
    for (std::int64_t i = 0; i < settler.start.size(); ++i) {
        if (settler.placed(i) && !settings_.region.contains(settler.position(i)))
            settler.drop(i, level.dropped_strayed, level);
        position_.push_back(settler.position(i));
        normal_.push_back(settler.placed(i) ? settler.normal(i) : glm::dvec3(0.0));
        placed_.push_back(settler.placed(i) ? 1 : 0);
    }
    settler.start.clear();
}

// Strokes come pass by pass, so that a batch counts in one level's report.
void Settling::project(const base::Progress& progress) {
    marks::Settler settler(site_);
    std::int64_t points = 0;
    for (const OrderedStroke& stroke : strokes_) points += stroke.count;
    position_.reserve(points); // columns that grew would all be copied at the same point
    normal_.reserve(points);
    placed_.reserve(points);
    for (std::int64_t s = 0; s < strokes_.size(); ++s) {
        progress.check();
        const OrderedStroke& stroke = strokes_[s];
        for (std::int64_t i = 0; i < stroke.count; ++i)
            settler.start.push_back(stroke.point[i * stroke.every].position);
        const bool last = s + 1 == strokes_.size();
        if (!last && settler.start.size() < marks::chunk_size && strokes_[s + 1].pass == stroke.pass) continue;
        settle(settler, stroke.pass, base::Progress(progress).part(0.0, 0.0));
        progress.update(static_cast<double>(s + 1) / static_cast<double>(strokes_.size()));
    }
    ends_ = marks::find_crease_ends(site_, position_, normal_, widest_step * settings_.step, progress);
}

// Whether point i goes on where point i - 1 ended.
bool Settling::joined(std::int64_t i) const noexcept {
    if (placed_[i - 1] == 0 || (!ends_.empty() && ends_[i] != 0)) return false;
    const double distance = glm::distance(position_[i], position_[i - 1]) / settings_.step;
    return distance > narrowest_step && distance < widest_step && glm::dot(normal_[i], normal_[i - 1]) > 0.0;
}

Settling::Piece Settling::longest_piece(std::int64_t begin, std::int64_t count) const noexcept {
    Piece longest;
    Piece piece;
    for (std::int64_t i = begin; i < begin + count; ++i) {
        if (placed_[i] == 0)
            piece.count = 0;
        else if (piece.count > 0 && joined(i))
            ++piece.count;
        else
            piece = {i, 1};
        if (piece.count > longest.count) longest = piece;
    }
    return longest;
}

void Settling::append(const base::Progress& progress) {
    const std::int64_t most = marks_.count() + position_.size();
    for (geometry::VecArray* column : {&marks_.position, &marks_.normal, &marks_.direction}) column->reserve(most);
    marks_.key.reserve(most);
    marks_.stroke.reserve(most);
    marks_.place.reserve(most);
    marks_.level.reserve(most);
    marks_.width.reserve(most);
    std::int64_t first = 0;
    for (const OrderedStroke& stroke : strokes_) {
        progress.check();
        Piece piece = longest_piece(first, stroke.count);
        if (piece.count < fewest_marks) piece.count = 0;
        std::int64_t landed = 0;
        for (std::int64_t i = first; i < first + stroke.count; ++i) landed += placed_[i];
        marks::LevelReport& level = report_.of(stroke.pass);
        level.placed -= landed - piece.count;
        level.dropped_strayed += landed - piece.count;
        if (piece.count > 0) append(stroke, settled_++, first, piece);
        first += stroke.count;
    }
}

void Settling::append(const OrderedStroke& stroke, std::uint32_t number, std::int64_t first, const Piece& piece) {
    const bool whole = piece.count == stroke.count;
    const std::array<bool, 2> has_tip{!(whole && (stroke.closed || stroke.goes_on_before)),
                                      !(whole && (stroke.closed || stroke.goes_on_after))};
    const double length = std::max(
        1.0, std::min(taper * settings_.separation / settings_.step, 0.5 * static_cast<double>(piece.count - 1)));
    for (std::int64_t place = 0; place < piece.count; ++place) {
        const std::int64_t i = piece.begin + place;
        // Beyond an end that goes on, or the joint of a closed one, there are no tips.
        const double before = has_tip[0] ? static_cast<double>(place) : length;
        const double after = has_tip[1] ? static_cast<double>(piece.count - 1 - place) : length;
        const double rise = glm::smoothstep(0.0, length, std::min(before, after));
        marks_.position.push_back(position_[i]);
        marks_.normal.push_back(normal_[i]);
        marks_.direction.push_back(stroke.point[(i - first) * stroke.every].direction);
        marks_.key.push_back(static_cast<std::uint64_t>(marks_.count() - 1));
        marks_.stroke.push_back(2 * number + stroke.set);
        marks_.place.push_back(static_cast<std::int32_t>(place));
        marks_.level.push_back(stroke.pass);
        marks_.width.push_back(static_cast<float>(tip_width + (1.0 - tip_width) * rise));
    }
}

// The direction that was asked for at the mark itself, and how much of it to take.
glm::dvec3 Settling::exact(std::int64_t i, const glm::dvec3& along, double& weight) const noexcept {
    glm::dvec3 first, second;
    if (settings_.kind == marks::Kind::principal) {
        const surface::Curvature& c = curvature_[i];
        first = c.d1;
        second = c.d2;
        weight = glm::smoothstep(unsure_direction, sure_direction, c.confidence);
    } else if (settings_.kind == marks::Kind::field) {
        first = given_[i];
        second = glm::cross(marks_.normal[i], first);
        weight = 1.0; // of none the cosine is 0
    } else {
        const Combing combing = combing_at(marks_.normal[i]);
        first = combing.r;
        second = combing.u;
        weight = 1.0;
    }
    const double one = glm::dot(first, along);
    const double two = glm::dot(second, along);
    const double cosine = std::max(std::abs(one), std::abs(two));
    weight *= glm::smoothstep(other, same, cosine);
    if (std::abs(one) >= std::abs(two)) return one < 0.0 ? -first : first;
    return two < 0.0 ? -second : second;
}

// Strokes follow the smoothed field; what a mark says of its direction is exact where there is something exact
// to say.
void Settling::direct(const base::Progress& progress) {
    if (settings_.kind == marks::Kind::field)
        marks::directions_at(site_, settings_.direction, marks_.position, marks_.normal, given_, progress);
    if (settings_.kind == marks::Kind::principal) {
        surface::principal_curvatures(site_.runtime, site_.implicit, marks_.position, curvature_, progress);
        progress.check();
        marks_.curvature.reserve(curvature_.size());
        for (std::int64_t i = 0; i < curvature_.size(); ++i) {
            if (i % marks_a_look == 0) progress.check();
            const surface::Curvature& c = curvature_[i];
            marks_.curvature.push_back(
                {marks::held_curvature(c.k1), marks::held_curvature(c.k2), static_cast<float>(c.confidence)});
        }
    }
    for (std::int64_t i = 0; i < marks_.count(); ++i) {
        if (i % marks_a_look == 0) progress.check();
        const glm::dvec3 n = marks_.normal[i];
        const glm::dvec3 traced = marks_.direction[i];
        const glm::dvec3 along = glm::normalize(traced - glm::dot(traced, n) * n);
        double weight = 0.0;
        const glm::dvec3 best = exact(i, along, weight);
        glm::dvec3 d = weight * best + (1.0 - weight) * along;
        d -= glm::dot(d, n) * n;
        marks_.direction.set(i, glm::normalize(d));
    }
}

// A share of the ranks is the same share of each set's ink.
void Settling::rank() {
    std::array<std::int64_t, 2> all{};
    for (const std::uint32_t stroke : marks_.stroke) ++all[stroke & 1U];
    std::array<std::int64_t, 2> before{};
    marks_.rank.resize(marks_.count());
    for (std::int64_t begin = 0; begin < marks_.count();) {
        std::int64_t end = begin;
        while (end < marks_.count() && marks_.stroke[end] == marks_.stroke[begin]) ++end;
        const std::size_t set = marks_.stroke[begin] & 1U;
        const double middle = static_cast<double>(before[set]) + 0.5 * static_cast<double>(end - begin);
        const float rank = marks::rank_of(1.0 - middle / static_cast<double>(all[set]));
        for (std::int64_t i = begin; i < end; ++i) marks_.rank[i] = rank;
        before[set] += end - begin;
        begin = end;
    }
}

} // namespace

void settle_strokes(const marks::Site& site, const base::Array<OrderedStroke>& strokes,
                    const StrokeMarkSettings& settings, marks::Marks& marks, marks::LayerReport& report,
                    const base::Progress& progress) {
    Settling settling(site, strokes, settings, marks, report);
    settling.project(progress.part(0.0, 0.6));
    settling.append(progress.part(0.6, 0.6));
    settling.direct(progress.part(0.6, 1.0));
    settling.rank();
}

} // namespace hrbfnpr::strokes

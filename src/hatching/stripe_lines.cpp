// SPDX-License-Identifier: MIT
#include "hatching/stripe_lines.h"

#include "geometry/long_vec_array.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace hrbfnpr::hatching {
namespace {

constexpr double tau = 2.0 * std::numbers::pi;
// Where samples agree less about the phase there is none.
constexpr double least_agreement = 0.12;
// A piece of a line runs along the field, within an angle of this cosine: others turn back beside a fork.
constexpr double least_stripe_cosine = 0.55;
constexpr std::int64_t triangles_a_task = 4096;
constexpr std::int64_t at_once = 262144; // numbers without a look for a cancel

double wrapped(double angle) noexcept { return angle - tau * std::round(angle / tau); }

// A line over an edge, from corner a to b.
struct Crossing {
    double share;      // of the way
    std::int32_t a, b; // vertices
    bool rises;        // the phase, in the sense of a's line
    std::uint8_t level;
};

class Stripes {
public:
    Stripes(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const StripeVertices& vertices,
            double period, int halvings)
        : runtime_(runtime), mesh_(mesh), vertices_(vertices), period_(period), parts_(std::int64_t{1} << halvings),
          halvings_(halvings), first_(runtime.memory), crossing_(runtime.memory), link_(runtime.memory) {}

    void cross_edges(const base::Progress& progress);
    void link_triangles(const base::Progress& progress);
    [[nodiscard]] StripeLines walk(const base::Progress& progress) const;

private:
    [[nodiscard]] std::int64_t finest() const noexcept { return vertices_.wave.size() - 1; }
    [[nodiscard]] double period_of(std::int64_t level) const noexcept {
        return std::ldexp(period_, static_cast<int>(finest() - level));
    }
    [[nodiscard]] std::int32_t corner(std::int64_t edge) const noexcept { return mesh_.corner[edge]; }
    [[nodiscard]] std::int32_t end_of(std::int64_t edge) const noexcept {
        return mesh_.corner[edge - edge % 3 + (edge % 3 + 1) % 3];
    }
    // An edge stands with the triangle of the lower number.
    [[nodiscard]] bool owns(std::int64_t edge) const noexcept {
        const std::int32_t other = mesh_.neighbour[edge];
        return other < 0 || edge / 3 < other;
    }
    // The same edge as the triangle across has it.
    [[nodiscard]] std::int64_t across(std::int64_t edge) const noexcept {
        const std::int64_t other = 3 * std::int64_t{mesh_.neighbour[edge]};
        for (std::int64_t k = 0; k < 3; ++k)
            if (corner(other + k) == end_of(edge) && end_of(other + k) == corner(edge)) return other + k;
        return -1;
    }
    // Calls visit(crossing, number of its line along the wave); levels are still 0.
    template <class Visit>
    void visit_crossings(std::int64_t edge, Visit&& visit) const;
    [[nodiscard]] std::uint8_t level_of(const Crossing& c, std::int64_t number) const noexcept;
    void link_triangle(std::int64_t triangle, base::Array<std::int64_t>& around);
    [[nodiscard]] bool runs_along(std::int64_t c, std::int64_t d) const noexcept;
    [[nodiscard]] glm::dvec3 place(const Crossing& c) const noexcept {
        return mesh_.position[c.a] + c.share * (mesh_.position[c.b] - mesh_.position[c.a]);
    }
    [[nodiscard]] glm::dvec3 normal(const Crossing& c) const noexcept {
        const glm::dvec3 sum =
            glm::mix(glm::normalize(mesh_.gradient[c.a]), glm::normalize(mesh_.gradient[c.b]), c.share);
        return glm::normalize(sum);
    }
    void add_line(std::int64_t from, base::Array<std::uint8_t>& taken, StripeLines& lines,
                  const base::Progress& progress) const;

    const base::Runtime& runtime_;
    const curves::SurfaceMesh& mesh_;
    const StripeVertices& vertices_;
    double period_; // of the finest wave
    std::int64_t parts_;
    int halvings_;
    base::Array<std::int64_t> first_; // of each edge's crossings, with the triangle that owns it
    base::Array<Crossing> crossing_;
    base::Array<std::int64_t> link_; // two of each crossing: in the owner's triangle, and across; -1: none
};

// A wave halved r times less than the finest one has every 2^r-th line.
std::uint8_t Stripes::level_of(const Crossing& c, std::int64_t number) const noexcept {
    const std::int64_t place = ((number % parts_) + parts_) % parts_;
    if (place != 0)
        return static_cast<std::uint8_t>(finest() + halvings_ - std::countr_zero(static_cast<std::uint64_t>(place)));
    const bool turned = vertices_.turned(c.a, c.b);
    for (std::int64_t level = finest() - 1; level >= 0; --level) {
        const double growth = vertices_.growth(c.a, c.b, turned, period_of(level));
        const Complex at_b = seen(vertices_.wave[level][c.b], turned);
        const Complex from_a = product(vertices_.wave[level][c.a], std::polar(1.0 - c.share, c.share * growth));
        const Complex from_b = product(at_b, std::polar(c.share, (c.share - 1.0) * growth));
        if (std::real(from_a + from_b) < 0.0) return static_cast<std::uint8_t>(level + 1);
    }
    return 0;
}

template <class Visit>
void Stripes::visit_crossings(std::int64_t edge, Visit&& visit) const {
    const std::int32_t a = corner(edge);
    const std::int32_t b = end_of(edge);
    const Complex at_a = vertices_.wave[finest()][a];
    const Complex at_b = vertices_.wave[finest()][b];
    if (!(std::min(quick_size(at_a), quick_size(at_b)) > least_agreement)) return;
    const bool turned = vertices_.turned(a, b);
    const double growth = vertices_.growth(a, b, turned, period_);
    const double begin = std::arg(at_a);
    const double change = growth + wrapped(std::arg(seen(at_b, turned)) - begin - growth);
    const double scale = static_cast<double>(parts_) / tau;
    const double low = scale * std::min(begin, begin + change);
    const double high = scale * std::max(begin, begin + change);
    for (double k = std::floor(low) + 1.0; k <= high; k += 1.0) {
        const double share = std::clamp((k / scale - begin) / change, 0.0, 1.0);
        visit(Crossing{share, a, b, change > 0.0, 0}, static_cast<std::int64_t>(k));
    }
}

void Stripes::cross_edges(const base::Progress& progress) {
    const std::int64_t edges = 3 * mesh_.triangles();
    base::resize_long(first_, edges + 1, progress);
    runtime_.parallel.for_chunks(edges, triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t edge = begin; edge < end; ++edge)
            if (owns(edge)) visit_crossings(edge, [&](const Crossing&, std::int64_t) { ++first_[edge + 1]; });
    });
    progress.check();
    for (std::int64_t edge = 0; edge < edges; ++edge) {
        if (edge % at_once == 0) progress.check();
        first_[edge + 1] += first_[edge];
    }
    crossing_.resize_for_overwrite(first_[edges]);
    base::resize_long(link_, 2 * first_[edges], progress);
    for (std::int64_t at = 0; at < link_.size(); ++at) {
        if (at % at_once == 0) progress.check();
        link_[at] = -1;
    }
    runtime_.parallel.for_chunks(edges, triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t edge = begin; edge < end; ++edge) {
            std::int64_t at = first_[edge];
            if (owns(edge))
                visit_crossings(edge, [&](const Crossing& c, std::int64_t number) {
                    crossing_[at] = c;
                    crossing_[at++].level = level_of(c, number);
                });
            // From corner a on: along an edge on which the phase falls they come the other way.
            if (at - first_[edge] > 1 && !crossing_[first_[edge]].rises)
                std::reverse(crossing_.data() + first_[edge], crossing_.data() + at);
        }
    });
}

bool Stripes::runs_along(std::int64_t c, std::int64_t d) const noexcept {
    const Crossing& from = crossing_[c];
    const Crossing& to = crossing_[d];
    const glm::dvec3 way = place(to) - place(from);
    const double length = glm::length(way);
    if (!(length > 0.0)) return true;
    glm::dvec3 along = vertices_.along[from.a];
    for (const std::int32_t v : {from.b, to.a, to.b})
        along += (glm::dot(along, vertices_.along[v]) < 0.0 ? -1.0 : 1.0) * vertices_.along[v];
    return std::abs(glm::dot(way, along)) >= least_stripe_cosine * length * glm::length(along);
}

// Around a triangle a line that comes in goes out where the phase comes back: neighbours of opposite sense belong to
// one line, and what lies between them is done.  What is left over ends here, at a fork.
void Stripes::link_triangle(std::int64_t triangle, base::Array<std::int64_t>& around) {
    const std::int32_t* const v = mesh_.corner.data() + 3 * triangle;
    const bool first = vertices_.turned(v[0], v[1]);
    const bool second = vertices_.turned(v[1], v[2]);
    if ((first != second) != vertices_.turned(v[0], v[2])) return; // no line field has a sign around here
    around.clear();                                                // 2 crossing + 1 where it rises
    const auto add = [&](std::int64_t crossing, bool backwards) {
        const Crossing& c = crossing_[crossing];
        const bool turned = c.a == v[0] ? false : c.a == v[1] ? first : vertices_.turned(v[0], v[2]);
        const std::int64_t entry = 2 * crossing + ((c.rises != turned) != backwards ? 1 : 0);
        if (!around.empty() && around.back() % 2 != entry % 2) {
            const std::int64_t other = around.back() / 2;
            around.resize(around.size() - 1);
            if (!runs_along(other, crossing)) return;
            const auto side = [&](std::int64_t of) {
                const std::int64_t edge = std::upper_bound(first_.begin(), first_.end(), of) - first_.begin() - 1;
                return edge / 3 == triangle ? 0 : 1;
            };
            link_[2 * other + side(other)] = crossing;
            link_[2 * crossing + side(crossing)] = other;
            return;
        }
        around.push_back(entry);
    };
    for (std::int64_t edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
        if (owns(edge)) {
            for (std::int64_t c = first_[edge]; c < first_[edge + 1]; ++c) add(c, false);
        } else if (const std::int64_t other = across(edge); other >= 0) {
            for (std::int64_t c = first_[other + 1] - 1; c >= first_[other]; --c) add(c, true);
        }
    }
}

void Stripes::link_triangles(const base::Progress& progress) {
    runtime_.parallel.for_chunks(mesh_.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Array<std::int64_t> around(runtime_.memory);
        for (std::int64_t t = begin; t < end; ++t) link_triangle(t, around);
    });
}

void Stripes::add_line(std::int64_t from, base::Array<std::uint8_t>& taken, StripeLines& lines,
                       const base::Progress& progress) const {
    std::int64_t last = -1;
    std::int64_t at = from;
    bool closed = false;
    for (std::int64_t count = 0;; ++count) {
        if (count % triangles_a_task == 0) progress.check();
        taken[at] = 1;
        geometry::push_back_long(lines.position, place(crossing_[at]), progress);
        geometry::push_back_long(lines.normal, normal(crossing_[at]), progress);
        base::push_back_long(lines.level, crossing_[at].level, progress);
        std::int64_t next = link_[2 * at] != last ? link_[2 * at] : link_[2 * at + 1];
        if (last < 0 && next < 0) next = link_[2 * at + 1];
        closed = next == from;
        if (next < 0 || taken[next] != 0) break;
        last = at;
        at = next;
    }
    lines.first.push_back(lines.position.size());
    lines.closed.push_back(closed ? 1 : 0);
}

StripeLines Stripes::walk(const base::Progress& progress) const {
    StripeLines lines(runtime_.memory);
    base::Array<std::uint8_t> taken(runtime_.memory, crossing_.size());
    for (const bool ends : {true, false})
        for (std::int64_t c = 0; c < crossing_.size(); ++c) {
            if (c % triangles_a_task == 0) progress.check();
            const bool is_end = link_[2 * c] < 0 || link_[2 * c + 1] < 0;
            const bool alone = link_[2 * c] < 0 && link_[2 * c + 1] < 0;
            if (taken[c] == 0 && !alone && (is_end || !ends)) add_line(c, taken, lines, progress);
        }
    return lines;
}

} // namespace

StripeLines find_stripes(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const StripeVertices& vertices,
                         double period, int halvings, const base::Progress& progress) {
    Stripes stripes(runtime, mesh, vertices, period, halvings);
    stripes.cross_edges(progress);
    stripes.link_triangles(progress);
    return stripes.walk(progress);
}

} // namespace hrbfnpr::hatching

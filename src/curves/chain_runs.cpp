// SPDX-License-Identifier: MIT
#include "curves/chain_runs.h"

#include "curves/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// In sides of the mesh: so far may a crossing be off its curve; points that are
// nearer to each other are one, but where the curve turns; runs that are nearer
// are the same curve.
constexpr double reach = 1.0;
constexpr double least_run = 0.1;
constexpr double on_curve = 0.02;
// In longest steps: between the crossings of a chain that are chosen; and a gap
// that is wider is none of one curve.
constexpr double chosen_apart = 0.65;
constexpr double widest = 3.0;
// In turns: between points of the view before that are kept.
constexpr double kept_turn = 0.8;
// In turns: between a piece's chord and its ends.  Half of one in an arc.
constexpr double off_chord = 0.75;
// Halvings of a gap, down to a kink.
constexpr int run_rounds = 10;

glm::dvec3 unit_direction(const CurvePoint& p) noexcept { return glm::normalize(p.direction()); }

// What is known of the curve from a point of a chain to the next.
enum class Link : std::uint8_t { unknown, linked, parted };

// Points in the order of their chains.
struct Sequences {
    explicit Sequences(base::Memory& memory) : first(memory), point(memory), link(memory) { first.push_back(0); }
    [[nodiscard]] std::int64_t size_of(std::int64_t chain) const noexcept { return first[chain + 1] - first[chain]; }
    void reserve(std::int64_t points) {
        point.reserve(points);
        link.reserve(points);
    }
    void add(const CurvePoint& p, Link to_next) {
        point.push_back(p);
        link.push_back(to_next);
    }
    void drop_last() {
        point.resize(point.size() - 1);
        link.resize(link.size() - 1);
    }
    void end_chain() { first.push_back(point.size()); }

    base::Array<std::int64_t> first;
    base::Array<CurvePoint> point;
    base::Array<Link> link; // of each point
};

class Linker {
public:
    Linker(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& starts,
           const TraceSettings& settings, TraceReport& report, const base::Progress& progress)
        : runtime_(runtime), level_(level), mesh_(mesh), starts_(starts), settings_(settings), report_(report),
          progress_(progress), sequences_(runtime.memory) {}

    // Starts onto their curves.
    void begin();
    // Puts points into gaps.  Whether there were any.
    bool fill_gaps();
    [[nodiscard]] Curves split() const;

private:
    // Two points of a chain that follow each other.
    struct Gap {
        std::int64_t a, b;
    };

    [[nodiscard]] bool closed(std::int64_t chain) const noexcept { return starts_.closed[chain] != 0; }
    // -1: none.
    [[nodiscard]] std::int64_t next(std::int64_t chain, std::int64_t at) const noexcept {
        if (at + 1 < sequences_.first[chain + 1]) return at + 1;
        return closed(chain) && sequences_.size_of(chain) > 2 ? sequences_.first[chain] : -1;
    }
    [[nodiscard]] base::Array<std::uint8_t> bring(base::Array<CurvePoint>& points, double farthest) const;
    [[nodiscard]] bool linked(const CurvePoint& a, const CurvePoint& b) const noexcept;
    [[nodiscard]] bool is_between(const CurvePoint& m, const CurvePoint& a, const CurvePoint& b) const noexcept;
    [[nodiscard]] bool in_order(const CurvePoint& before, const CurvePoint& p) const noexcept;
    void thin(const CurvePoint& p, std::int64_t first);
    void thin_end(std::int64_t first);
    [[nodiscard]] base::Array<Gap> find_gaps();
    void insert(const base::Array<Gap>& gaps, const base::Array<CurvePoint>& middle,
                const base::Array<std::uint8_t>& found);
    void add_chain(std::int64_t chain, Curves& runs) const;

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceMesh& mesh_;
    const Curves& starts_;
    const TraceSettings& settings_;
    TraceReport& report_;
    const base::Progress& progress_;
    Sequences sequences_;
};

base::Array<std::uint8_t> Linker::bring(base::Array<CurvePoint>& points, double farthest) const {
    base::Array<std::uint8_t> found(runtime_.memory);
    const NewtonSettings newton{settings_.tolerance * mesh_.side, farthest};
    report_.evaluations += bring_to_curve(runtime_, level_, newton, points, found, progress_);
    return found;
}

// Whether the cubic between them is the curve.
bool Linker::linked(const CurvePoint& a, const CurvePoint& b) const noexcept {
    const glm::dvec3 way = b.position - a.position;
    const double length = glm::length(way);
    if (!(length <= settings_.longest * mesh_.side)) return false;
    const double limit = length < curve_tuning.kink_length * mesh_.side ? curve_tuning.sharpest_kink : settings_.turn;
    const glm::dvec3 begin = unit_direction(a);
    const glm::dvec3 end = unit_direction(b);
    return glm::distance(begin, end) <= limit && glm::distance(begin, way / length) <= off_chord * limit &&
           glm::distance(end, way / length) <= off_chord * limit;
}

bool Linker::in_order(const CurvePoint& before, const CurvePoint& p) const noexcept {
    const glm::dvec3 way = p.position - before.position;
    const double length = glm::length(way);
    const glm::dvec3 a = unit_direction(before);
    const glm::dvec3 b = unit_direction(p);
    if (glm::distance(a, b) > settings_.turn) return true; // who knows
    return length > least_run * settings_.longest * mesh_.side && glm::dot(a, way) > 0.0 && glm::dot(b, way) > 0.0;
}

// Newton's steps go along the curve, too: points may have come together, or
// passed each other.
void Linker::thin(const CurvePoint& p, std::int64_t first) {
    const std::int64_t size = sequences_.point.size();
    if (size == first || in_order(sequences_.point[size - 1], p)) sequences_.add(p, Link::unknown);
}

// The same where a closed chain begins again.
void Linker::thin_end(std::int64_t first) {
    while (sequences_.point.size() > first + 1 &&
           !in_order(sequences_.point[sequences_.point.size() - 1], sequences_.point[first]))
        sequences_.drop_last();
}

void Linker::begin() {
    base::Array<CurvePoint> points(runtime_.memory, starts_.point.size());
    std::copy(starts_.point.begin(), starts_.point.end(), points.begin());
    const base::Array<std::uint8_t> found = bring(points, reach * mesh_.side);
    for (std::int64_t c = 0; c < starts_.count(); ++c) {
        const std::int64_t first = sequences_.point.size();
        for (std::int64_t i = starts_.first[c]; i < starts_.first[c + 1]; ++i)
            if (found[i] != 0) thin(points[i], first);
        if (closed(c)) thin_end(first);
        sequences_.end_chain();
    }
}

base::Array<Linker::Gap> Linker::find_gaps() {
    base::Array<Gap> gaps(runtime_.memory);
    for (std::int64_t c = 0; c < starts_.count(); ++c) {
        for (std::int64_t a = sequences_.first[c]; a < sequences_.first[c + 1]; ++a) {
            const std::int64_t b = next(c, a);
            if (b < 0 || sequences_.link[a] != Link::unknown) continue;
            if (linked(sequences_.point[a], sequences_.point[b])) {
                sequences_.link[a] = Link::linked;
                continue;
            }
            const double width = glm::distance(sequences_.point[a].position, sequences_.point[b].position) / mesh_.side;
            if (width <= widest * settings_.longest && width >= curve_tuning.kink_length)
                gaps.push_back({a, b});
            else
                sequences_.link[a] = Link::parted;
        }
    }
    return gaps;
}

bool Linker::is_between(const CurvePoint& m, const CurvePoint& a, const CurvePoint& b) const noexcept {
    const glm::dvec3 way = b.position - a.position;
    return glm::dot(m.position - a.position, way) > 0.0 && glm::dot(b.position - m.position, way) > 0.0 &&
           glm::dot(m.direction(), way) > 0.0;
}

void Linker::insert(const base::Array<Gap>& gaps, const base::Array<CurvePoint>& middle,
                    const base::Array<std::uint8_t>& found) {
    Sequences result(runtime_.memory);
    result.reserve(sequences_.point.size() + gaps.size());
    std::int64_t g = 0;
    for (std::int64_t c = 0; c < starts_.count(); ++c) {
        for (std::int64_t a = sequences_.first[c]; a < sequences_.first[c + 1]; ++a) {
            const bool gap = g < gaps.size() && gaps[g].a == a;
            const bool right =
                gap && found[g] != 0 && is_between(middle[g], sequences_.point[a], sequences_.point[gaps[g].b]);
            result.add(sequences_.point[a], !gap ? sequences_.link[a] : right ? Link::unknown : Link::parted);
            if (right) result.add(middle[g], Link::unknown);
            if (gap) ++g;
        }
        result.end_chain();
    }
    sequences_ = std::move(result);
}

bool Linker::fill_gaps() {
    const base::Array<Gap> gaps = find_gaps();
    if (gaps.empty()) return false;
    base::Array<CurvePoint> middle(runtime_.memory, gaps.size());
    for (std::int64_t g = 0; g < gaps.size(); ++g)
        middle[g].position = CubicPiece(sequences_.point[gaps[g].a], sequences_.point[gaps[g].b]).at(0.5);
    const base::Array<std::uint8_t> found = bring(middle, 0.5 * settings_.longest * mesh_.side);
    insert(gaps, middle, found);
    return true;
}

// Around a closed chain from behind a gap.
void Linker::add_chain(std::int64_t chain, Curves& runs) const {
    const std::int64_t first = sequences_.first[chain];
    const std::int64_t count = sequences_.size_of(chain);
    if (count == 0) return;
    const auto is_linked = [&](std::int64_t at) {
        const std::int64_t b = next(chain, at);
        const Link link = sequences_.link[at];
        return b >= 0 &&
               (link == Link::linked || (link == Link::unknown && linked(sequences_.point[at], sequences_.point[b])));
    };
    std::int64_t begin = 0;
    while (begin < count && is_linked(first + (begin + count - 1) % count)) ++begin;
    const bool whole = begin == count;
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t at = first + (begin + k) % count;
        runs.point.push_back(sequences_.point[at]);
        if (k + 1 < count && is_linked(at)) continue;
        runs.first.push_back(runs.point.size());
        runs.closed.push_back(whole ? 1 : 0);
    }
}

Curves Linker::split() const {
    Curves runs(runtime_.memory);
    runs.first.push_back(0);
    for (std::int64_t c = 0; c < starts_.count(); ++c) add_chain(c, runs);
    return runs;
}

// Two chains may have come to one curve, and ends of runs may overlap: what the
// longer of two runs has is taken out of the other.
Curves without_doubles(const base::Runtime& runtime, const SurfaceMesh& mesh, const Curves& runs, double longest) {
    const double distance = on_curve * mesh.side;
    const NearCurves near(runs, longest, distance);
    base::Array<std::uint8_t> doubled(runtime.memory, runs.point.size());
    const auto is_longer = [&](std::int64_t s, std::int64_t r) {
        return runs.size_of(s) > runs.size_of(r) || (runs.size_of(s) == runs.size_of(r) && s < r);
    };
    runtime.parallel.for_chunks(runs.count(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t r = begin; r < end; ++r)
            for (std::int64_t i = runs.first[r]; i < runs.first[r + 1]; ++i) {
                const std::int64_t s = near.passing(runs.point[i].position, runs.point[i].direction(), distance, r);
                doubled[i] = s >= 0 && is_longer(s, r) ? 1 : 0;
            }
    });
    Curves kept(runtime.memory);
    kept.first.push_back(0);
    const auto end_run = [&](bool closed) {
        if (kept.point.size() == kept.first[kept.count()]) return;
        kept.first.push_back(kept.point.size());
        kept.closed.push_back(closed ? 1 : 0);
    };
    for (std::int64_t r = 0; r < runs.count(); ++r) {
        bool whole = true;
        for (std::int64_t i = runs.first[r]; i < runs.first[r + 1]; ++i) {
            whole = whole && doubled[i] == 0;
            if (doubled[i] == 0)
                kept.point.push_back(runs.point[i]);
            else
                end_run(false);
        }
        end_run(whole && runs.closed[r] != 0);
    }
    return kept;
}

} // namespace

// Of each chain so many crossings that they are a part of a step from each
// other; all of a small loop's.
Curves starts_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const MeshChains& chains,
                 const base::Array<Bead>& beads, const TraceSettings& settings) {
    Curves starts(runtime.memory);
    starts.first.push_back(0);
    const double apart = chosen_apart * settings.longest * mesh.side;
    for (std::int64_t c = 0; c < chains.chains(); ++c) {
        double way = apart;
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            if (i > chains.first[c]) way += glm::distance(beads[i].place, beads[i - 1].place);
            if (way < apart) continue;
            CurvePoint p;
            p.position = beads[i].place;
            starts.point.push_back(p);
            way = 0.0;
        }
        starts.first.push_back(starts.point.size());
        starts.closed.push_back(chains.closed[c]);
    }
    return starts;
}

// As dense as the crossings of chains are chosen, and denser where the curve
// turns.
Curves thinned(const base::Runtime& runtime, const SurfaceMesh& mesh, const Curves& starts,
               const TraceSettings& settings) {
    const double apart = chosen_apart * settings.longest * mesh.side;
    const double turn = kept_turn * settings.turn;
    Curves kept(runtime.memory);
    kept.first.push_back(0);
    for (std::int64_t c = 0; c < starts.count(); ++c) {
        std::int64_t last = starts.first[c];
        for (std::int64_t i = last; i < starts.first[c + 1]; ++i) {
            const bool needed =
                i == last || i + 1 == starts.first[c + 1] ||
                glm::distance(starts.point[i + 1].position, starts.point[last].position) > apart ||
                glm::distance(unit_direction(starts.point[i + 1]), unit_direction(starts.point[last])) > turn;
            if (!needed) continue;
            kept.point.push_back(starts.point[i]);
            last = i;
        }
        kept.first.push_back(kept.point.size());
        kept.closed.push_back(starts.closed[c]);
    }
    return kept;
}

Curves runs_from(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& starts,
                 const TraceSettings& settings, TraceReport& report, const base::Progress& progress) {
    Linker linker(runtime, level, mesh, starts, settings, report, progress);
    linker.begin();
    for (int round = 0; round < run_rounds && linker.fill_gaps(); ++round) progress.check();
    return without_doubles(runtime, mesh, linker.split(), settings.longest * mesh.side);
}

} // namespace hrbfnpr::curves

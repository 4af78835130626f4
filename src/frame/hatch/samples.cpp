// SPDX-License-Identifier: MIT
#include "frame/hatch/samples.h"

#include "base/assert.h"
#include "base/random.h"
#include "base/scratch.h"
#include "frame/hatch/tuning.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Lengths are multiples of 1 / this, in pixels, so that sums are exact: chains have the same samples whatever lies
// before them.
constexpr float length_steps = 1024.0F;

// An unsteady hand: how far a line strays, and how far it runs past the tone that it ends at. Both are smooth noise
// over the numbers of the stroke's marks, so that it stays in its place on the surface from frame to frame. When the
// eye comes nearer, swings of half the length take over, so that swings keep their length in the picture.
class HatchHand {
public:
    HatchHand() noexcept = default;
    // `marks` is the number of marks of a closed stroke, after which the noise repeats; 0: the stroke is open. `step`
    // is the distance from mark to mark, in pixels.
    HatchHand(const LayerStyle& style, std::int64_t stroke, std::int64_t marks, float step) noexcept;

    [[nodiscard]] bool wobbles() const noexcept { return wobble_ > 0.0F; }
    [[nodiscard]] bool overshoots() const noexcept { return overshoot_ > 0.0F; }

    // Pixels to one side, at a place along the stroke.
    [[nodiscard]] float aside(double mark) const noexcept;
    // Pixels that a line goes on beyond its end there.
    [[nodiscard]] float beyond(double mark) const noexcept;

private:
    [[nodiscard]] double noise(double mark, double level, std::size_t which) const noexcept;
    [[nodiscard]] double octave(double mark, int level, std::size_t which) const noexcept;
    [[nodiscard]] double random(std::int64_t knot, int level, std::size_t which) const noexcept;

    float wobble_ = 0.0F, overshoot_ = 0.0F;      // pixels
    double wobble_level_ = 0.0, end_level_ = 0.0; // the length of a swing, as the power of two of a number of marks
    std::uint64_t seed_ = 0, stroke_ = 0;
    std::int64_t around_ = 0; // the marks of a closed stroke; else 0
};

[[nodiscard]] double level_of(float swing, float step) noexcept {
    constexpr double least = -8.0;
    const double marks = static_cast<double>(swing) / static_cast<double>(step);
    return marks > 0.0 ? std::clamp(std::log2(marks), least, 24.0) : least;
}

HatchHand::HatchHand(const LayerStyle& style, std::int64_t stroke, std::int64_t marks, float step) noexcept
    : wobble_(style.hatch_wobble * style.hatch_pen), overshoot_(style.hatch_overshoot),
      wobble_level_(level_of(hatch_tuning.wobble_swing * style.hatch_pen, step)),
      end_level_(level_of(hatch_tuning.end_swing * overshoot_, step)), seed_(style.hatch_seed),
      stroke_(static_cast<std::uint64_t>(stroke)), around_(marks) {}

float HatchHand::aside(double mark) const noexcept {
    return wobble_ * static_cast<float>(noise(mark, wobble_level_, 0));
}

float HatchHand::beyond(double mark) const noexcept {
    return overshoot_ * static_cast<float>(std::clamp(0.5 + noise(mark, end_level_, 1), 0.0, 1.0));
}

// In [-1, 1].
double HatchHand::noise(double mark, double wanted, std::size_t which) const noexcept {
    const double level = std::floor(wanted);
    const double share = wanted - level;
    const auto number = static_cast<int>(level);
    return (1.0 - share) * octave(mark, number, which) + share * octave(mark, number + 1, which);
}

// A uniform cubic B-spline of random numbers.  Round a closed stroke it goes a whole number of times.
double HatchHand::octave(double mark, int level, std::size_t which) const noexcept {
    double between = std::ldexp(1.0, level) / hatch_tuning.knots_of_swing;
    std::int64_t knots = 0;
    if (around_ > 0) {
        const double count = std::max(hatch_tuning.fewest_knots, std::round(static_cast<double>(around_) / between));
        between = static_cast<double>(around_) / count;
        knots = static_cast<std::int64_t>(count);
    }
    const double place = mark / between;
    const double first = std::floor(place);
    const double u = place - first;
    const double v = 1.0 - u;
    const double weights[4] = {v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u};
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
        std::int64_t knot = static_cast<std::int64_t>(first) - 1 + k;
        if (knots > 0) knot = (knot % knots + knots) % knots;
        sum += weights[k] * random(knot, level, which);
    }
    return sum / 6.0;
}

double HatchHand::random(std::int64_t knot, int level, std::size_t which) const noexcept {
    const std::uint64_t index = stroke_ << 32U | static_cast<std::uint32_t>(knot);
    const std::uint64_t seed = seed_ | static_cast<std::uint64_t>(level + 64) << 32U;
    return 2.0 * base::uniform4(seed, index, base::Purpose::hatch_hand)[which] - 1.0;
}

[[nodiscard]] glm::vec2 place_of(const HatchMark& mark) noexcept { return {mark.x, mark.y}; }

// A chain of marks. Lengths and areas of each mark are counted from the first one.
struct Marks {
    std::span<const HatchMark> mark;
    const float* length;
    const float* area;
    const glm::vec2* tangent; // unit length where marks lie evenly

    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(mark.size()); }
    [[nodiscard]] const HatchMark& operator[](std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < size());
        return mark[static_cast<std::size_t>(i)];
    }
};

// A place between mark `mark` and the next one.
struct Place {
    std::int64_t mark;
    float share; // part of the way to the next mark
};

// The point of Hermite's cubic between two marks.
[[nodiscard]] glm::vec2 point_at(const Marks& m, const Place& place) noexcept {
    const std::int64_t i = place.mark;
    const float t = place.share;
    const glm::vec2 a = place_of(m[i]);
    if (t == 0.0F || i + 1 == m.size()) return a;
    const glm::vec2 b = place_of(m[i + 1]);
    const float way = m.length[i + 1] - m.length[i];
    const float u = 1.0F - t;
    if (way < hatch_tuning.shortest_curve) return u * a + t * b;
    return u * u * (1.0F + 2.0F * t) * a + t * t * (3.0F - 2.0F * t) * b +
           t * u * way * (u * m.tangent[i] - t * m.tangent[i + 1]);
}

// The area of the line from the first mark to a place, widths changing evenly from mark to mark.
[[nodiscard]] float area_to(const Marks& m, const Place& place) noexcept {
    const std::int64_t i = place.mark;
    if (place.share == 0.0F) return m.area[i];
    const float way = m.length[i + 1] - m.length[i];
    return m.area[i] + place.share * way * (m[i].width + 0.5F * place.share * (m[i + 1].width - m[i].width));
}

// Moves the place to where the line has that length, which is near.
void seek(const Marks& m, Place& place, float length) noexcept {
    while (place.mark > 0 && m.length[place.mark] > length) --place.mark;
    while (place.mark < m.size() - 2 && m.length[place.mark + 1] < length) ++place.mark;
    const float way = m.length[place.mark + 1] - m.length[place.mark];
    place.share = way > 0.0F ? std::clamp((length - m.length[place.mark]) / way, 0.0F, 1.0F) : 0.0F;
}

// Sets all numbers of a sample but its width: those of the marks on either side, interpolated.
void see_sample(const Marks& m, const Place& place, HatchSample& sample) noexcept {
    constexpr std::size_t numbers = offsetof(HatchSample, unused) / sizeof(float);
    const std::int64_t i = place.mark;
    const HatchMark& a = m[i];
    const HatchMark& b = m[std::min(i + 1, m.size() - 1)];
    const float t = place.share;
    std::array<float, numbers> from, to;
    std::memcpy(from.data(), &a, sizeof(from));
    std::memcpy(to.data(), &b, sizeof(to));
    for (std::size_t k = 0; k < numbers; ++k) from[k] += t * (to[k] - from[k]);
    std::memcpy(&sample, from.data(), sizeof(from));
    const glm::vec2 at = point_at(m, place);
    sample.x = at.x;
    sample.y = at.y;
    sample.overshoot = 0.0F;
    sample.id = t < 0.5F ? a.id : b.id;
    if (a.is_valid() && b.is_valid()) return;
    if (t == 0.0F || t == 1.0F)
        sample.margin = t == 0.0F ? a.margin : b.margin;
    else
        sample.margin.fill(hatch_nowhere);
}

// Where the hand has the line: aside of its course.
void stray(const Marks& m, const HatchHand& hand, const Place& place, double mark, HatchSample& sample) noexcept {
    if (!hand.wobbles()) return;
    const glm::vec2 along =
        glm::mix(m.tangent[place.mark], m.tangent[std::min(place.mark + 1, m.size() - 1)], place.share);
    const float length = glm::length(along);
    if (!(length > 0.0F)) return;
    const float aside = hand.aside(mark) / length;
    sample.x -= aside * along.y;
    sample.y += aside * along.x;
}

// Fills the scratch of `to` for a chain of marks. The tangents are those of a Catmull-Rom curve.
void measure(std::span<const HatchMark> marks, bool ring, HatchSamples& to) {
    const auto count = static_cast<std::int64_t>(marks.size());
    HRBFNPR_ASSERT(count >= 2);
    base::resize_scratch(to.length, count);
    base::resize_scratch(to.area, count);
    base::resize_scratch(to.tangent, count);
    const auto mark = [&](std::int64_t i) -> const HatchMark& { return marks[static_cast<std::size_t>(i)]; };
    to.length[0] = to.area[0] = 0.0F;
    for (std::int64_t i = 1; i < count; ++i) {
        const float way = std::trunc(mark(i).way * length_steps + 0.5F) / length_steps;
        to.length[i] = to.length[i - 1] + way;
        to.area[i] = to.area[i - 1] + 0.5F * way * (mark(i - 1).width + mark(i).width);
    }
    for (std::int64_t i = 0; i < count; ++i) {
        std::int64_t before = i > 0 ? i - 1 : ring ? count - 2 : 0;
        std::int64_t after = i + 1 < count ? i + 1 : ring ? 1 : i;
        if (!mark(before).is_valid()) before = i;
        if (!mark(after).is_valid()) after = i;
        const float way = (before != i ? mark(i).way : 0.0F) + (after != i ? mark(after).way : 0.0F);
        to.tangent[i] = way > 0.0F ? (place_of(mark(after)) - place_of(mark(before))) / way : glm::vec2(0.0F);
    }
}

// Margins up to which a line fades (presence.h). It does not fade at the border of the picture.
constexpr std::array<float, hatch_margins> ramps = {hatch_tuning.tone_ramp, hatch_tuning.level_ramp,
                                                    hatch_tuning.rim_ramp, 0.0F};
static_assert(margin_tone == 0 && margin_level == 1 && margin_rim == 2);

// A bit for each margin of a mark that is below 0, and from `below_ramp` on for each that is below its ramp. Marks
// beside each other mostly have the same, and nothing turns between them.
constexpr unsigned below_ramp = hatch_margins;

[[nodiscard]] std::uint8_t state_of(const HatchMark& mark) noexcept {
    unsigned state = 0;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        state |= static_cast<unsigned>(mark.margin[k] < 0.0F) << k;
        state |= static_cast<unsigned>(mark.margin[k] < ramps[k]) << (below_ramp + k);
    }
    return static_cast<std::uint8_t>(state);
}

// Whether a line hardly goes on at a mark, and there less than at the marks on either side.
[[nodiscard]] bool is_weakest(const Marks& m, std::int64_t i, std::uint8_t state) noexcept {
    if ((unsigned{state} >> below_ramp & ~unsigned{state} & ((1U << hatch_margins) - 1U)) == 0) return false;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        const float own = m[i].margin[k];
        if (own > 0.0F && own < ramps[k] && own <= m[i - 1].margin[k] && own <= m[i + 1].margin[k]) return true;
    }
    return false;
}

// Places between two marks in rising order, and a bit for the margin that is 0 there.
struct Turns {
    struct Turn {
        float at;
        std::uint8_t ends;
    };
    std::array<Turn, 2 * hatch_margins> turn;
    std::size_t count = 0;

    void add(float at, std::uint8_t ends) noexcept {
        std::size_t place = count++;
        for (; place > 0 && turn[place - 1].at > at; --place) turn[place] = turn[place - 1];
        turn[place] = {at, ends};
    }
};

// Where the line's presence turns between mark i and the next one: where a margin changes its sign, and where it begins
// to fade.
[[nodiscard]] Turns turns_after(const Marks& m, std::int64_t i) noexcept {
    Turns turns;
    if (!m[i].is_valid() || !m[i + 1].is_valid()) return turns;
    for (std::size_t k = 0; k < hatch_margins; ++k) {
        const float from = m[i].margin[k];
        const float to = m[i + 1].margin[k];
        for (const float level : {0.0F, ramps[k]}) {
            if ((from < level) == (to < level) || from == level || to == level) continue;
            const float at = std::lerp(m.length[i], m.length[i + 1], (from - level) / (from - to));
            turns.add(at, level == 0.0F ? static_cast<std::uint8_t>(1U << k) : std::uint8_t{0});
            if (ramps[k] == 0.0F) break;
        }
    }
    return turns;
}

// Where the line is sampled, as lengths from the chain's first mark: at even steps, where its presence turns, and where
// it hardly goes on.
void place_samples(const Marks& m, std::int64_t steps, HatchSamples& to) {
    const float whole = m.length[m.size() - 1];
    to.at.clear();
    to.ends.clear();
    std::int64_t next = 0; // the even step that has not been taken
    const auto step_at = [&](std::int64_t k) {
        return k < steps ? whole * (static_cast<float>(k) / static_cast<float>(steps)) : whole;
    };
    const auto put = [&](float length, std::uint8_t ends) {
        if (to.at.empty() || length - to.at.back() > hatch_tuning.least_step) {
            to.at.push_back(length);
            to.ends.push_back(ends);
        } else if (ends != 0) {
            to.at.back() = length; // where it ends it is sampled exactly
            to.ends.back() |= ends;
        }
    };
    std::uint8_t state = state_of(m[0]);
    float next_at = step_at(next);
    const auto put_next = [&] {
        put(next_at, 0);
        next_at = step_at(++next);
    };
    for (std::int64_t i = 0; i + 1 < m.size(); ++i) {
        const std::uint8_t before = std::exchange(state, state_of(m[i + 1]));
        if (before != state) {
            const Turns turns = turns_after(m, i);
            for (std::size_t k = 0; k < turns.count; ++k) {
                while (next <= steps && next_at < turns.turn[k].at - hatch_tuning.least_step) put_next();
                put(turns.turn[k].at, turns.turn[k].ends);
            }
        }
        while (next <= steps && next_at <= m.length[i + 1]) put_next();
        if (i + 2 < m.size() && is_weakest(m, i + 1, state)) put(m.length[i + 1], 0);
    }
    if (to.at.size() > 1 && whole - to.at.back() <= hatch_tuning.least_step) {
        to.at.back() = whole;
    } else if (to.at.back() < whole) {
        put(whole, 0);
    }
    if (to.at.size() < 2) { // a line of no length
        to.at.push_back(whole);
        to.ends.push_back(0);
    }
}

// first_mark: the number along the stroke of the chain's first one.
void sample_chain(const Marks& m, const HatchHand& hand, std::int64_t first_mark, HatchSamples& to) {
    const float whole = m.length[m.size() - 1];
    const auto steps = std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(whole / hatch_tuning.step)), 1);
    place_samples(m, steps, to);
    const base::Array<float>& at = to.at;
    const std::int64_t count = at.size();
    const std::int64_t first = to.sample.size();
    to.sample.resize_for_overwrite(first + count);
    Place place{0, 0.0F};
    Place edge{0, 0.0F}; // where the stretch ends that a sample's width is the mean of
    const float half_step = 0.5F * whole / static_cast<float>(steps);
    float last = 0.0F; // the length up to the last edge, and the area
    float last_area = 0.0F;
    const auto area_at = [&](float length) {
        if (std::abs(length - last) < hatch_tuning.least_step) return last_area;
        seek(m, edge, length);
        last = length;
        return last_area = area_to(m, edge);
    };
    for (std::int64_t i = 0; i < count; ++i) {
        seek(m, place, at[i]);
        HatchSample& sample = to.sample[first + i];
        see_sample(m, place, sample);
        if (to.ends[i] != 0)
            for (std::size_t k = 0; k < hatch_margins; ++k)
                if ((static_cast<unsigned>(to.ends[i]) >> k & 1U) != 0) sample.margin[k] = 0.0F;
        const double mark = static_cast<double>(place.mark + first_mark) + static_cast<double>(place.share);
        stray(m, hand, place, mark, sample);
        if (hand.overshoots()) sample.overshoot = hand.beyond(mark);
        // From one mark to the next a width may change by much, and samples stand elsewhere in the next frame: a width
        // is the mean over a step around its place.
        const float reach = std::min({half_step, at[i], whole - at[i]});
        if (!(reach > 0.0F)) continue; // at the ends it is that of the mark
        const float area = area_at(at[i] - reach);
        sample.width = 0.5F * (area_at(at[i] + reach) - area) / reach;
    }
}

} // namespace

void sample_stroke(const LayerStyle& style, std::int64_t number, const HatchStroke& stroke, HatchSamples& to) {
    const std::span<const HatchMark> marks = stroke.mark.span();
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < marks.size(); begin = end) {
        end = begin + 1;
        while (end < marks.size() && !(marks[end].begins_chain > 0.0F)) ++end;
        if (end - begin < 2) continue; // a mark alone is no line
        const std::span<const HatchMark> own = marks.subspan(begin, end - begin);
        measure(own, stroke.ring, to);
        HatchChain chain;
        chain.first = to.sample.size();
        chain.ring = stroke.ring;
        chain.has_begin = begin == 0 && stroke.has_begin;
        chain.has_end = end == marks.size() && stroke.has_end;
        chain.begins = stroke.begins;
        chain.ends = stroke.ends;
        const float steps = static_cast<float>(own.size() - 1);
        const HatchHand hand(style, number, stroke.closed ? stroke.count : 0, to.length[to.length.size() - 1] / steps);
        sample_chain({own, to.length.data(), to.area.data(), to.tangent.data()}, hand, stroke.first_kept, to);
        chain.count = to.sample.size() - chain.first;
        to.chain.push_back(chain);
    }
}

} // namespace hrbfnpr::frame

// SPDX-License-Identifier: MIT
// Smooth noise along strokes, for an unsteady hand and for lines that break in the lights.
//
// The noise is a function of the mark's index along the stroke, so it stays in place on the surface from frame to
// frame.
#pragma once

#include "frame/scene/style.h"

#include <array>
#include <cstdint>
#include <span>

namespace hrbfnpr::frame {

// The noise of one stroke. It remembers the intervals that it used last, because neighbouring marks are in the same.
class StrokeNoise {
public:
    // What the noise is for. Noises for different purposes are independent.
    enum class For : std::uint8_t { wobble, overshoot, lights };

    // `around`: for a closed stroke, the number of marks after which the noise repeats; else 0.
    StrokeNoise(std::uint32_t seed, std::int64_t stroke, std::int64_t around) noexcept
        : seed_(seed), stroke_(static_cast<std::uint64_t>(stroke)), around_(around) {}

    // Returns noise in [-1, 1] at a position along the stroke, in marks. `wanted` is log2 of the wavelength, in marks.
    // The noise blends two uniform cubic B-splines of random numbers, whose wavelengths are the next powers of two
    // below and above. Around a closed stroke, each spline has a whole number of knots.
    [[nodiscard]] double at(double mark, double wanted, For purpose) noexcept;
    // Returns the noise of one spline. `level` is log2 of its wavelength, in marks.
    [[nodiscard]] double octave(double mark, int level, For purpose) noexcept;

private:
    // One interval of a spline, between two knots.
    struct Interval {
        double first = 0.0;             // the number of the knot at which it begins
        double between = 0.0;           // the distance of knots, in marks; 0 if the interval is not known yet
        std::array<double, 4> number{}; // the random numbers of the four knots around it
        int level = 0;
    };

    [[nodiscard]] Interval interval_at(double mark, int level, For purpose) const noexcept;

    std::uint64_t seed_, stroke_;
    std::int64_t around_;
    // For each purpose: the last intervals of the two splines.
    std::array<std::array<Interval, 2>, 3> last_{};
};

// Returns log2 of a wavelength in marks, within limits. `length` is the wavelength, and `step` the distance between
// marks, both in the same unit.
[[nodiscard]] double noise_level(float length, float step) noexcept;

// The unsteady hand of a stroke: the line wobbles to the side, and continues beyond the end of its tone. As the eye
// comes nearer, noise of half the wavelength replaces the old noise, so that the wavelength in the picture stays about
// the same.
struct HatchHand {
    float wobble, overshoot;        // in pixels
    double wobble_level, end_level; // log2 of the wavelength of the noise, in marks

    // `step` is the distance between marks, in pixels.
    HatchHand(const LayerStyle& style, float step) noexcept;
};

// The lights of a style: the darknesses near hatch_tone_begin, where the coverage of a line varies along it.
class HatchLights {
public:
    explicit HatchLights(const LayerStyle& style) noexcept;

    // Returns whether coverages vary at a darkness.
    [[nodiscard]] bool hold(float darkness) const noexcept {
        return darkness > begin_ - below_ && darkness < begin_ + above_;
    }
    // Changes the coverage at a darkness by the share `share` of the largest possible change, and returns the darkness
    // that has the new coverage. hold(darkness) must be true.
    [[nodiscard]] float changed(float darkness, float share) const noexcept;
    // Returns the largest darkness that a place of this darkness may get.
    [[nodiscard]] float darkest(float darkness) const noexcept;

private:
    // hatch_tone_begin; and the differences to the darknesses with no coverage and with twice the coverage of it
    float begin_, below_, above_;
};

// Varies the darkness of a stroke's consecutive marks in the lights, so that its line ends at another tone than its
// neighbours, and breaks before it ends. The mean coverage stays the same. `first` is the index of the first mark along
// the stroke. `coarsest` is log2 of the wavelength for a line of level 0, in marks; for lines of each further level,
// which are closer together, the wavelength is half as large. So the result does not depend on the view.
void vary_lights(const HatchLights& lights, StrokeNoise& noise, std::int64_t first, int coarsest,
                 std::span<const float> level, std::span<float> darkness) noexcept;

} // namespace hrbfnpr::frame

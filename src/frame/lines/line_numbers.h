// SPDX-License-Identifier: MIT
// Numbers for lines, which a line keeps from one frame to the next: it is known again by where it is on its surface.
#pragma once

#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "visibility/image_lines.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::frame {

class LineNumbers {
public:
    explicit LineNumbers(base::Memory& memory) noexcept
        : last_(memory), next_(memory), number_(memory), origin_(memory) {}

    // Numbers the lines: those that go on from the last call keep their numbers; others get new ones.
    void run(std::span<const visibility::Subject> subjects, std::span<const visibility::Occluder> occluders,
             const visibility::ImageLines& lines);
    // The number of a line, >= 1.
    [[nodiscard]] std::uint32_t number(std::int64_t line) const noexcept { return number_[line]; }
    // The piece of a line that begins where its first piece did when it was new, or beside.
    [[nodiscard]] std::int64_t origin(std::int64_t line) const noexcept { return origin_[line]; }

private:
    // Only lines of the same family, which is their line set, item and subject, may be one line in two frames.
    struct Family {
        const void* set;
        std::int64_t item;
        std::int64_t number; // the number of its subject among the subjects of the item

        friend bool operator==(const Family&, const Family&) = default;
    };
    // A line of the last frame.
    struct Known {
        Family family;
        std::int64_t first, count; // the range of its points in Kept
        std::uint32_t number;
        glm::dvec3 origin;
    };
    // The lines of a frame, as far as the next one needs them.
    struct Kept {
        explicit Kept(base::Memory& memory) noexcept : known(memory), place(memory), direction(memory) {}

        base::Array<Known> known;
        geometry::VecArray place, direction; // the points of the known lines, and the directions there
        std::uint32_t number = 0;            // the last number that was given
    };
    // About how many points of a line of this frame are near a line of the last frame.
    struct Vote {
        std::int64_t line;
        std::int64_t known;
        std::int64_t points;
    };

    [[nodiscard]] base::Array<Vote> count_votes(const base::Array<Family>& families,
                                                std::span<const visibility::Subject> subjects,
                                                const visibility::ImageLines& lines) const;

    // The next one takes its place when it is whole: a frame that fails leaves the last one as it was.
    Kept last_, next_;
    base::Array<std::uint32_t> number_;
    base::Array<std::int64_t> origin_;
};

} // namespace hrbfnpr::frame

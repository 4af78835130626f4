// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "frame/depth_layers/near_marks.cpp"
#include "base/simd.h"

#include "frame/depth_layers/near_marks.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::frame::HWY_NAMESPACE::near_marks_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;

std::int64_t find(const MarksInCells& marks, const MarkInterval* intervals, std::int64_t count, float x, float y,
                  float reach, float place, std::uint32_t* found) {
    const F d;
    const hn::RebindToUnsigned<F> integer;
    const auto lanes = static_cast<std::uint32_t>(hn::Lanes(d));
    const auto own_x = hn::Set(d, x);
    const auto own_y = hn::Set(d, y);
    const auto squared = hn::Set(d, reach * reach);
    const auto last = hn::Set(d, place);
    std::uint32_t* out = found;
    for (std::int64_t i = 0; i < count; ++i) {
        for (std::uint32_t at = intervals[i].begin; at < intervals[i].end; at += lanes) {
            const auto dx = hn::Sub(hn::LoadU(d, marks.x + at), own_x);
            const auto dy = hn::Sub(hn::LoadU(d, marks.y + at), own_y);
            const auto near = hn::Lt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), squared);
            const auto before = hn::Le(hn::LoadU(d, marks.place + at), last);
            const auto valid = hn::FirstN(d, intervals[i].end - at);
            const auto take = hn::And(hn::And(near, before), valid);
            if (hn::AllFalse(d, take)) continue;
            out += hn::CompressStore(hn::Iota(integer, at), hn::RebindMask(integer, take), integer, out);
        }
    }
    return out - found;
}

} // namespace

NearMarks pick() noexcept { return {find}; }

} // namespace hrbfnpr::frame::HWY_NAMESPACE::near_marks_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::frame, NearMarks, near_marks, near_marks_loops::pick)

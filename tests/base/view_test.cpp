// SPDX-License-Identifier: MIT
#include "base/fp_state.h"
#include "base/view.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace hrbfnpr::base::view_test {
namespace {

TEST(View, ReadsEveryScalarAtAnyStrideAndAlignment) {
    std::array<std::byte, 64> bytes{};
    const auto check = [&](auto value, Scalar scalar) {
        for (const std::int64_t stride : {std::int64_t{16}, std::int64_t{19}}) {
            const OutView out{bytes.data() + 1, 2, stride, scalar, 1};
            out.set(0, 0, 1.0);
            out.set(1, 0, static_cast<double>(value));
            const InView in{bytes.data() + 1, 2, stride, scalar, 1};
            EXPECT_EQ(in.get(0, 0), 1.0);
            EXPECT_EQ(in.get(1, 0), static_cast<double>(value));
        }
    };
    check(1.5F, Scalar::float32);
    check(0.1, Scalar::float64);
    check(std::uint8_t{255}, Scalar::uint8);
    check(std::numeric_limits<std::uint32_t>::max(), Scalar::uint32);
}

TEST(View, NegativeStridesGoBackwards) {
    const std::array<float, 6> data{1, 2, 3, 4, 5, 6};
    const InView in{reinterpret_cast<const std::byte*>(data.data() + 3), 2, -12, Scalar::float32, 3};
    EXPECT_EQ(in.get(0, 0), 4.0);
    EXPECT_EQ(in.get(1, 2), 3.0);
}

TEST(View, WritesTouchNothingElse) {
    std::array<std::uint8_t, 5> data{9, 9, 9, 9, 9};
    const OutView out{reinterpret_cast<std::byte*>(data.data()), 2, 3, Scalar::uint8, 1};
    out.set(1, 0, 4.0);
    EXPECT_EQ(data, (std::array<std::uint8_t, 5>{9, 9, 9, 4, 9}));
    EXPECT_FALSE(OutView{});
    EXPECT_TRUE(InView{}.empty());
}

#if defined(__SSE2__)
TEST(FpState, IsSetAndRestored) {
    const unsigned before = _mm_getcsr();
    const unsigned strange = before | 0x8040U | 0x6000U; // flush to zero, round toward zero
    _mm_setcsr(strange);
    {
        const FpGuard guard;
        EXPECT_EQ(_mm_getcsr(), FpGuard::default_state);
    }
    EXPECT_EQ(_mm_getcsr(), strange);
    _mm_setcsr(before);
}
#endif

} // namespace
} // namespace hrbfnpr::base::view_test

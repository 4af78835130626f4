#include "fit/product.h"

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

constexpr std::int64_t grain = 128; // targets of a task: their sums stay in the first-level cache

} // namespace

HermiteProduct::HermiteProduct(const base::Runtime& runtime, const geometry::VecArray& position,
                               const HermiteSystem::Options& options)
    : runtime_(runtime), position_(position), options_(options), alpha_(runtime.memory, position.size()),
      beta_(runtime.memory, position.size()), value_(runtime.memory, position.size()),
      gradient_(runtime.memory, position.size()) {}

implicit::Sources HermiteProduct::sources() const noexcept {
    return {position_.x.data(), position_.y.data(), position_.z.data(), alpha_.data(),
            beta_.x.data(),     beta_.y.data(),     beta_.z.data(),     position_.size()};
}

void HermiteProduct::multiply(const double* x, double* y, const base::Progress& progress) {
    const std::int64_t count = position_.size();
    for (std::int64_t i = 0; i < count; ++i) {
        alpha_[i] = x[4 * i];
        beta_.set(i, {x[4 * i + 1], x[4 * i + 2], x[4 * i + 3]});
    }
    const implicit::AddHermiteSums add = implicit::hermite_sums(runtime_.instruction_set, options_.kernel);
    runtime_.parallel.for_chunks(count, grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        double* const sums[4] = {value_.data(), gradient_.x.data(), gradient_.y.data(), gradient_.z.data()};
        for (double* const sum : sums) std::fill(sum + begin, sum + end, 0.0);
        add(options_.radius, sources(),
            {position_.x.data() + begin, position_.y.data() + begin, position_.z.data() + begin, sums[0] + begin,
             sums[1] + begin, sums[2] + begin, sums[3] + begin, end - begin});
        for (std::int64_t i = begin; i < end; ++i) {
            y[4 * i] = sums[0][i] + options_.value_diagonal * x[4 * i];
            for (int c = 1; c < 4; ++c) y[4 * i + c] = sums[c][i] + options_.gradient_diagonal * x[4 * i + c];
        }
    });
}

std::int64_t HermiteProduct::bytes() const noexcept {
    return alpha_.bytes() + beta_.bytes() + value_.bytes() + gradient_.bytes();
}

} // namespace hrbfnpr::fit

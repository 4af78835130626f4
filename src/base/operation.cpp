// SPDX-License-Identifier: MIT
#include "base/operation.h"

#include "base/status.h"

#include <algorithm>

namespace hrbfnpr::base {

void Operation::begin() {
    if (is_cancelled()) fail(Status::cancelled, "the operation had been cancelled before the call");
    progress_.store(0.0, std::memory_order_relaxed);
    entered_ = std::this_thread::get_id();
}

void Operation::report(double progress) noexcept {
    progress = std::clamp(progress, 0.0, 1.0);
    double before = progress_.load(std::memory_order_relaxed);
    while (progress > before && !progress_.compare_exchange_weak(before, progress, std::memory_order_relaxed)) {
    }
    if (callback_ == nullptr || std::this_thread::get_id() != entered_) return;
    if (callback_(user_, std::max(before, progress)) != 0) cancel();
}

Progress Progress::part(double from, double to) const noexcept {
    Progress part = *this;
    part.from_ = from_ + (to_ - from_) * from;
    part.to_ = from_ + (to_ - from_) * to;
    return part;
}

void Progress::update(double fraction) const {
    if (operation_ == nullptr) return;
    operation_->report(from_ + (to_ - from_) * fraction);
    check();
}

void Progress::check() const {
    if (operation_ != nullptr && operation_->is_cancelled()) fail(Status::cancelled, "the operation was cancelled");
}

} // namespace hrbfnpr::base

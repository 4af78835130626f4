// SPDX-License-Identifier: MIT
#include "base/operation.h"

#include "base/status.h"

#include <algorithm>

namespace hrbfnpr::base {
namespace {

constexpr double longest_silence = 0.02; // longest time without a callback, in seconds

} // namespace

void Operation::begin() {
    if (is_cancelled()) fail(Status::cancelled, "the operation had been cancelled before the call");
    progress_.store(0.0, std::memory_order_relaxed);
    entered_ = std::this_thread::get_id();
    silence_.restart();
}

void Operation::report(double progress) noexcept {
    progress = std::clamp(progress, 0.0, 1.0);
    double before = progress_.load(std::memory_order_relaxed);
    while (progress > before && !progress_.compare_exchange_weak(before, progress, std::memory_order_relaxed)) {
    }
    if (callback_ != nullptr && std::this_thread::get_id() == entered_) call_back(std::max(before, progress));
}

void Operation::call_back_after_silence() noexcept {
    if (callback_ == nullptr || std::this_thread::get_id() != entered_ || is_cancelled()) return;
    if (silence_.seconds() > longest_silence) call_back(progress());
}

void Operation::call_back(double progress) noexcept {
    if (callback_(user_, progress) != 0) cancel();
    silence_.restart();
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

void Progress::throw_if_cancelled() const {
    operation_->call_back_after_silence();
    if (operation_->is_cancelled()) fail(Status::cancelled, "the operation was cancelled");
}

} // namespace hrbfnpr::base

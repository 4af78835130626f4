// SPDX-License-Identifier: MIT
// Progress and cancelling of one long call, and the part of it that a stage sees.
#pragma once

#include "base/clock.h"

#include <atomic>
#include <cstdint>
#include <thread>

namespace hrbfnpr::base {

using ProgressFn = std::int32_t (*)(void* user, double progress);

class Operation {
public:
    // Called by the boundary when a long call enters; throws Error{cancelled} if cancelled before.
    void begin();
    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool is_cancelled() const noexcept {
        return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->is_cancelled());
    }
    [[nodiscard]] double progress() const noexcept { return progress_.load(std::memory_order_relaxed); }
    void set_callback(ProgressFn callback, void* user) noexcept {
        callback_ = callback;
        user_ = user;
    }

    // Makes this a part of another operation: a cancel of that one cancels this one.  Call it before begin(); `whole`
    // outlives this.
    void be_part_of(const Operation* whole) noexcept { whole_ = whole; }

    // From any thread.  Progress never falls; the callback runs only on the thread of begin().
    void report(double progress) noexcept;
    // From any thread.  On that of begin() the callback is called again if it has not been for a while, so that a host
    // hears of a call where its progress stands still, too, and may cancel it there.
    void remind() noexcept;

private:
    void call_back(double progress) noexcept;

    std::atomic<bool> cancelled_{false};
    std::atomic<double> progress_{0.0};
    const Operation* whole_ = nullptr;
    ProgressFn callback_ = nullptr;
    void* user_ = nullptr;
    std::thread::id entered_;
    Stopwatch silence_; // since the callback was last called; of the thread of begin()
};

// A stage's share [from, to] of an operation's progress.  Copied freely; default: nobody watches.
class Progress {
public:
    Progress() noexcept = default;
    explicit Progress(Operation* operation) noexcept : operation_(operation) {}

    [[nodiscard]] bool is_watched() const noexcept { return operation_ != nullptr; }
    // The part of this stage between two fractions of it.
    [[nodiscard]] Progress part(double from, double to) const noexcept;
    // For steps whose share nobody knows: they look for a cancel, and progress stands still.
    [[nodiscard]] Progress standing() const noexcept { return part(0.0, 0.0); }
    // Reports that `fraction` of this stage is done and throws Error{cancelled} after a cancel.
    void update(double fraction) const;
    // Looks for a cancel; reports no progress.
    void check() const;

private:
    Operation* operation_ = nullptr;
    double from_ = 0.0;
    double to_ = 1.0;
};

} // namespace hrbfnpr::base

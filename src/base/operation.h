// SPDX-License-Identifier: MIT
// Progress and cancelling of one long call, and the part of it that a stage sees.
#pragma once

#include "base/clock.h"

#include <algorithm>
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

template <class Number>
class Watched;

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
    void check() const {
        if (operation_ != nullptr) look();
    }
    // The numbers from `begin` to end - 1, for a loop on one thread that looks for a cancel now and then.
    template <class Number>
    [[nodiscard]] Watched<Number> over(Number begin, Number end) const noexcept {
        return {*this, begin, end};
    }
    template <class Number>
    [[nodiscard]] Watched<Number> over(Number end) const noexcept {
        return {*this, Number{0}, end};
    }

private:
    void look() const;

    Operation* operation_ = nullptr;
    double from_ = 0.0;
    double to_ = 1.0;
};

// A range of numbers that looks for a cancel after each `stride` of them. A body that takes 10 us or less is left
// within 10 ms of a cancel; a longer one looks itself.
template <class Number>
class Watched {
public:
    Watched(const Progress& progress, Number begin, Number end) noexcept
        : progress_(progress), begin_(begin), end_(std::max(begin, end)) {}

    class Iterator {
    public:
        Iterator(const Progress& progress, Number i) noexcept : progress_(&progress), i_(i) {}
        Number operator*() const noexcept { return i_; }
        Iterator& operator++() {
            if (++i_ % stride == 0) progress_->check();
            return *this;
        }
        bool operator!=(const Iterator& other) const noexcept { return i_ != other.i_; }

    private:
        const Progress* progress_;
        Number i_;
    };
    [[nodiscard]] Iterator begin() const noexcept { return {progress_, begin_}; }
    [[nodiscard]] Iterator end() const noexcept { return {progress_, end_}; }

private:
    static constexpr Number stride = 1024;

    Progress progress_;
    Number begin_, end_;
};

} // namespace hrbfnpr::base

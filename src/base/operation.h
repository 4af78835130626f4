// SPDX-License-Identifier: MIT
// Progress and cancellation of a long call, and the share of the progress that a stage of the call has.
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
    // The API calls this at the start of each long call. It throws Error{cancelled} if the operation is already
    // cancelled.
    void begin();
    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] bool is_cancelled() const noexcept {
        return cancelled_.load(std::memory_order_relaxed) || (parent_ != nullptr && parent_->is_cancelled());
    }
    [[nodiscard]] double progress() const noexcept { return progress_.load(std::memory_order_relaxed); }
    void set_callback(ProgressFn callback, void* user) noexcept {
        callback_ = callback;
        user_ = user;
    }

    // Makes this operation a part of another: if `parent` is cancelled, so is this operation. Call it before begin().
    // `parent` must outlive this object.
    void set_parent(const Operation* parent) noexcept { parent_ = parent; }

    // Reports progress. Any thread may call this. Progress never decreases. The callback runs only on the thread that
    // called begin().
    void report(double progress) noexcept;
    // Any thread may call this. On the thread that called begin(), it calls the callback if the previous callback was
    // some time ago. So a host can cancel a call even while its progress does not change.
    void call_back_after_silence() noexcept;

private:
    void call_back(double progress) noexcept;

    std::atomic<bool> cancelled_{false};
    std::atomic<double> progress_{0.0};
    const Operation* parent_ = nullptr;
    ProgressFn callback_ = nullptr;
    void* user_ = nullptr;
    std::thread::id entered_;
    Stopwatch silence_; // time since the last callback; used only on the thread that called begin()
};

template <class Number>
class CancellableRange;

// A stage's share [from, to] of an operation's progress. Copies are cheap. A default object has no operation: it
// reports nothing and is never cancelled.
class Progress {
public:
    Progress() noexcept = default;
    explicit Progress(Operation* operation) noexcept : operation_(operation) {}

    [[nodiscard]] bool is_watched() const noexcept { return operation_ != nullptr; }
    // Returns the part of this stage between the fractions `from` and `to`.
    [[nodiscard]] Progress part(double from, double to) const noexcept;
    // Returns a Progress for steps that take an unknown share of the stage. These steps check for cancellation but
    // report no progress.
    [[nodiscard]] Progress without_progress() const noexcept { return part(0.0, 0.0); }
    // Reports that `fraction` of this stage is done. Throws Error{cancelled} if the operation was cancelled.
    void update(double fraction) const;
    // Throws Error{cancelled} if the operation was cancelled. Reports no progress.
    void check() const {
        if (operation_ != nullptr) throw_if_cancelled();
    }
    // Returns the numbers from `begin` to end - 1, for a loop on one thread that repeatedly checks for cancellation.
    template <class Number>
    [[nodiscard]] CancellableRange<Number> over(Number begin, Number end) const noexcept {
        return {*this, begin, end};
    }
    template <class Number>
    [[nodiscard]] CancellableRange<Number> over(Number end) const noexcept {
        return {*this, Number{0}, end};
    }

private:
    void throw_if_cancelled() const;

    Operation* operation_ = nullptr;
    double from_ = 0.0;
    double to_ = 1.0;
};

// A range of numbers that checks for cancellation after every `stride` numbers. A loop whose body takes 10 us or less
// ends within 10 ms of a cancellation. A longer body must check for cancellation itself.
template <class Number>
class CancellableRange {
public:
    CancellableRange(const Progress& progress, Number begin, Number end) noexcept
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

// SPDX-License-Identifier: MIT
// The data that a stage of a call needs: the context's memory, threads, instruction set and log, its share of the
// call's progress, and a check for cancellation.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"

#include <algorithm>
#include <cstdint>

namespace hrbfnpr::base {

// Copies are cheap. The runtime must outlive them.
class Work {
public:
    // Without `progress`, nothing is reported, and the work cannot be cancelled.
    Work(const Runtime& runtime, const Progress& progress = {}) noexcept
        : memory(runtime.memory), instruction_set(runtime.instruction_set), runtime_(&runtime), progress_(progress) {}

    operator const Runtime&() const noexcept { return *runtime_; }
    operator const Progress&() const noexcept { return progress_; }
    [[nodiscard]] const Runtime& runtime() const noexcept { return *runtime_; }
    [[nodiscard]] const Progress& progress() const noexcept { return progress_; }

    // Returns a copy with the part of the progress between the fractions `from` and `to`.
    [[nodiscard]] Work part(double from, double to) const noexcept {
        Work work = *this;
        work.progress_ = progress_.part(from, to);
        return work;
    }
    // Returns a copy that checks for cancellation but reports no progress.
    [[nodiscard]] Work without_progress() const noexcept { return part(0.0, 0.0); }
    [[nodiscard]] int threads() const noexcept { return one_thread_ ? 1 : runtime_->parallel.threads(); }
    void update(double fraction) const { progress_.update(fraction); }
    void check() const { progress_.check(); }
    // Returns the numbers from 0 or `begin` to end - 1, for a loop on one thread that repeatedly checks for
    // cancellation.
    template <class... Numbers>
    [[nodiscard]] auto over(Numbers... numbers) const noexcept {
        return progress_.over(numbers...);
    }

    // Returns a copy that uses only the calling thread, for callbacks of the caller.
    [[nodiscard]] Work on_one_thread() const noexcept {
        Work work = *this;
        work.one_thread_ = true;
        return work;
    }
    // The next two functions work like Parallel::for_each and Parallel::for_chunks, but check for cancellation before
    // each task.
    template <class F>
    void for_each(std::int64_t count, F&& f) const {
        const auto watched = [&](std::int64_t i) {
            progress_.check();
            f(i);
        };
        if (one_thread_)
            Parallel().for_each(count, watched);
        else
            runtime_->parallel.for_each(count, watched);
    }
    template <class F>
    void for_chunks(std::int64_t count, std::int64_t grain, F&& f) const {
        for_each((count + grain - 1) / grain,
                 [&](std::int64_t chunk) { f(chunk * grain, std::min(count, (chunk + 1) * grain)); });
    }

    Memory& memory;
    InstructionSet instruction_set;

private:
    const Runtime* runtime_;
    Progress progress_;
    bool one_thread_ = false;
};

} // namespace hrbfnpr::base

// SPDX-License-Identifier: MIT
// What a stage of a call is given: memory, threads, instruction set and log of the context, and its share of the call's
// progress, with a look for a cancel.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"

#include <algorithm>
#include <cstdint>

namespace hrbfnpr::base {

// Copied freely; the runtime outlives it.
class Work {
public:
    // Without progress nothing is reported, and nothing cancels the work.
    Work(const Runtime& runtime, const Progress& progress = {}) noexcept
        : memory(runtime.memory), instruction_set(runtime.instruction_set), runtime_(&runtime), progress_(progress) {}

    operator const Runtime&() const noexcept { return *runtime_; }
    operator const Progress&() const noexcept { return progress_; }
    [[nodiscard]] const Runtime& runtime() const noexcept { return *runtime_; }
    [[nodiscard]] const Progress& progress() const noexcept { return progress_; }

    // The same work with the share of its progress between two fractions of it.
    [[nodiscard]] Work part(double from, double to) const noexcept {
        Work work = *this;
        work.progress_ = progress_.part(from, to);
        return work;
    }
    // The same work, of which no progress is reported.
    [[nodiscard]] Work standing() const noexcept { return part(0.0, 0.0); }
    [[nodiscard]] int threads() const noexcept { return one_thread_ ? 1 : runtime_->parallel.threads(); }
    void update(double fraction) const { progress_.update(fraction); }
    void check() const { progress_.check(); }
    // The numbers from 0 or `begin` to end - 1, for a loop on one thread that looks for a cancel now and then.
    template <class... Numbers>
    [[nodiscard]] auto over(Numbers... numbers) const noexcept {
        return progress_.over(numbers...);
    }

    // The same work on the calling thread alone, for functions of the caller.
    [[nodiscard]] Work on_one_thread() const noexcept {
        Work work = *this;
        work.one_thread_ = true;
        return work;
    }
    // Parallel::for_each and Parallel::for_chunks with a look for a cancel before each task.
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

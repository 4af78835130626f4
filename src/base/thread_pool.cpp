// SPDX-License-Identifier: MIT
#include "base/thread_pool.h"

#include "base/clock.h"
#include "base/shared_object.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <new>

namespace hrbfnpr::base {
namespace {

// How long a thread waits actively, in nanoseconds. It is long enough for the next step of a frame or solver to start
// without a system call, and short enough to leave the processor to other processes.
constexpr std::int64_t patience_nanoseconds = 20'000;

void relax() noexcept {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ __volatile__("yield");
#endif
}

// Waits actively. Returns true as soon as the condition holds, or false after patience_nanoseconds.
template <class Condition>
bool spin_until(const Condition& condition) noexcept {
    constexpr int looks = 16; // the number of tests of the condition between two readings of the clock
    for (const Stopwatch watch; watch.nanoseconds() < patience_nanoseconds;)
        for (int look = 0; look < looks; ++look) {
            if (condition()) return true;
            relax();
        }
    return condition();
}

} // namespace

// ---- Job -----------------------------------------------------------------------------------

void Job::open(std::int64_t count, TaskFn task, void* context, std::thread::id caller) noexcept {
    // First closes the job by giving it a new number. Then a thread that has read the members below can no longer claim
    // a task under the old number.
    const std::uint64_t number = ((next_.load(std::memory_order_relaxed) >> index_bits) + 1) << index_bits;
    next_.store(number | index_mask, std::memory_order_release);
    count_.store(static_cast<std::uint64_t>(count), std::memory_order_release);
    task_.store(task, std::memory_order_release);
    context_.store(context, std::memory_order_release);
    caller_.store(caller, std::memory_order_relaxed);
    processor_.store(current_processor(), std::memory_order_relaxed);
    left_.store(static_cast<std::uint64_t>(count), std::memory_order_relaxed);
    next_.store(number, std::memory_order_release);
}

bool Job::work() noexcept {
    std::uint64_t done = 0;
    std::uint64_t next = next_.load(std::memory_order_acquire);
    for (;;) {
        const std::uint64_t index = next & index_mask;
        if (index >= count_.load(std::memory_order_acquire)) break;
        const TaskFn task = task_.load(std::memory_order_acquire);
        void* const context = context_.load(std::memory_order_acquire);
        // If this succeeds, the job still has this number, so `task` and `context` belong to it.
        if (!next_.compare_exchange_weak(next, next + 1, std::memory_order_acq_rel, std::memory_order_acquire))
            continue;
        task(context, static_cast<std::int64_t>(index));
        ++done;
        next = next_.load(std::memory_order_acquire);
    }
    if (done == 0) return false;
    // This operation and the one in wait_for_claimed_tasks() are sequentially consistent, so that at least one of the
    // two threads sees the other's change.
    if (left_.fetch_sub(done) == done && awaited_.load()) {
        const std::lock_guard lock(mutex_);
        ended_.notify_all();
    }
    return true;
}

bool Job::run_unclaimed_tasks() noexcept {
    const std::uint64_t index = next_.load(std::memory_order_acquire) & index_mask;
    if (index >= count_.load(std::memory_order_acquire)) return false;
    // If all other processors are busy, the system may wake a worker on the processor of the job's caller, and leave it
    // there for long. There the worker and the caller take turns, and nothing is gained. On another busy processor the
    // worker gets about half of the processor's time.
    const int processor = processor_.load(std::memory_order_relaxed);
    if (processor >= 0 && processor == current_processor()) leave_processor(processor);
    return work();
}

void Job::finish() noexcept {
    work();
    if (!spin_until([this] { return left_.load(std::memory_order_acquire) == 0; })) wait_for_claimed_tasks();
    caller_.store({}, std::memory_order_relaxed);
}

void Job::wait_for_claimed_tasks() noexcept {
    std::unique_lock lock(mutex_);
    awaited_.store(true);
    ended_.wait(lock, [this] { return left_.load() == 0; });
    awaited_.store(false, std::memory_order_relaxed);
}

// ---- Team ----------------------------------------------------------------------------------

Team::Team(int workers) noexcept {
    for (; started_ < workers; ++started_) {
        Worker& worker = worker_[static_cast<std::size_t>(started_)];
        worker.team = this;
        char name[32];
        std::snprintf(name, sizeof name, "hrbfnpr-%d", started_ + 1);
        if (!worker.thread.start(name, main, &worker)) break;
    }
}

Team::~Team() {
    ending_.store(true);
    event_count_.fetch_add(1);
    {
        const std::lock_guard lock(mutex_);
        woken_.notify_all();
    }
    for (int i = 0; i < started_; ++i) worker_[static_cast<std::size_t>(i)].thread.join();
}

bool Team::run(std::int64_t count, TaskFn task, void* context) noexcept {
    const std::thread::id self = std::this_thread::get_id();
    if (started_ == 0 || count > Job::most_tasks || is_running_task(self)) return false;
    const int mine = take_job();
    if (mine < 0) return false;
    Job& job = jobs_[static_cast<std::size_t>(mine)];
    job.open(count, task, context, self);
    wake(count - 1);
    job.finish();
    taken_.fetch_and(~(1U << static_cast<unsigned>(mine)), std::memory_order_release);
    return true;
}

int Team::take_job() noexcept {
    std::uint32_t taken = taken_.load(std::memory_order_relaxed);
    for (;;) {
        const int first = std::countr_one(taken);
        if (first == most_jobs) return -1;
        if (taken_.compare_exchange_weak(taken, taken | (1U << static_cast<unsigned>(first)), std::memory_order_acq_rel,
                                         std::memory_order_relaxed))
            return first;
    }
}

bool Team::is_running_task(std::thread::id self) const noexcept {
    for (std::uint32_t taken = taken_.load(std::memory_order_acquire); taken != 0; taken &= taken - 1)
        if (jobs_[static_cast<std::size_t>(std::countr_zero(taken))].called_by(self)) return true;
    return std::any_of(worker_.begin(), worker_.begin() + started_,
                       [&](const Worker& worker) { return worker.id.load(std::memory_order_relaxed) == self; });
}

void Team::wake(std::int64_t tasks) noexcept {
    // This operation and the one in wait_for_event() are sequentially consistent, so that at least one of the two
    // threads sees the other's change.
    event_count_.fetch_add(1);
    const int asleep = asleep_.load();
    if (asleep == 0) return;
    // After this lock, no worker is between its last test of event_count_ and its sleep.
    { const std::lock_guard lock(mutex_); }
    if (tasks >= asleep) {
        woken_.notify_all();
    } else {
        for (std::int64_t i = 0; i < tasks; ++i) woken_.notify_one();
    }
}

void Team::main(void* worker) noexcept {
    auto& self = *static_cast<Worker*>(worker);
    self.id.store(std::this_thread::get_id(), std::memory_order_relaxed);
    self.team->serve();
}

void Team::serve() noexcept {
    for (;;) {
        // The destructor sets `ending_` before it increments `event_count_`. `event_count_` is read first, so that this
        // thread either sees `ending_` or wakes at once from its wait.
        const std::uint32_t seen = event_count_.load();
        if (ending_.load()) return;
        if (!run_any_job()) wait_for_event(seen);
    }
}

bool Team::run_any_job() noexcept {
    bool worked = false;
    for (std::uint32_t taken = taken_.load(std::memory_order_acquire); taken != 0; taken &= taken - 1)
        worked |= jobs_[static_cast<std::size_t>(std::countr_zero(taken))].run_unclaimed_tasks();
    return worked;
}

void Team::wait_for_event(std::uint32_t seen) noexcept {
    if (spin_until([&] { return event_count_.load(std::memory_order_acquire) != seen; })) return;
    std::unique_lock lock(mutex_);
    asleep_.fetch_add(1);
    woken_.wait(lock, [&] { return event_count_.load() != seen; });
    asleep_.fetch_sub(1);
}

// ---- ThreadPool ----------------------------------------------------------------------------

ThreadPool::ThreadPool(int threads) noexcept
    : threads_(threads), library_(hold_shared_object(reinterpret_cast<const void*>(&relax))) {}

ThreadPool::~ThreadPool() {
    const std::int64_t owner = owner_.load(std::memory_order_acquire);
    if (owner == process_id()) stored_team().~Team();
    if (owner == process_id() || owner == 0) release_shared_object(library_);
}

void ThreadPool::run(std::int64_t count, TaskFn task, void* context) noexcept {
    if (team().run(count, task, context)) return;
    for (std::int64_t i = 0; i < count; ++i) task(context, i);
}

int ThreadPool::workers() const noexcept {
    return owner_.load(std::memory_order_acquire) == process_id() ? stored_team().workers() : 0;
}

Team& ThreadPool::team() noexcept {
    const std::int64_t self = process_id();
    for (std::int64_t owner = owner_.load(std::memory_order_acquire); owner != self;) {
        if (owner == -self) { // another thread of this process is making the team
            std::this_thread::yield();
            owner = owner_.load(std::memory_order_acquire);
        } else if (owner_.compare_exchange_weak(owner, -self, std::memory_order_acquire)) {
            new (team_storage_) Team(threads_ - 1);
            owner_.store(self, std::memory_order_release);
            owner = self;
        }
    }
    return stored_team();
}

} // namespace hrbfnpr::base

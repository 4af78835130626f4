// SPDX-License-Identifier: MIT
// Threads that share the tasks of a job: the built-in backend of base::Parallel.
//
// Every free thread claims the next task; the caller of the job does so, too. When all tasks are claimed, the caller
// waits until those of other threads end. It never waits for a thread that has claimed no task: while a worker waits
// for a processor, the caller runs the tasks.
//
// The first job starts the workers.  A worker without a task looks for another job for 20 microseconds, and then
// sleeps.  Any number of threads may run jobs at the same time. A job that starts within a task of the same pool is run
// by its caller alone.
#pragma once

#include "base/thread.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <new>
#include <thread>

namespace hrbfnpr::base {

using TaskFn = void (*)(void* task_context, std::int64_t index);

// The tasks of one caller. Job objects are reused and not freed. So a worker that comes late may read the data of a
// later job, which is valid memory.
class alignas(64) Job {
public:
    // The caller calls these. open() lets threads claim tasks. finish() runs unclaimed tasks, and waits for those that
    // other threads have claimed.
    void open(std::int64_t count, TaskFn task, void* context, std::thread::id caller) noexcept;
    void finish() noexcept;

    // A worker calls this. It runs tasks until all are claimed. Returns false if it ran no task.
    bool run_unclaimed_tasks() noexcept;

    [[nodiscard]] bool called_by(std::thread::id thread) const noexcept {
        return caller_.load(std::memory_order_relaxed) == thread;
    }

private:
    bool work() noexcept;
    void wait_for_claimed_tasks() noexcept;

    // The lower bits hold the next task to claim, the higher bits the number of the job. So no thread can claim a task
    // of one job with data that it read from another job.
    static constexpr unsigned index_bits = 36;
    static constexpr std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;

    std::atomic<std::uint64_t> next_{index_mask};
    std::atomic<std::uint64_t> count_{0};
    std::atomic<TaskFn> task_{nullptr};
    std::atomic<void*> context_{nullptr};
    std::atomic<std::thread::id> caller_{};
    std::atomic<int> processor_{-1};                 // the processor of the caller
    alignas(64) std::atomic<std::uint64_t> left_{0}; // the number of tasks that have not ended
    std::atomic<bool> awaited_{false};
    std::mutex mutex_;
    std::condition_variable ended_;

public:
    // A job has at most this many tasks.
    static constexpr std::int64_t most_tasks = std::int64_t{index_mask} - 1;
};

// The workers, and the jobs that they work on.
class Team {
public:
    // Starts `workers` threads, or fewer if the system cannot start them all.
    explicit Team(int workers) noexcept;
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    // Returns false if the caller must run the job alone, because it is inside a task, or because too many other jobs
    // are running.
    [[nodiscard]] bool run(std::int64_t count, TaskFn task, void* context) noexcept;

    [[nodiscard]] int workers() const noexcept { return started_; }

    static constexpr int most_workers = 255;

private:
    static constexpr int most_jobs = 32;

    struct Worker {
        Thread thread;
        Team* team = nullptr;
        std::atomic<std::thread::id> id{};
    };

    static void main(void* worker) noexcept;
    void serve() noexcept;
    [[nodiscard]] bool run_any_job() noexcept;
    void wait_for_event(std::uint32_t seen) noexcept;
    void wake(std::int64_t tasks) noexcept;
    [[nodiscard]] bool is_running_task(std::thread::id self) const noexcept;
    [[nodiscard]] int take_job() noexcept;

    std::array<Job, most_jobs> jobs_;
    std::atomic<std::uint32_t> taken_{0}; // one bit for each Job object: 1 while a caller uses it
    // The number of jobs that were opened, plus one when the team ends.
    alignas(64) std::atomic<std::uint32_t> event_count_{0};
    std::atomic<bool> ending_{false};
    std::atomic<int> asleep_{0};
    std::mutex mutex_;
    std::condition_variable woken_;
    int started_ = 0;
    std::array<Worker, most_workers> worker_;
};

class ThreadPool {
public:
    static constexpr int most_threads = Team::most_workers + 1;

    // `threads` includes the caller's thread, and is from 1 to most_threads.
    explicit ThreadPool(int threads) noexcept;
    // Ends the workers. No job may be running.
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    // Calls task(context, i) once for each i in [0, count), and returns when all calls have ended.  No task may throw.
    void run(std::int64_t count, TaskFn task, void* context) noexcept;

    // Returns the number of workers that the system started; 0 before the first job.
    [[nodiscard]] int workers() const noexcept;

private:
    // Returns the team of this process. A forked child has no threads of its parent, and its copies of the locks may be
    // held for ever. So it gets a new team.
    [[nodiscard]] Team& team() noexcept;
    [[nodiscard]] Team& stored_team() noexcept { return *std::launder(reinterpret_cast<Team*>(team_storage_)); }
    [[nodiscard]] const Team& stored_team() const noexcept {
        return *std::launder(reinterpret_cast<const Team*>(team_storage_));
    }

    int threads_;
    // The handle that keeps this library loaded while workers may run its code. The pool takes the handle, and not a
    // team, because a forked child makes a new team. If the fork happened while another thread made a team, the
    // loader's locks might be held for ever in the child.
    void* library_;
    std::atomic<std::int64_t> owner_{0}; // id of the process that owns the team; negative while the team starts
    alignas(Team) std::byte team_storage_[sizeof(Team)];
};

} // namespace hrbfnpr::base

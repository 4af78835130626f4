// SPDX-License-Identifier: MIT
// A small job system: some threads that take tasks from a list.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

class Pool {
public:
    using Task = void (*)(void* context, std::int64_t index);

    explicit Pool(std::size_t threads) : tasks_(threads + 1) {
        for (std::size_t number = 1; number <= threads; ++number)
            threads_.emplace_back([this, number] { serve(number); });
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    ~Pool() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            stops_ = true;
        }
        wake_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }

    // Calls task(context, i) for 0 <= i < count, and returns when all calls have ended. The caller works, too, so a
    // task may call run() again without a deadlock.
    void run(Task task, void* context, std::int64_t count) {
        if (count <= 0) return;
        Batch batch{task, context, count};
        std::unique_lock<std::mutex> lock(mutex_);
        open_.push_back(&batch);
        wake_.notify_all();
        while (batch.next < batch.count) run_next(batch, lock);
        ended_.wait(lock, [&] { return batch.ended == batch.count; });
    }

    // Returns how many tasks each thread has run. All threads outside the pool share number 0.
    std::vector<std::int64_t> tasks_run() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return tasks_;
    }

private:
    struct Batch {
        Task task;
        void* context;
        std::int64_t count;
        std::int64_t next = 0;
        std::int64_t ended = 0;
    };

    // Takes a batch's next task and runs it without the lock. Removes the batch from open_ when its last task is taken.
    void run_next(Batch& batch, std::unique_lock<std::mutex>& lock) {
        const std::int64_t index = batch.next++;
        if (batch.next == batch.count) open_.erase(std::find(open_.begin(), open_.end(), &batch));
        lock.unlock();
        batch.task(batch.context, index);
        lock.lock();
        ++tasks_[own_number];
        if (++batch.ended == batch.count) ended_.notify_all();
    }

    void serve(std::size_t number) {
        own_number = number;
        std::unique_lock<std::mutex> lock(mutex_);
        for (;;) {
            wake_.wait(lock, [this] { return stops_ || !open_.empty(); });
            if (stops_) return;
            run_next(*open_.back(), lock);
        }
    }

    inline static thread_local std::size_t own_number = 0;

    mutable std::mutex mutex_; // guards all members below except threads_
    std::condition_variable wake_, ended_;
    std::vector<Batch*> open_; // batches that have tasks left to take
    std::vector<std::int64_t> tasks_;
    bool stops_ = false;
    std::vector<std::thread> threads_;
};

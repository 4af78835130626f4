// SPDX-License-Identifier: MIT
// Runs one long job on a separate thread, reports its progress, and can cancel it.
#pragma once

#include "handles.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace viewer {

// Names the step under way, for any thread. It outlives the pictures, which report to it whenever they are drawn.
class Progress {
public:
    void set(const char* doing) {
        const std::lock_guard<std::mutex> lock(mutex_);
        doing_ = doing;
    }
    std::string doing() const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return doing_;
    }
    static void on_event(void* progress, const hrbfnpr_picture_event* event) {
        if (event->note == nullptr && event->stage != HRBFNPR_STAGE_FRAME && event->fraction == 0)
            static_cast<Progress*>(progress)->set(event->doing);
    }

private:
    mutable std::mutex mutex_;
    std::string doing_;
};

// The data that a job gets.
class Work {
public:
    Work(const Context& context, Progress& progress) : context(context), progress_(progress) {
        operation = make<hrbfnpr_operation>(hrbfnpr_operation_release, [&](auto** out, auto* error) {
            return hrbfnpr_operation_create(context.get(), out, error);
        });
        progress.set("starting");
    }

    void listen(hrbfnpr_picture_desc& desc) const {
        desc.on_event = Progress::on_event;
        desc.event_user = &progress_;
    }
    // A job of several steps calls this before each step. A cancelled job throws here.
    void step(const std::string& doing, double share) {
        if (hrbfnpr_operation_is_cancelled(operation.get())) throw Failure("cancelled", HRBFNPR_STATUS_CANCELLED);
        progress_.set(doing.c_str());
        share_ = share;
    }
    // 0 to 1, for any thread.
    double share() const {
        const double share = share_;
        return share >= 0 ? share : hrbfnpr_operation_progress(operation.get());
    }

    Context context;
    Operation operation;

private:
    Progress& progress_;
    std::atomic<double> share_{-1}; // share of the steps that are done; negative: the operation counts instead
};

// Runs jobs one at a time. Only the job runs on another thread; all other calls are for the thread that owns the
// Worker.
class Worker {
public:
    Worker(const Context& context, Progress& progress) : context_(context), progress_(progress) {}
    ~Worker() { stop(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // Runs `job` on the worker's thread. If the job succeeds, poll() calls `then` on the caller's thread. Cancels a job
    // that runs.
    void start(std::function<void(Work&)> job, std::function<void(Work&)> then);
    // Returns true if a job has ended. Rethrows a Failure of the job, unless it was cancelled.
    bool poll();
    void cancel();
    bool is_busy() const { return work_ != nullptr; }
    const Work& work() const { return *work_; }
    bool was_cancelled() const { return was_cancelled_; }

private:
    void stop(); // cancels and waits

    Context context_;
    Progress& progress_;
    std::unique_ptr<Work> work_;
    std::function<void(Work&)> then_;
    std::thread thread_;
    std::atomic<bool> is_done_{false};
    std::exception_ptr failure_;
    bool was_cancelled_ = false;
};

} // namespace viewer

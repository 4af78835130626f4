// SPDX-License-Identifier: MIT
// One long job on a thread of its own: what it is at, how far, how long each stage took; and an end to it.
#pragma once

#include "handles.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace viewer {

struct Timing {
    const char* stage;
    double milliseconds;
};

// What a job is given.
class Work {
public:
    explicit Work(const Context& context) : context(context) {
        operation = make<hrbfnpr_operation>(hrbfnpr_operation_release, [&](auto** out, auto* error) {
            return hrbfnpr_operation_create(context.get(), out, error);
        });
    }

    // call(operation, &error), timed, under a name that is shown.
    template <class Call>
    void stage(const char* name, Call&& call) {
        stage_ = name;
        const auto start = std::chrono::steady_clock::now();
        checked([&](hrbfnpr_error* error) { return call(operation.get(), error); });
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        timings.push_back({name, took.count()});
    }
    // The same for what the library has no part in; a cancelled job ends before it.
    template <class Call>
    void own_stage(const char* name, Call&& call) {
        stage(name, [&](hrbfnpr_operation*, hrbfnpr_error*) {
            if (hrbfnpr_operation_is_cancelled(operation.get())) throw Failure("cancelled", HRBFNPR_STATUS_CANCELLED);
            call();
            return HRBFNPR_STATUS_OK;
        });
    }

    const char* stage_now() const { return stage_; } // any thread
    double progress() const { return hrbfnpr_operation_progress(operation.get()); }

    Context context;
    Operation operation;
    std::vector<Timing> timings;
    std::vector<std::string> notes;

private:
    std::atomic<const char*> stage_{"starting"};
};

// Runs jobs one at a time.  All but the job itself is for the thread that has it.
class Worker {
public:
    explicit Worker(const Context& context) : context_(context) {}
    ~Worker() { stop(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    // `job` runs on the worker's thread; `then` here, in poll(), if it came to an end.  A job that runs is cancelled.
    void start(std::function<void(Work&)> job, std::function<void(Work&)> then);
    // True if a job has ended.  A Failure of its is thrown, but for that of being cancelled.
    bool poll();
    void cancel();
    bool is_busy() const { return work_ != nullptr; }
    const Work& work() const { return *work_; }
    bool was_cancelled() const { return was_cancelled_; }

private:
    void stop(); // cancels and waits

    Context context_;
    std::unique_ptr<Work> work_;
    std::function<void(Work&)> then_;
    std::thread thread_;
    std::atomic<bool> is_done_{false};
    std::exception_ptr failure_;
    bool was_cancelled_ = false;
};

} // namespace viewer

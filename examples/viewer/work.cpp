// SPDX-License-Identifier: MIT
#include "work.h"

namespace viewer {

void Worker::start(std::function<void(Work&)> job, std::function<void(Work&)> then) {
    stop();
    work_ = std::make_unique<Work>(context_, progress_);
    then_ = std::move(then);
    is_done_ = false;
    failure_ = nullptr;
    thread_ = std::thread([this, job = std::move(job)] {
        try {
            job(*work_);
        } catch (...) {
            failure_ = std::current_exception();
        }
        is_done_ = true;
    });
}

bool Worker::poll() {
    if (!is_busy() || !is_done_) return false;
    thread_.join();
    const std::unique_ptr<Work> work = std::move(work_);
    was_cancelled_ = hrbfnpr_operation_is_cancelled(work->operation.get()) != 0;
    try {
        if (failure_) std::rethrow_exception(failure_);
    } catch (const Failure& failure) {
        if (failure.status != HRBFNPR_STATUS_CANCELLED) throw;
        return true;
    } catch (const std::bad_alloc&) {
        throw Failure("there is not enough memory; use fewer marks or a smaller model");
    }
    was_cancelled_ = false; // the cancellation came too late
    then_(*work);
    return true;
}

void Worker::cancel() {
    if (is_busy()) hrbfnpr_operation_cancel(work_->operation.get());
}

void Worker::stop() {
    cancel();
    if (thread_.joinable()) thread_.join();
    work_.reset();
}

} // namespace viewer

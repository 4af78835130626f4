// SPDX-License-Identifier: MIT
#include "api/operation.h"

#include "api/barrier.h"

namespace hrbfnpr::api {

OperationUse::OperationUse(hrbfnpr_operation* operation) : handle_(operation), hold_(operation) {
    if (handle_ == nullptr) return;
    if (handle_->busy.exchange(true, std::memory_order_acquire))
        fail(Status::invalid_argument,
             "operation is in use by another call; give each call its own operation, or wait");
    try {
        handle_->operation.begin();
    } catch (...) {
        handle_->busy.store(false, std::memory_order_release);
        throw;
    }
}

OperationUse::~OperationUse() {
    if (handle_ != nullptr) handle_->busy.store(false, std::memory_order_release);
}

} // namespace hrbfnpr::api

using namespace hrbfnpr;

extern "C" {

hrbfnpr_status hrbfnpr_operation_create(hrbfnpr_context* context, hrbfnpr_operation** out_operation,
                                        hrbfnpr_error* error) {
    return api::guarded_create(out_operation, "out_operation", error,
                               [&] { return api::make_handle<hrbfnpr_operation>(api::deref(context, "context")); });
}

void hrbfnpr_operation_retain(hrbfnpr_operation* operation) {
    if (operation != nullptr) operation->add_reference();
}

void hrbfnpr_operation_release(hrbfnpr_operation* operation) { api::release_handle(operation); }

void hrbfnpr_operation_cancel(hrbfnpr_operation* operation) {
    if (operation != nullptr) operation->operation.cancel();
}

int32_t hrbfnpr_operation_is_cancelled(const hrbfnpr_operation* operation) {
    return operation != nullptr && operation->operation.is_cancelled() ? 1 : 0;
}

double hrbfnpr_operation_progress(const hrbfnpr_operation* operation) {
    return operation != nullptr ? operation->operation.progress() : 0.0;
}

hrbfnpr_status hrbfnpr_operation_set_callback(hrbfnpr_operation* operation, hrbfnpr_progress_fn callback, void* user,
                                              hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        auto& handle = api::deref(operation, "operation");
        if (handle.busy.load(std::memory_order_acquire))
            fail(Status::invalid_argument,
                 "operation is in use by a call; set the callback before the call or after it");
        handle.operation.set_callback(callback, user);
    });
}

} // extern "C"

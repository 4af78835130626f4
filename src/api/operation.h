// SPDX-License-Identifier: MIT
// An operation as a handle, and its use by one long call.
#pragma once

#include "api/handles.h"
#include "base/operation.h"

struct hrbfnpr_operation : hrbfnpr::api::Child {
    using Child::Child;
    hrbfnpr::base::Operation operation;
    std::atomic<bool> busy{false};
};

namespace hrbfnpr::api {

// Lets one call use an operation, which may be NULL, and keeps it alive if the caller releases it meanwhile.
class OperationUse {
public:
    // Throws Error{cancelled} if the operation was cancelled, or Error{invalid_argument} if another call uses it.
    explicit OperationUse(hrbfnpr_operation* operation);
    ~OperationUse();
    OperationUse(const OperationUse&) = delete;
    OperationUse& operator=(const OperationUse&) = delete;

    [[nodiscard]] base::Progress progress() const noexcept {
        return handle_ != nullptr ? base::Progress(&handle_->operation) : base::Progress();
    }
    // Reports that the work is done: sets the progress to 1, and checks for cancellation for the last time.
    void finish() const { progress().update(1.0); }
    // Ends a call that has already made a handle. If the operation was cancelled, the handle is released.
    template <class T>
    [[nodiscard]] T* finish_with(T* handle) const {
        try {
            finish();
        } catch (...) {
            release_handle(handle);
            throw;
        }
        return handle;
    }

private:
    hrbfnpr_operation* handle_;
    HandleHold<hrbfnpr_operation> hold_;
};

} // namespace hrbfnpr::api

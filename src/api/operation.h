// SPDX-License-Identifier: MIT
// The handle of an operation, and its use by one long call.
#pragma once

#include "api/handles.h"
#include "base/operation.h"

struct hrbfnpr_operation : hrbfnpr::api::Child {
    using Child::Child;
    hrbfnpr::base::Operation operation;
    std::atomic<bool> busy{false};
};

namespace hrbfnpr::api {

// Lets one call use an operation, which may be NULL. It keeps the operation alive, even if the caller releases it
// during the call.
class OperationUse {
public:
    // Throws Error{cancelled} if the operation is cancelled, and Error{invalid_argument} if another call is using it.
    explicit OperationUse(hrbfnpr_operation* operation);
    ~OperationUse();
    OperationUse(const OperationUse&) = delete;
    OperationUse& operator=(const OperationUse&) = delete;

    [[nodiscard]] base::Progress progress() const noexcept {
        return handle_ != nullptr ? base::Progress(&handle_->operation) : base::Progress();
    }
    // Reports the end of the work: sets the progress to 1, after a last check for cancellation.
    void finish() const { progress().update(1.0); }
    // Ends a call that has already made a handle. If the operation is cancelled, the handle is released.
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

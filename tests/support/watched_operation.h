// SPDX-License-Identifier: MIT
// An operation of the inside, with a watcher.
#pragma once

#include "base/operation.h"
#include "support/watcher.h"

namespace hrbfnpr::test {

// Begun, and ready for one call.
class WatchedOperation {
public:
    explicit WatchedOperation(double cancel_at = 2.0) {
        watcher.cancel_at = cancel_at;
        operation_.set_callback(Watcher::call, &watcher);
        operation_.begin();
    }
    [[nodiscard]] base::Progress progress() { return base::Progress(&operation_); }

    Watcher watcher;

private:
    base::Operation operation_;
};

} // namespace hrbfnpr::test

// SPDX-License-Identifier: MIT
// Limits that keep a call short, whatever its descriptors ask for: an operation that cancels it, and limited memory.
#pragma once

#include "fuzz.h"
#include "input.h"

#include <ctime>

namespace fuzz {

// Half of the calls run to their end, but are cancelled after a second of processor time. The others are cancelled
// after a number of progress reports that the input selects.
class Operation {
public:
    Operation(Context& context, Input& input) {
        static constexpr int calls[] = {none, none, none, none, none, 0, 1, 2, 5, 20};
        left_ = input.one_of(calls);
        Call call("operation_create");
        call.expect(hrbfnpr_operation_create(context.handle, &handle, call.error()));
        Call set("operation_set_callback");
        set.expect(hrbfnpr_operation_set_callback(handle, progress, this, set.error()));
        if (left_ != 0) return;
        cancelled_ = true;
        hrbfnpr_operation_cancel(handle);
    }
    Operation(const Operation&) = delete;
    Operation& operator=(const Operation&) = delete;
    ~Operation() { hrbfnpr_operation_release(handle); }

    // Checks the result of a call: only a cancelled call may return CANCELLED.
    void check(hrbfnpr_status status) const {
        require(status != HRBFNPR_STATUS_CANCELLED || cancelled_, "nothing is cancelled that nobody cancels");
    }

    hrbfnpr_operation* handle = nullptr;

private:
    static constexpr int none = -1;
    static constexpr double seconds = 1.0; // processor time for one call

    static std::int32_t progress(void* user, double progress) {
        auto& self = *static_cast<Operation*>(user);
        require(progress >= 0.0 && progress <= 1.0, "progress is from 0 to 1");
        require(progress >= self.last_, "progress never falls");
        self.last_ = progress;
        if (self.left_ > 0) --self.left_;
        const double spent = static_cast<double>(std::clock() - self.begin_) / CLOCKS_PER_SEC;
        self.cancelled_ = self.cancelled_ || self.left_ == 0 || spent > seconds;
        return self.cancelled_ ? 1 : 0;
    }

    int left_ = none;
    double last_ = 0.0;
    bool cancelled_ = false;
    std::clock_t begin_ = std::clock();
};

// For one in eight inputs an allocation fails while this object exists.
class ShortMemory {
public:
    ShortMemory(Context& context, Input& input) : context_(context) {
        if (input.once_in(8)) context.until_refusal = static_cast<std::int64_t>(input.below(400));
    }
    ShortMemory(const ShortMemory&) = delete;
    ShortMemory& operator=(const ShortMemory&) = delete;
    ~ShortMemory() { context_.until_refusal = -1; }

private:
    Context& context_;
};

} // namespace fuzz

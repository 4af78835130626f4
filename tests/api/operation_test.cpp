// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <functional>

namespace api_test::operation_test {
namespace {

// A call that takes long, and one that a callback makes.
struct Calls {
    explicit Calls(std::int32_t threads = 2)
        : context(make_context(threads)), samples(scenes::torus(60)), model(fit(context, samples)) {
        for (int i = 0; i < 3 * 3000; ++i) points.push_back(0.001 * (i % 1700));
    }

    using Call = std::function<hrbfnpr_status(hrbfnpr_operation*, hrbfnpr_error*)>;

    Call fit_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_fit_desc desc = fit_desc(samples);
            hrbfnpr_model* made_model = nullptr;
            const hrbfnpr_status status = hrbfnpr_model_fit(context.get(), &desc, operation, &made_model, error);
            EXPECT_EQ(made_model != nullptr, status == HRBFNPR_STATUS_OK);
            hrbfnpr_model_release(made_model);
            return status;
        };
    }
    Call evaluate_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            std::vector<double> values(points.size() / 3);
            const hrbfnpr_array from = in(points);
            const hrbfnpr_array_out to = out(values, 1);
            return hrbfnpr_model_evaluate(model.get(), &from, &to, nullptr, nullptr, operation, error);
        };
    }

    Context context;
    scenes::Samples samples;
    Model model;
    std::vector<double> points;
};

// A callback that calls the library with the operation that is in use.
struct Reentry {
    Calls* calls = nullptr;
    hrbfnpr_operation* operation = nullptr;
    std::int32_t call_status = 0;
    std::int32_t callback_status = 0;
    std::string message;

    static std::int32_t call(void* user, double /*progress*/) {
        auto& self = *static_cast<Reentry*>(user);
        if (self.call_status != 0) return 0;
        Error error;
        self.call_status = self.calls->evaluate_call()(self.operation, error);
        self.message = error.record.message;
        self.callback_status = hrbfnpr_operation_set_callback(self.operation, nullptr, nullptr, nullptr);
        return 0;
    }
};

TEST(Operation, ServesOneCallAtATime) {
    Calls calls;
    Error error;
    const Operation operation = make_operation(calls.context);
    Reentry reentry;
    reentry.calls = &calls;
    reentry.operation = operation.get();
    EXPECT_OK(hrbfnpr_operation_set_callback(operation.get(), Reentry::call, &reentry, error));
    EXPECT_OK(calls.fit_call()(operation.get(), error));
    EXPECT_EQ(reentry.call_status, HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(reentry.callback_status, HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(reentry.message, "operation is in use by another call; give each call its own operation, or wait");
}

TEST(Operation, MayBeReleasedWhileItsCallRuns) {
    Calls calls;
    hrbfnpr_operation* operation = make_operation(calls.context).release();
    hrbfnpr_operation_set_callback(
        operation,
        [](void* user, double progress) -> std::int32_t {
            auto& handle = *static_cast<hrbfnpr_operation**>(user);
            if (progress > 0.0) hrbfnpr_operation_release(std::exchange(handle, nullptr));
            return 0;
        },
        &operation, nullptr);
    Error error;
    EXPECT_OK(calls.fit_call()(operation, error));
    EXPECT_EQ(operation, nullptr);
}

TEST(Operation, NullIsHarmless) {
    hrbfnpr_operation_release(nullptr);
    hrbfnpr_operation_cancel(nullptr);
    EXPECT_EQ(hrbfnpr_operation_is_cancelled(nullptr), 0);
    EXPECT_EQ(hrbfnpr_operation_progress(nullptr), 0.0);
    Error error;
    EXPECT_FAILS(hrbfnpr_operation_set_callback(nullptr, nullptr, nullptr, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "operation is NULL");
}

} // namespace
} // namespace api_test::operation_test

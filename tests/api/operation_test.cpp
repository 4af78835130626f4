// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <functional>
#include <thread>

namespace api_test::operation_test {
namespace {

// Every kind of long call, on the same data.
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
    Call generate_call(std::uint32_t distribution) {
        return [this, distribution](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            Generation desc = small_desc(distribution);
            hrbfnpr_point_set* set = nullptr;
            const hrbfnpr_status status =
                hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), operation, &set, error);
            EXPECT_EQ(set != nullptr, status == HRBFNPR_STATUS_OK);
            hrbfnpr_point_set_release(set);
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
    Call project_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = in(points);
            auto projection = made(hrbfnpr_projection_init);
            return hrbfnpr_model_project(model.get(), &from, nullptr, &projection, operation, error);
        };
    }
    Call curvature_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = in(points);
            auto curvature = made(hrbfnpr_curvature_init);
            return hrbfnpr_model_curvature(model.get(), &from, &curvature, operation, error);
        };
    }
    Call cast_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const std::vector<double> directions(points.size(), 1.0);
            const hrbfnpr_array from = in(points);
            const hrbfnpr_array along = in(directions);
            auto hits = made(hrbfnpr_ray_hits_init);
            return hrbfnpr_model_cast_rays(model.get(), &from, &along, nullptr, &hits, operation, error);
        };
    }
    Call lipschitz_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            double bound = 0.0;
            return hrbfnpr_model_lipschitz(model.get(), &bound, operation, error);
        };
    }
    Call contains_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = in(points);
            return hrbfnpr_model_contains(model.get(), &from, nullptr, nullptr, operation, error);
        };
    }
    Call patches_call() {
        return [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            std::vector<float> corners(36);
            const hrbfnpr_array_out to = out(corners, 12);
            return hrbfnpr_point_set_step_patches(context.get(), model.get(), nullptr, &to, nullptr, operation, error);
        };
    }
    std::vector<std::pair<const char*, Call>> all() {
        return {{"fit", fit_call()},
                {"generate blue noise", generate_call(HRBFNPR_DISTRIBUTION_BLUE_NOISE)},
                {"generate published", generate_call(HRBFNPR_DISTRIBUTION_PUBLISHED)},
                {"evaluate", evaluate_call()},
                {"project", project_call()},
                {"curvature", curvature_call()},
                {"cast rays", cast_call()},
                {"lipschitz", lipschitz_call()},
                {"contains", contains_call()},
                {"step patches", patches_call()}};
    }

    Context context;
    scenes::Samples samples;
    Model model;
    std::vector<double> points;
};

TEST(Operation, ProgressRisesToOneInEveryCall) {
    for (const std::int32_t threads : {1, 3}) {
        Calls calls(threads);
        for (const auto& [name, call] : calls.all()) {
            Error error;
            const Operation operation = make_operation(calls.context);
            Watcher watcher;
            EXPECT_OK(hrbfnpr_operation_set_callback(operation.get(), Watcher::call, &watcher, error));
            EXPECT_OK(call(operation.get(), error)) << name;
            EXPECT_EQ(hrbfnpr_operation_progress(operation.get()), 1.0) << name;
            EXPECT_FALSE(watcher.other_thread) << name;
            // Other threads may have done all the work.
            ASSERT_GE(watcher.values.size(), threads == 1 ? 2U : 1U) << name;
            EXPECT_EQ(watcher.values.back(), 1.0) << name;
            EXPECT_GE(watcher.values.front(), 0.0) << name;
            EXPECT_TRUE(watcher.values.front() < 1.0 || threads > 1) << name;
            EXPECT_TRUE(std::is_sorted(watcher.values.begin(), watcher.values.end())) << name;
        }
    }
}

TEST(Operation, CanBeCancelledFromAnotherThread) {
    Calls calls(2);
    for (const auto& [name, call] : calls.all()) {
        Error error;
        const Operation operation = make_operation(calls.context);
        // The callback waits until the other thread has cancelled, so that the call is certainly running.
        struct Meeting {
            std::atomic<bool> inside{false};
            hrbfnpr_operation* operation;
            static std::int32_t call(void* user, double /*progress*/) {
                auto& self = *static_cast<Meeting*>(user);
                self.inside = true;
                while (hrbfnpr_operation_is_cancelled(self.operation) == 0) std::this_thread::yield();
                return 0;
            }
        } meeting;
        meeting.operation = operation.get();
        hrbfnpr_operation_set_callback(operation.get(), Meeting::call, &meeting, nullptr);
        std::thread other([&] {
            while (!meeting.inside) std::this_thread::yield();
            hrbfnpr_operation_cancel(operation.get());
        });
        EXPECT_EQ(call(operation.get(), error), HRBFNPR_STATUS_CANCELLED) << name;
        other.join();
    }
}

TEST(Operation, StaysCancelled) {
    Calls calls;
    const Operation operation = make_operation(calls.context);
    EXPECT_EQ(hrbfnpr_operation_is_cancelled(operation.get()), 0);
    hrbfnpr_operation_cancel(operation.get());
    hrbfnpr_operation_cancel(operation.get());
    for (const auto& [name, call] : calls.all()) {
        Error error;
        EXPECT_FAILS(call(operation.get(), error), HRBFNPR_STATUS_CANCELLED, "cancelled before the call");
    }
}

TEST(Operation, ServesOneCallAfterTheOther) {
    Calls calls;
    const Operation operation = make_operation(calls.context);
    for (const auto& [name, call] : calls.all()) {
        Error error;
        EXPECT_OK(call(operation.get(), error));
        EXPECT_EQ(hrbfnpr_operation_progress(operation.get()), 1.0);
    }
}

// A callback that calls back into the library with the operation that is in use.
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
    EXPECT_EQ(reentry.message, "operation is in use by another call; give each call that runs one of its own");
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

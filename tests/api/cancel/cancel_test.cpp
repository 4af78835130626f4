// SPDX-License-Identifier: MIT
// Tests that every call that takes an operation can be cancelled by its callback and from another thread: it reports
// this, keeps no memory, and called again with the same objects gives the same bits as without cancellation.
#include "stages/stages.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace api_test::cancel_test {
namespace {

// The callback is also called when time has passed, which happens on a busy machine. So moments are told apart by the
// progress, which does not depend on time in a context of one thread.
std::vector<double> moments(const std::vector<double>& values) {
    std::vector<double> different(values);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    std::vector<double> some;
    const std::size_t step = 1 + different.size() / 6;
    for (std::size_t i = 0; i < different.size(); i += step) some.push_back(different[i]);
    if (!different.empty()) some.push_back(different.back());
    return some;
}

StageSizes scene() {
    StageSizes sizes;
    sizes.dense_samples = 300;
    sizes.cloud = 30;
    sizes.marks = 1000;
    sizes.places = 2000;
    sizes.mesh_around = 40;
    return sizes;
}

hrbfnpr_status run(const Stage& stage, hrbfnpr_operation* operation, Bytes& bytes, hrbfnpr_error* error) {
    Attempt attempt;
    attempt.operation = operation;
    return stage.call(attempt, bytes, error);
}

void renew(const Stage& stage) {
    if (stage.renew) stage.renew();
}

TEST(Cancel, WorksFromTheCallbackAtEveryStage) {
    const Context context = make_context(1);
    Stages stages(context, scene());
    int with_operation = 0;
    for (const Stage& stage : stages.all()) {
        Error error;
        renew(stage);
        Bytes wanted;
        Watcher counted;
        const Operation first = make_operation(context);
        hrbfnpr_operation_set_callback(first.get(), Watcher::call, &counted, nullptr);
        ASSERT_OK(run(stage, first.get(), wanted, error)) << stage.name;
        if (counted.values.empty()) continue; // the call takes no operation
        ++with_operation;
        EXPECT_EQ(counted.values.back(), 1.0) << stage.name;
        EXPECT_TRUE(std::is_sorted(counted.values.begin(), counted.values.end())) << stage.name;
        renew(stage); // a renderer that has drawn keeps scratch
        const std::int64_t before = info_of(context).bytes_now;
        for (const double moment : moments(counted.values)) {
            const Operation operation = make_operation(context);
            Watcher watcher;
            watcher.cancel_at = moment;
            hrbfnpr_operation_set_callback(operation.get(), Watcher::call, &watcher, nullptr);
            Bytes nothing;
            EXPECT_FAILS(run(stage, operation.get(), nothing, error), HRBFNPR_STATUS_CANCELLED, "cancelled");
            EXPECT_EQ(std::count_if(watcher.values.begin(), watcher.values.end(),
                                    [&](double value) { return value >= moment; }),
                      1)
                << stage.name; // the callback is not called again
        }
        Bytes again;
        EXPECT_OK(run(stage, nullptr, again, error));
        EXPECT_TRUE(again == wanted) << stage.name;
        renew(stage);
        EXPECT_EQ(info_of(context).bytes_now, before) << stage.name;
    }
    EXPECT_EQ(with_operation, 76);
}

// One operation serves all calls, one after the other. Once it is cancelled, it ends each call before the call begins.
TEST(Cancel, HoldsForEveryLaterCall) {
    const Context context = make_context(3);
    Stages stages(context);
    const std::vector<Stage> all = stages.all();
    const Operation operation = make_operation(context);
    Watcher watcher;
    hrbfnpr_operation_set_callback(operation.get(), Watcher::call, &watcher, nullptr);
    EXPECT_EQ(hrbfnpr_operation_is_cancelled(operation.get()), 0);
    for (const Stage& stage : all) {
        Error error;
        Bytes bytes;
        renew(stage);
        EXPECT_OK(run(stage, operation.get(), bytes, error)) << stage.name;
        EXPECT_EQ(hrbfnpr_operation_progress(operation.get()), 1.0) << stage.name;
    }
    EXPECT_FALSE(watcher.other_thread);
    hrbfnpr_operation_cancel(operation.get());
    hrbfnpr_operation_cancel(operation.get());
    int cancelled = 0;
    for (const Stage& stage : all) {
        Error error;
        Bytes bytes;
        renew(stage);
        const hrbfnpr_status status = run(stage, operation.get(), bytes, error);
        if (status == HRBFNPR_STATUS_OK) continue; // the call takes no operation
        EXPECT_FAILS(status, HRBFNPR_STATUS_CANCELLED, "cancelled before the call");
        ++cancelled;
    }
    EXPECT_EQ(cancelled, 76);
}

// The cancels come at moments spread over the call's time.
TEST(Cancel, WorksFromAnotherThreadAtAnyTime) {
    const Context context = make_context(3);
    Stages stages(context, scene());
    int cancelled = 0;
    for (const Stage& stage : stages.all()) {
        Error error;
        renew(stage);
        Bytes wanted;
        const auto begin = std::chrono::steady_clock::now();
        ASSERT_OK(run(stage, nullptr, wanted, error)) << stage.name;
        const auto whole = std::chrono::steady_clock::now() - begin;
        for (int part = 0; part < 4; ++part) {
            const Operation operation = make_operation(context);
            std::thread other([&] {
                std::this_thread::sleep_for(whole * part / 4);
                hrbfnpr_operation_cancel(operation.get());
            });
            Bytes bytes;
            const hrbfnpr_status status = run(stage, operation.get(), bytes, error);
            other.join();
            EXPECT_TRUE(status == HRBFNPR_STATUS_CANCELLED || (status == HRBFNPR_STATUS_OK && bytes == wanted))
                << stage.name << ": " << hrbfnpr_status_name(status);
            cancelled += status == HRBFNPR_STATUS_CANCELLED ? 1 : 0;
        }
        Bytes again;
        EXPECT_OK(run(stage, nullptr, again, error));
        EXPECT_TRUE(again == wanted) << stage.name;
    }
    EXPECT_GT(cancelled, 20);
}

// The callback makes a call of its own, as a preview does: that call is not part of the outer call, and the outer
// call's cancel does not end it.
TEST(Cancel, DoesNotEndACallMadeInsideACallback) {
    struct Preview {
        const Context& context;
        const Model& model;
        hrbfnpr_operation* operation = nullptr;
        int calls = 0, failed = 0;
        static std::int32_t call(void* user, double /*progress*/) {
            auto& self = *static_cast<Preview*>(user);
            hrbfnpr_operation_cancel(self.operation);
            ++self.calls;
            std::vector<double> points(3 * 5000, 0.5), value(5000);
            const hrbfnpr_array from = in(points);
            const hrbfnpr_array_out to = out(value, 1);
            if (hrbfnpr_model_evaluate(self.model.get(), &from, &to, nullptr, nullptr, nullptr, nullptr) !=
                HRBFNPR_STATUS_OK)
                ++self.failed;
            return 0;
        }
    };
    const Context context = make_context(2);
    const scenes::Samples samples = scenes::torus(60);
    const Model model = fit(context, samples);
    const Operation operation = make_operation(context);
    Preview preview{context, model, operation.get()};
    Error error;
    EXPECT_OK(hrbfnpr_operation_set_callback(operation.get(), Preview::call, &preview, error));
    const hrbfnpr_fit_desc desc = fit_desc(samples);
    hrbfnpr_model* none = nullptr;
    EXPECT_EQ(hrbfnpr_model_fit(context.get(), &desc, operation.get(), &none, error), HRBFNPR_STATUS_CANCELLED);
    EXPECT_EQ(preview.calls, 1);
    EXPECT_EQ(preview.failed, 0);
}

} // namespace
} // namespace api_test::cancel_test

// SPDX-License-Identifier: MIT
// Tests a job runner that leaves tasks out, and any floating-point state of the caller.
#include "stages/stages.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace api_test::threads_test {
namespace {

// The results of the missing tasks do not exist, so the call fails and says how many tasks ran.
TEST(RunTasks, SkippedTasksFailTheCall) {
    Error error;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 3;
    desc.run_tasks = [](void*, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
        for (std::int64_t i = 1; i < count; ++i) task(task_context, i);
    };
    const Context context = make_context(desc);
    const scenes::Samples samples = scenes::torus(60);
    const hrbfnpr_fit_desc fit = fit_desc(samples);
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &fit, nullptr, &model, error), HRBFNPR_STATUS_CALLBACK,
                 "run_tasks returned after ");
    EXPECT_EQ(model, nullptr);
}

#if defined(__SSE2__)
// Rounds up, flushes to zero and takes subnormals for zero during each call.
class Strangely : public Attempt {
protected:
    void begin() override {
        before_ = _mm_getcsr();
        _mm_setcsr((before_ & ~0x6000U) | 0x4000U | 0x8040U);
        strange_ = _mm_getcsr();
    }
    void end() override {
        const unsigned after = _mm_getcsr();
        _mm_setcsr(before_);
        // The sticky exception flags may be set by the test itself.
        EXPECT_EQ(after & ~0x3FU, strange_ & ~0x3FU);
    }

private:
    unsigned before_ = 0, strange_ = 0;
};

TEST(FloatingPoint, TheCallersStateHasNoEffectAndIsPreserved) {
    const Context context = make_context(2);
    Stages stages(context);
    for (const Stage& stage : stages.all()) {
        if (stage.name.rfind("picture", 0) == 0) continue; // pictures consist of the other calls
        Error error;
        Attempt normally;
        Strangely strangely;
        Bytes wanted, made;
        if (stage.renew) stage.renew();
        EXPECT_OK(stage.call(normally, wanted, error)) << stage.name;
        if (stage.renew) stage.renew();
        EXPECT_OK(stage.call(strangely, made, error)) << stage.name;
        EXPECT_TRUE(made == wanted) << stage.name;
    }
}

TEST(FloatingPoint, DoesNotTriggerTheCallersTraps) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before & ~0x0E80U & ~0x3FU); // division by zero, overflow, underflow and invalid would trap
    const Context context = make_context(2);
    const Model model = fit(context, scenes::sphere_6());
    const PointSet set = generate(context, model, small_desc());
    const auto pixels = draw(make_renderer(context), set);
    _mm_setcsr(before);
    EXPECT_FALSE(pixels.empty());
}
#endif

} // namespace
} // namespace api_test::threads_test

// SPDX-License-Identifier: MIT
// Tests threads with small stacks, as job systems have: 64 KiB is enough for every call but fit, which needs 512 KiB.
#include "host/calls.h"
#include "host/small_stack.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace host_test::stack_test {
namespace {

constexpr std::size_t KiB = 1024;
constexpr std::size_t small = 64 * KiB;
constexpr std::size_t fit_needs = 512 * KiB; // the size that hrbfnpr.h states
constexpr std::size_t large = 4096 * KiB;
constexpr std::size_t reserve = 12 * KiB; // for the host's own frames and a signal handler's

// Measures first, since an overflow would tell nothing but that it happened.
void expect_enough(std::size_t stack, const char* what, const std::function<void()>& work) {
    const std::size_t used = run_on_a_stack_of(large, work);
    std::printf("%-28s %6.1f KiB\n", what, static_cast<double>(used) / static_cast<double>(KiB));
    ASSERT_LE(used, stack - reserve) << what;
    run_on_a_stack_of(stack, work);
}

class SmallStacks : public testing::TestWithParam<std::int32_t> {}; // parameter: the context's threads, 0 = all

TEST_P(SmallStacks, SufficeForEverythingExceptFit) {
    const Calls calls(make_context(GetParam()));
    for (const api_test::Stage& call : calls.all()) expect_enough(small, call.name.c_str(), [&] { Calls::run(call); });
}

std::int64_t bytes_in_use(const Context& context) {
    scenes::Check check;
    auto info = made(hrbfnpr_context_info_init);
    check(hrbfnpr_context_get_info(context.get(), &info, check.error()));
    return info.bytes_now;
}

TEST_P(SmallStacks, SufficeForAModelThatPreparesItself) {
    static constexpr int centres = 1500;
    static constexpr std::int64_t count =
        400'000; // with Hessians, enough points to make preparation worthwhile: see _evaluate
    const Context context = make_context(GetParam());
    const scenes::Samples torus = scenes::torus(centres);
    auto desc = fit_desc(torus);
    desc.solver = HRBFNPR_SOLVER_ITERATIVE;
    std::vector<float> point;
    for (int i = 0; i < 3 * count; ++i) point.push_back(0.0011F * static_cast<float>((i * 37) % 2500) - 1.3F);
    std::vector<float> result(std::size_t{10} * count);
    const hrbfnpr_array points{point.data(), count, 0, HRBFNPR_SCALAR_FLOAT32, 3};
    const hrbfnpr_array_out value{result.data(), count, 0, HRBFNPR_SCALAR_FLOAT32, 1};
    const hrbfnpr_array_out gradient{result.data() + count, count, 0, HRBFNPR_SCALAR_FLOAT32, 3};
    const hrbfnpr_array_out hessian{result.data() + 4 * count, count, 0, HRBFNPR_SCALAR_FLOAT32, 6};
    Model model;
    const auto evaluate = [&] {
        scenes::Check check;
        check(hrbfnpr_model_evaluate(model.get(), &points, &value, &gradient, &hessian, nullptr, check.error()));
    };
    for (const std::size_t stack : {large, small}) {
        model = fit(context, desc); // not prepared yet
        const std::int64_t before = bytes_in_use(context);
        const std::size_t used = run_on_a_stack_of(stack, evaluate);
        ASSERT_LE(used, small - reserve);
        EXPECT_GT(bytes_in_use(context), before + 1000 * centres) << "it did not prepare itself";
    }
}

// The variants of a fit: solvers, kernels, cleaning, choice of centres, regularization.
std::vector<std::pair<const char*, hrbfnpr_fit_desc>> fits(const scenes::Samples& samples) {
    const hrbfnpr_fit_desc plain = fit_desc(samples);
    std::vector<std::pair<const char*, hrbfnpr_fit_desc>> all;
    const auto add = [&](const char* name, const auto& change) {
        all.emplace_back(name, plain);
        change(all.back().second);
    };
    add("direct", [](auto& desc) { desc.solver = HRBFNPR_SOLVER_DIRECT; });
    add("direct, pivoted LU", [](auto& desc) {
        desc.solver = HRBFNPR_SOLVER_DIRECT;
        desc.polynomial_degree = -1;
    });
    add("direct, Gaussian", [](auto& desc) {
        desc.solver = HRBFNPR_SOLVER_DIRECT;
        desc.kernel = HRBFNPR_KERNEL_GAUSSIAN;
    });
    add("iterative", [](auto& desc) { desc.solver = HRBFNPR_SOLVER_ITERATIVE; });
    add("iterative, Wendland", [](auto& desc) {
        desc.solver = HRBFNPR_SOLVER_ITERATIVE;
        desc.kernel = HRBFNPR_KERNEL_WENDLAND_C2;
        desc.polynomial_degree = 3;
    });
    add("chosen centres", [](auto& desc) {
        desc.tolerance = 1e-3;
        desc.maximum_centres = 200;
        desc.outliers = HRBFNPR_REPAIR_DROP;
        desc.flipped_normals = HRBFNPR_REPAIR_REORIENT;
    });
    add("regularization AUTO", [](auto& desc) { desc.regularization_mode = HRBFNPR_REGULARIZATION_AUTO; });
    return all;
}

TEST_P(SmallStacks, DocumentedSizeSufficesForFit) {
    const Context context = make_context(GetParam());
    const scenes::Samples samples = scenes::torus(600);
    for (const auto& [name, desc] : fits(samples)) expect_enough(fit_needs, name, [&] { fit(context, desc); });
    const scenes::Samples many = scenes::torus(5000); // enough samples for iterations that multiply by far fields
    expect_enough(fit_needs, "iterative, far fields", [&] { fit(context, fit_desc(many)); });
}

INSTANTIATE_TEST_SUITE_P(Context, SmallStacks, testing::Values(1, 0),
                         [](const auto& threads) { return threads.param == 1 ? "OneThread" : "AllThreads"; });

// A host's job runner that runs all tasks of a call on one thread with a stack of `*user` bytes.
void run_on_workers(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    run_on_a_stack_of(*static_cast<const std::size_t*>(user), [=] {
        for (std::int64_t i = 0; i < count; ++i) task(task_context, i);
    });
}

TEST(SmallStacksOfWorkers, SufficeForEverythingExceptFit) {
    std::size_t stack = fit_needs;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 4;
    desc.run_tasks = run_on_workers;
    desc.run_tasks_user = &stack;
    const Calls calls(make_context(desc));
    stack = small;
    EXPECT_EQ(calls.everything(), everything(make_context(1)));
}

} // namespace
} // namespace host_test::stack_test

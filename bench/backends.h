// SPDX-License-Identifier: MIT
// Contexts for each thread backend: the library's own pool, OpenMP, and task libraries through `run_tasks`.
#pragma once

#include "calls.h"

#include <memory>
#include <string>
#include <thread>
#include <vector>

#if defined(HRBFNPR_BENCH_TBB)
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif
#if defined(HRBFNPR_BENCH_TASKFLOW)
#include <taskflow/algorithm/for_each.hpp>
#include <taskflow/taskflow.hpp>
#endif

namespace bench {

struct Backend {
    std::string name;
    std::uint32_t number = HRBFNPR_THREAD_BACKEND_AUTO;
    hrbfnpr_run_tasks_fn run_tasks = nullptr;
    std::shared_ptr<void> user; // the user pointer of run_tasks, kept alive by this struct
};

#if defined(HRBFNPR_BENCH_TBB)
inline void run_by_tbb(void* /*user*/, hrbfnpr_task_fn task, void* context, std::int64_t count) {
    tbb::parallel_for(
        tbb::blocked_range<std::int64_t>(0, count, 1),
        [=](const tbb::blocked_range<std::int64_t>& range) {
            for (std::int64_t i = range.begin(); i < range.end(); ++i) task(context, i);
        },
        tbb::simple_partitioner());
}
#endif

#if defined(HRBFNPR_BENCH_TASKFLOW)
inline void run_by_taskflow(void* user, hrbfnpr_task_fn task, void* context, std::int64_t count) {
    tf::Taskflow flow;
    flow.for_each_index(
        std::int64_t{0}, count, std::int64_t{1}, [=](std::int64_t i) { task(context, i); }, tf::DynamicPartitioner(1));
    static_cast<tf::Executor*>(user)->run(flow).wait();
}
#endif

// Returns all backends of this build.
[[nodiscard]] inline std::vector<Backend> backends() {
    std::vector<Backend> all = {{"pool", HRBFNPR_THREAD_BACKEND_POOL, nullptr, nullptr},
                                {"OpenMP", HRBFNPR_THREAD_BACKEND_OPENMP, nullptr, nullptr}};
#if defined(HRBFNPR_BENCH_TBB)
    all.push_back({"oneTBB", HRBFNPR_THREAD_BACKEND_AUTO, run_by_tbb, nullptr});
#endif
#if defined(HRBFNPR_BENCH_TASKFLOW)
    all.push_back({"Taskflow", HRBFNPR_THREAD_BACKEND_AUTO, run_by_taskflow,
                   std::make_shared<tf::Executor>(std::thread::hardware_concurrency())});
#endif
    all.push_back({"serial", HRBFNPR_THREAD_BACKEND_SERIAL, nullptr, nullptr});
    return all;
}

[[nodiscard]] inline scenes::Context make_context(const Backend& backend) {
    scenes::Check check;
    hrbfnpr_context_desc desc;
    check(hrbfnpr_context_desc_init(&desc, sizeof desc));
    desc.thread_backend = backend.number;
    desc.run_tasks = backend.run_tasks;
    desc.run_tasks_user = backend.user.get();
    hrbfnpr_context* context = nullptr;
    check(hrbfnpr_context_create(&desc, &context, check.error()));
    return scenes::Context(context);
}

} // namespace bench

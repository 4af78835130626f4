#include "shapes.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::kernel::Kind;
using namespace test;

namespace {

void expect_same_bits(const fit::FitResult& a, const fit::FitResult& b, const std::string& what) {
    const auto same = [&](const base::Array<double>& x, const base::Array<double>& y) {
        ASSERT_EQ(x.size(), y.size()) << what;
        if (x.empty()) return;
        EXPECT_EQ(std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(double)), 0) << what;
    };
    same(a.data.alpha, b.data.alpha);
    same(a.data.beta.x, b.data.beta.x);
    same(a.data.beta.y, b.data.beta.y);
    same(a.data.beta.z, b.data.beta.z);
    same(a.data.polynomial, b.data.polynomial);
    EXPECT_EQ(a.data.spacing, b.data.spacing) << what;
    EXPECT_EQ(a.report.condition_estimate, b.report.condition_estimate) << what;
    EXPECT_EQ(a.report.solver_residual, b.report.solver_residual) << what;
    EXPECT_EQ(a.report.gradient_residual_rms, b.report.gradient_residual_rms) << what;
}

base::Runtime with_threads(int threads) {
    return {nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr), base::InstructionSet::automatic,
            nullptr, nullptr};
}

TEST(Robustness, SameBitsForAnyNumberOfThreads) {
    const Cloud cloud = bumpy(130);
    for (const Kind kind : {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2}) {
        for (const std::int32_t degree : {-1, 1}) { // r^3 without a polynomial goes by LU
            const base::Runtime serial = with_threads(1);
            const fit::FitResult expected = fit::fit(serial, input(cloud, kind, degree), {});
            for (const int threads : {2, 3, 7}) {
                const base::Runtime runtime = with_threads(threads);
                expect_same_bits(expected, fit::fit(runtime, input(cloud, kind, degree), {}),
                                 std::string(hrbfnpr::kernel::name(kind)) + std::to_string(threads));
            }
        }
    }
}

TEST(Robustness, RunsOnAHostsTasks) {
    const Cloud cloud = bumpy(100);
    std::atomic<std::int64_t> tasks{0};
    const auto run = [](void* user, base::TaskFn task, void* context, std::int64_t count) {
        *static_cast<std::atomic<std::int64_t>*>(user) += count;
        for (std::int64_t i = count - 1; i >= 0; --i) task(context, i);
    };
    const base::Runtime hosted(nullptr, nullptr, nullptr, base::Parallel(4, run, &tasks),
                               base::InstructionSet::automatic, nullptr, nullptr);
    const base::Runtime serial = with_threads(1);
    expect_same_bits(fit::fit(serial, input(cloud), {}), fit::fit(hosted, input(cloud), {}), "tasks");
    EXPECT_GT(tasks.load(), 10);
}

struct Watcher {
    base::Operation operation;
    double cancel_at = 2.0;
    double last = -1.0;
    int calls = 0;
    bool fell = false;

    explicit Watcher(double at) : cancel_at(at) {
        operation.set_callback(
            [](void* user, double progress) -> std::int32_t {
                auto& watcher = *static_cast<Watcher*>(user);
                ++watcher.calls;
                watcher.fell = watcher.fell || progress < watcher.last;
                watcher.last = progress;
                return progress >= watcher.cancel_at ? 1 : 0;
            },
            this);
        operation.begin();
    }
};

TEST(Robustness, ReportsProgressUpToOne) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(130);
    for (const std::int32_t degree : {-1, 1}) {
        Watcher watcher(2.0);
        static_cast<void>(
            fit::fit(runtime, input(cloud, Kind::triharmonic, degree), base::Progress(&watcher.operation)));
        EXPECT_GT(watcher.calls, 10);
        EXPECT_FALSE(watcher.fell);
        EXPECT_DOUBLE_EQ(watcher.last, 1.0);
    }
}

TEST(Robustness, StopsWhereverItIsCancelled) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(130);
    for (const std::int32_t degree : {-1, 1}) {
        for (const double cancel_at : {0.0, 0.01, 0.03, 0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 0.94, 0.97}) {
            Watcher watcher(cancel_at);
            try {
                static_cast<void>(
                    fit::fit(runtime, input(cloud, Kind::triharmonic, degree), base::Progress(&watcher.operation)));
                ADD_FAILURE() << "not cancelled at " << cancel_at;
            } catch (const hrbfnpr::Error& error) {
                EXPECT_EQ(error.status(), Status::cancelled);
            }
            EXPECT_EQ(runtime.memory.bytes_now(), 0);
        }
    }
}

// An allocator that fails once, at the k-th call.
struct Budget {
    std::atomic<std::int64_t> calls{0};
    std::int64_t failing = -1;
    std::atomic<std::int64_t> alive{0};

    static void* allocate(void* user, std::uint64_t size, std::uint64_t alignment) {
        auto& budget = *static_cast<Budget*>(user);
        if (budget.calls.fetch_add(1) == budget.failing) return nullptr;
        budget.alive.fetch_add(1);
        return ::operator new (size, std::align_val_t{alignment}, std::nothrow);
    }
    static void deallocate(void* user, void* memory, std::uint64_t /*size*/, std::uint64_t alignment) {
        static_cast<Budget*>(user)->alive.fetch_sub(1);
        ::operator delete (memory, std::align_val_t{alignment});
    }
};

TEST(Robustness, EveryAllocationMayFail) {
    Cloud cloud = bumpy(40);
    cloud.add(cloud.point(2), cloud.normal(2));
    for (const std::int32_t degree : {-1, 1}) {
        std::int64_t failing = 0;
        for (bool done = false; !done; ++failing) {
            Budget budget;
            budget.failing = failing;
            {
                const base::Runtime runtime(Budget::allocate, Budget::deallocate, &budget,
                                            base::Parallel(2, nullptr, nullptr), base::InstructionSet::automatic,
                                            nullptr, nullptr);
                try {
                    const fit::FitResult result = fit::fit(runtime, input(cloud, Kind::triharmonic, degree), {});
                    done = true;
                    EXPECT_LE(result.report.gradient_residual_max, 1e-8);
                } catch (const hrbfnpr::Error& error) {
                    EXPECT_EQ(error.status(), Status::out_of_memory) << failing << ": " << error.what();
                }
                EXPECT_EQ(runtime.memory.bytes_now(), 0) << failing;
            }
            EXPECT_EQ(budget.alive.load(), 0) << failing;
            ASSERT_LT(failing, 1000);
        }
        EXPECT_GT(failing, 20);
    }
}

TEST(Robustness, AMatrixThatDoesNotFitIsNamedWithItsBytes) {
    const auto stingy = [](void*, std::uint64_t size, std::uint64_t alignment) -> void* {
        if (size > 1000000) return nullptr;
        return ::operator new (size, std::align_val_t{alignment}, std::nothrow);
    };
    const base::Runtime runtime(
        stingy,
        [](void*, void* memory, std::uint64_t, std::uint64_t alignment) {
            ::operator delete (memory, std::align_val_t{alignment});
        },
        nullptr, base::Parallel(), base::InstructionSet::automatic, nullptr, nullptr);
    const Cloud cloud = sphere(200);
    fit::FitInput dense = input(cloud);
    dense.solver = fit::SolverKind::direct;
    try {
        static_cast<void>(fit::fit(runtime, dense, {}));
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), Status::out_of_memory);
        // 796 rows in 7 tiles of 128
        EXPECT_NE(std::string(error.what()).find("200 samples needs 3670016 bytes"), std::string::npos) << error.what();
    }
}

TEST(Robustness, ASingularSystemSaysWhatToDo) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(60);
    fit::FitInput flat = input(cloud, Kind::gaussian, 1);
    flat.kernel_radius = 1e6; // all rows alike
    try {
        static_cast<void>(fit::fit(runtime, flat, {}));
        FAIL() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), Status::singular_system);
        EXPECT_NE(std::string(error.what()).find("smaller kernel_radius"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("regularization"), std::string::npos) << error.what();
    }
    flat.regularization = 1e-3; // and it is solvable again
    EXPECT_NO_THROW(static_cast<void>(fit::fit(runtime, flat, {})));
}

TEST(Robustness, NoFitIsReturnedThatDoesNotInterpolate) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(80);
    int good = 0;
    int refused = 0;
    for (double radius = 0.4; radius < 6.0; radius *= 1.15) { // up to far beyond what double precision can do
        fit::FitInput wide = input(cloud, Kind::gaussian, 1);
        wide.kernel_radius = radius;
        wide.refinement_steps = 0;
        try {
            const fit::FitResult result = fit::fit(runtime, wide, {});
            EXPECT_LE(result.report.solver_residual, 1e-6) << radius;
            EXPECT_LE(result.report.gradient_residual_max, 1e-5) << radius;
            ++good;
        } catch (const hrbfnpr::Error& error) {
            EXPECT_EQ(error.status(), Status::singular_system) << radius;
            ++refused;
        }
    }
    EXPECT_GT(good, 3);
    EXPECT_GT(refused, 3);
}

TEST(Robustness, RefinementLowersTheResidual) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(120);
    fit::FitInput refined = input(cloud, Kind::gaussian, 1);
    refined.kernel_radius = 0.54; // condition 1e15
    refined.refinement_steps = 0;
    const fit::FitReport once = fit::fit(runtime, refined, {}).report;
    refined.refinement_steps = 5;
    const fit::FitReport better = fit::fit(runtime, refined, {}).report;
    EXPECT_EQ(once.iterations, 0);
    EXPECT_GE(better.iterations, 1);
    EXPECT_LE(better.iterations, 5);
    EXPECT_LT(better.solver_residual, 0.5 * once.solver_residual);
}

TEST(Robustness, SamplesMayBeVeryClose) {
    const base::Runtime runtime;
    for (const Kind kind : {Kind::triharmonic, Kind::wendland_c2}) {
        for (const double gap : {1e-3, 1e-5, 1e-7}) {
            Cloud cloud = sphere(50);
            const glm::dvec3 near = glm::normalize(cloud.point(7) + glm::dvec3(gap, 0, 0));
            cloud.add(near, near);
            const fit::FitResult result = fit::fit(runtime, input(cloud, kind, 1), {});
            EXPECT_LE(result.report.gradient_residual_max, 1e-8) << gap;
            const Cloud truth = sphere(200);
            for (std::int64_t i = 0; i < truth.count(); ++i)
                EXPECT_LT(std::abs(distance(result.data, truth.point(i))), 2e-3) << gap;
        }
    }
}

} // namespace

// Errors, cancelling and threads of the iterative solver.
#include "base/status.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <new>
#include <string>

namespace base = hrbfnpr::base;
namespace fit = hrbfnpr::fit;
using hrbfnpr::Status;
using hrbfnpr::kernel::Kind;
using namespace test;

namespace {

fit::FitInput iterative(const Cloud& cloud, Kind kind = Kind::triharmonic, std::int32_t degree = 1) {
    fit::FitInput result = input(cloud, kind, degree);
    result.solver = fit::SolverKind::iterative;
    if (kind == Kind::gaussian) result.kernel_radius = 0.1;
    if (kind == Kind::wendland_c2) result.kernel_radius = 0.5;
    return result;
}

void expect_error(const fit::FitInput& chosen, Status status, const std::string& part) {
    const base::Runtime runtime;
    try {
        static_cast<void>(fit::fit(runtime, chosen, {}));
        ADD_FAILURE() << "no error";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), status) << error.what();
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_EQ(runtime.memory.bytes_now(), 0);
}

TEST(IterativeErrors, TheTriharmonicKernelNeedsALinearPolynomial) {
    const Cloud cloud = bumpy(250);
    for (const std::int32_t degree : {-1, 0})
        expect_error(iterative(cloud, Kind::triharmonic, degree), Status::invalid_argument, "polynomial_degree >= 1");
}

TEST(IterativeErrors, SamplesThatDoNotDetermineThePolynomialAreNamed) {
    expect_error(iterative(bumpy(4), Kind::triharmonic, 3), Status::invalid_argument, "lower polynomial_degree");
}

TEST(IterativeErrors, WithoutConvergenceTheResidualIsNamed) {
    const Cloud cloud = bumpy(400);
    fit::FitInput chosen = iterative(cloud);
    chosen.iteration_limit = 2;
    expect_error(chosen, Status::not_converged, "relative residual of ");
    expect_error(chosen, Status::not_converged, " in 2 iterations, not 1.0e-10");
}

TEST(IterativeErrors, AsManyNeighboursAsThereMayBe) {
    const Cloud cloud = bumpy(250);
    fit::FitInput chosen = iterative(cloud);
    const base::Runtime runtime;
    chosen.preconditioner_neighbours = 48;
    EXPECT_LE(fit::fit(runtime, chosen, {}).report.gradient_residual_max, 1e-6);
    chosen.preconditioner_neighbours = 49;
    expect_error(chosen, Status::invalid_argument, "preconditioner_neighbours is 49");
}

base::Runtime with_threads(int threads) {
    return {nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr), base::InstructionSet::automatic,
            nullptr, nullptr};
}

void expect_same_bits(const fit::FitResult& a, const fit::FitResult& b, const std::string& what) {
    const auto same = [&](const base::Array<double>& x, const base::Array<double>& y) {
        ASSERT_EQ(x.size(), y.size()) << what;
        EXPECT_EQ(std::memcmp(x.data(), y.data(), static_cast<std::size_t>(x.size()) * sizeof(double)), 0) << what;
    };
    same(a.data.alpha, b.data.alpha);
    same(a.data.beta.x, b.data.beta.x);
    same(a.data.beta.y, b.data.beta.y);
    same(a.data.beta.z, b.data.beta.z);
    same(a.data.polynomial, b.data.polynomial);
    EXPECT_EQ(a.report.iterations, b.report.iterations) << what;
    EXPECT_EQ(a.report.condition_estimate, b.report.condition_estimate) << what;
    EXPECT_EQ(a.report.solver_residual, b.report.solver_residual) << what;
    EXPECT_EQ(a.report.gradient_residual_rms, b.report.gradient_residual_rms) << what;
}

void expect_same_bits_for_threads(const fit::FitInput& chosen, std::initializer_list<int> counts) {
    const base::Runtime serial = with_threads(1);
    const fit::FitResult expected = fit::fit(serial, chosen, {});
    for (const int threads : counts) {
        const base::Runtime runtime = with_threads(threads);
        expect_same_bits(expected, fit::fit(runtime, chosen, {}),
                         hrbfnpr::kernel::name(chosen.kernel) + std::to_string(threads));
    }
}

TEST(IterativeRobustness, SameBitsForAnyNumberOfThreads) {
    const Cloud cloud = bumpy(600);
    for (const Kind kind : {Kind::triharmonic, Kind::gaussian, Kind::wendland_c2})
        expect_same_bits_for_threads(iterative(cloud, kind), {2, 3, 7});
}

// Vectors of more than one piece.
TEST(IterativeRobustness, SameBitsForManySamples) {
    const Cloud cloud = bumpy(4500);
    fit::FitInput chosen = iterative(cloud);
    chosen.solver_tolerance = 0.1;
    chosen.preconditioner_neighbours = 8;
    expect_same_bits_for_threads(chosen, {3});
}

struct Watcher {
    base::Operation operation;
    double cancel_at;
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

TEST(IterativeRobustness, ReportsProgressUpToOne) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(500);
    Watcher watcher(2.0);
    static_cast<void>(fit::fit(runtime, iterative(cloud), base::Progress(&watcher.operation)));
    EXPECT_GE(watcher.calls, 18); // eleven of them from the iterations
    EXPECT_FALSE(watcher.fell);
    EXPECT_DOUBLE_EQ(watcher.last, 1.0);
}

TEST(IterativeRobustness, StopsWhereverItIsCancelled) {
    const base::Runtime runtime;
    const Cloud cloud = bumpy(500);
    for (double cancel_at = 0.0; cancel_at < 0.9; cancel_at += 0.04) {
        Watcher watcher(cancel_at);
        try {
            static_cast<void>(fit::fit(runtime, iterative(cloud), base::Progress(&watcher.operation)));
            ADD_FAILURE() << "not cancelled at " << cancel_at;
        } catch (const hrbfnpr::Error& error) {
            EXPECT_EQ(error.status(), Status::cancelled);
        }
        EXPECT_EQ(runtime.memory.bytes_now(), 0);
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

TEST(IterativeRobustness, EveryAllocationMayFail) {
    const Cloud cloud = bumpy(60);
    fit::FitInput chosen = iterative(cloud);
    chosen.preconditioner_neighbours = 8;
    std::int64_t failing = 0;
    for (bool done = false; !done; ++failing) {
        Budget budget;
        budget.failing = failing;
        {
            const base::Runtime runtime(Budget::allocate, Budget::deallocate, &budget,
                                        base::Parallel(2, nullptr, nullptr), base::InstructionSet::automatic, nullptr,
                                        nullptr);
            try {
                static_cast<void>(fit::fit(runtime, chosen, {}));
                done = true;
            } catch (const hrbfnpr::Error& error) {
                EXPECT_EQ(error.status(), Status::out_of_memory) << failing << ": " << error.what();
            }
            EXPECT_EQ(runtime.memory.bytes_now(), 0) << failing;
        }
        EXPECT_EQ(budget.alive.load(), 0) << failing;
        ASSERT_LT(failing, 1000);
    }
    EXPECT_GT(failing, 40);
}

} // namespace

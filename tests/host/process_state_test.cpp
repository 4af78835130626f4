// SPDX-License-Identifier: MIT
// Tests that the state of the host's process is unchanged afterwards: signals, floating-point state, streams.
#include "host/calls.h"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <unistd.h>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace host_test::process_state_test {
namespace {

struct Signals {
    struct Handler {
        void* function;
        int flags;
        bool operator==(const Handler&) const = default;
    };
    Signals() {
        for (int number = 1; number < NSIG; ++number) {
            struct sigaction action;
            std::memset(&action, 0, sizeof action);
            sigaction(number, nullptr, &action); // fails for the two signals that the C library reserves
            handler.push_back({reinterpret_cast<void*>(action.sa_sigaction), action.sa_flags});
        }
        sigset_t set;
        pthread_sigmask(SIG_SETMASK, nullptr, &set);
        for (int number = 1; number < NSIG; ++number) blocked.push_back(sigismember(&set, number));
        sigaltstack(nullptr, &stack);
    }
    std::vector<Handler> handler;
    std::vector<int> blocked;
    stack_t stack{};
};

TEST(ProcessState, SignalsAreNotTouched) {
    sigset_t some;
    sigemptyset(&some);
    sigaddset(&some, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &some, nullptr);
    struct sigaction old;
    struct sigaction action;
    std::memset(&action, 0, sizeof action);
    action.sa_handler = [](int) {};
    sigaction(SIGFPE, &action, &old);
    const Signals before;
    everything(make_context(0));
    const Signals after;
    EXPECT_EQ(after.handler, before.handler);
    EXPECT_EQ(after.blocked, before.blocked);
    EXPECT_EQ(after.stack.ss_sp, before.stack.ss_sp);
    EXPECT_EQ(after.stack.ss_flags, before.stack.ss_flags);
    sigaction(SIGFPE, &old, nullptr);
    pthread_sigmask(SIG_UNBLOCK, &some, nullptr);
}

#if defined(__x86_64__)
struct Words {
    unsigned mxcsr = _mm_getcsr();
    std::uint16_t x87 = 0;
    Words() { __asm__ volatile("fnstcw %0" : "=m"(x87)); }
    bool operator==(const Words&) const = default;
};

// The sticky flags stay unchanged, too: the test's own computations raise none.
TEST(ProcessState, FloatingPointStateIsNotTouched) {
    const scenes::Samples samples = scenes::torus(192);
    const hrbfnpr_fit_desc desc = fit_desc(samples);
    const Context context = make_context(0);
    const Scene scene(make_context(0));
    const Calls calls(make_context(0));
    const Bytes wanted = calls.everything();
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        fenv_t ours;
        std::feholdexcept(&ours);
        std::fesetround(mode);
        _mm_setcsr(_mm_getcsr() | 0x8040U); // flush to zero, subnormals are zero
        const Words before;
        const PointSet marks = generate(context, fit(context, desc));
        const Bytes picture = draw(context, marks);
        const Words after;
        const Bytes same = draw(scene.context, scene.marks);
        std::fesetenv(&ours);
        EXPECT_TRUE(after == before) << mode << ": " << std::hex << after.mxcsr << " was " << before.mxcsr << ", "
                                     << after.x87 << " was " << before.x87;
        EXPECT_TRUE(picture == same);
    }
    EXPECT_TRUE(calls.everything() == wanted);
}
#endif

// Captures the output to a file descriptor during the object's lifetime.
class Captured {
public:
    explicit Captured(int descriptor) : descriptor_(descriptor), file_(std::tmpfile()) {
        std::fflush(nullptr);
        kept_ = dup(descriptor);
        dup2(fileno(file_), descriptor);
    }
    Captured(const Captured&) = delete;
    Captured& operator=(const Captured&) = delete;
    ~Captured() {
        restore();
        std::fclose(file_);
    }
    std::string text() {
        restore();
        std::rewind(file_);
        std::string all;
        for (int c = 0; (c = std::fgetc(file_)) != EOF;) all.push_back(static_cast<char>(c));
        return all;
    }

private:
    void restore() {
        if (kept_ < 0) return;
        std::fflush(nullptr);
        dup2(kept_, descriptor_);
        close(kept_);
        kept_ = -1;
    }
    int descriptor_;
    int kept_ = -1;
    std::FILE* file_;
};

// Makes calls that fail, and calls that warn.
void go_wrong(const Context& context) {
    auto error = made(hrbfnpr_error_init);
    scenes::Samples samples = scenes::torus(60);
    for (double& number : samples.normals) number *= 3.0; // a warning in the log
    fit(context, fit_desc(samples));
    hrbfnpr_model* model = nullptr;
    const auto fails = [&](const hrbfnpr_fit_desc& desc, hrbfnpr_operation* operation = nullptr) {
        EXPECT_NE(hrbfnpr_model_fit(context.get(), &desc, operation, &model, &error), HRBFNPR_STATUS_OK);
        EXPECT_STRNE(error.message, "");
    };
    hrbfnpr_operation* cancelled = nullptr;
    ASSERT_EQ(hrbfnpr_operation_create(context.get(), &cancelled, &error), HRBFNPR_STATUS_OK);
    hrbfnpr_operation_cancel(cancelled);
    fails(fit_desc(samples), cancelled);
    hrbfnpr_operation_release(cancelled);
    auto slow = fit_desc(samples);
    slow.solver = HRBFNPR_SOLVER_ITERATIVE;
    slow.iteration_limit = 1;
    slow.solver_tolerance = 1e-14;
    hrbfnpr_model_fit(context.get(), &slow, nullptr, &model, &error);
    hrbfnpr_model_release(model);
    samples.points[3] = samples.points[0] * 0.0 / 0.0;
    fails(fit_desc(samples));
    const char damaged[] = "HRBF, but not really";
    EXPECT_NE(hrbfnpr_model_load_memory(context.get(), damaged, sizeof damaged, &model, &error), HRBFNPR_STATUS_OK);
}

TEST(ProcessState, NothingIsPrinted) {
    Captured output(STDOUT_FILENO);
    Captured errors(STDERR_FILENO);
    everything(make_context(0));
    go_wrong(make_context(0));
    EXPECT_EQ(errors.text(), "");
    EXPECT_EQ(output.text(), "");
}

} // namespace
} // namespace host_test::process_state_test

// SPDX-License-Identifier: MIT
#include "host/small_stack.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <pthread.h>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace host_test {
namespace {

constexpr std::uint8_t paint = 0xA5;

class Stack {
public:
    explicit Stack(std::size_t size)
        : guard_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))), size_(size),
          memory_(mmap(nullptr, guard_ + size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
        if (memory_ == MAP_FAILED || mprotect(memory_, guard_, PROT_NONE) != 0) throw std::runtime_error("no stack");
        std::fill_n(lowest(), size_, paint);
    }
    Stack(const Stack&) = delete;
    Stack& operator=(const Stack&) = delete;
    ~Stack() { munmap(memory_, guard_ + size_); }

    [[nodiscard]] std::uint8_t* lowest() const { return static_cast<std::uint8_t*>(memory_) + guard_; }
    [[nodiscard]] std::size_t used() const {
        const std::uint8_t* end = lowest() + size_;
        const std::uint8_t* touched = std::find_if(lowest(), lowest() + size_, [](auto byte) { return byte != paint; });
        return static_cast<std::size_t>(end - touched);
    }

private:
    std::size_t guard_;
    std::size_t size_;
    void* memory_;
};

struct Job {
    const std::function<void()>& work;
    std::exception_ptr error;
};

void* run(void* argument) {
    auto& job = *static_cast<Job*>(argument);
    try {
        job.work();
    } catch (...) {
        job.error = std::current_exception();
    }
    return nullptr;
}

} // namespace

std::size_t run_on_a_stack_of(std::size_t size, const std::function<void()>& work) {
    const Stack stack(size);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    int failed = pthread_attr_setstack(&attributes, stack.lowest(), size);
    Job job{work, nullptr};
    pthread_t thread;
    if (failed == 0) failed = pthread_create(&thread, &attributes, run, &job);
    pthread_attr_destroy(&attributes);
    if (failed != 0) throw std::runtime_error("no thread with so small a stack");
    pthread_join(thread, nullptr);
    if (job.error) std::rethrow_exception(job.error);
    return stack.used();
}

} // namespace host_test

// SPDX-License-Identifier: MIT
// The memory, threads, instruction set and log of the context, which every stage receives.
#pragma once

#include "base/format.h"
#include "base/instruction_set.h"
#include "base/memory.h"
#include "base/parallel.h"

#include <cstdint>
#include <utility>

namespace hrbfnpr::base {

enum class LogLevel : std::int32_t { debug = 0, info = 1, warning = 2 };
using LogFn = void (*)(void* user, std::int32_t level, const char* message);

class Runtime {
    Memory own_memory_; // declared first, because `memory` may refer to it

public:
    Runtime() = default; // uses all threads and has no log
    Runtime(AllocateFn allocate, DeallocateFn deallocate, void* allocator_user, Parallel threads,
            InstructionSet highest, LogFn log_function, void* log_user, LogLevel least = LogLevel::debug) noexcept
        : own_memory_(allocate, deallocate, allocator_user), parallel(std::move(threads)),
          instruction_set(choose_instruction_set(highest)), log_(log_function), log_user_(log_user),
          least_level_(least) {}
    // Uses the memory and log of `host`, which must outlive this object, and the given threads.
    Runtime(const Runtime& host, Parallel threads) noexcept
        : memory(host.memory), parallel(std::move(threads)), instruction_set(host.instruction_set), log_(host.log_),
          log_user_(host.log_user_), least_level_(host.least_level_) {}
    // Returns the runtime of a task that runs beside others: the memory of `host`, the calling thread alone, and no
    // log.
    [[nodiscard]] static Runtime for_task(const Runtime& host) noexcept { return {host.memory, host.instruction_set}; }
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;
    ~Runtime() = default;

    // Writes a log message. Call it only on the thread that entered the library. Messages below the log's least level
    // are not formatted.
    HRBFNPR_PRINTF_LIKE(3, 4) void log(LogLevel level, const char* format, ...) const noexcept;

    Memory& memory{own_memory_};
    Parallel parallel{0, nullptr, nullptr};
    InstructionSet instruction_set = choose_instruction_set(InstructionSet::automatic);

private:
    Runtime(Memory& of_host, InstructionSet set) noexcept : memory(of_host), parallel(), instruction_set(set) {}

    LogFn log_ = nullptr;
    void* log_user_ = nullptr;
    LogLevel least_level_ = LogLevel::debug;
};

} // namespace hrbfnpr::base

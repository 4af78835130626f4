/* SPDX-License-Identifier: MIT
 *
 * Makes exceptions work in the build with threads.  In Emscripten with Clang 14, the compiler and libunwind disagree:
 * landing pads use one __wasm_lpad_context for all threads, but libunwind has one for each thread.  Every exception then
 * matches `catch (...)` only.  So CMakeLists.txt compiles the file of libunwind again, with one context for all threads,
 * and the functions below let one thread at a time be between throw and catch.  Destructors that run in between must not
 * wait for a thread that throws.
 */
#include <pthread.h>
#include <stdbool.h>

static pthread_mutex_t unwinding = PTHREAD_MUTEX_INITIALIZER;
static _Thread_local bool is_unwinding = false;

int __real__Unwind_RaiseException(void* exception);
int __wrap__Unwind_RaiseException(void* exception);
void* __real___cxa_begin_catch(void* exception);
void* __wrap___cxa_begin_catch(void* exception);

int __wrap__Unwind_RaiseException(void* exception) {
    if (!is_unwinding) pthread_mutex_lock(&unwinding);
    is_unwinding = true;
    return __real__Unwind_RaiseException(exception);
}

void* __wrap___cxa_begin_catch(void* exception) {
    if (is_unwinding) {
        is_unwinding = false;
        pthread_mutex_unlock(&unwinding);
    }
    return __real___cxa_begin_catch(exception);
}

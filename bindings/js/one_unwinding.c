/* SPDX-License-Identifier: MIT
 *
 * Exceptions in the build with threads, where Emscripten's compiler and its libunwind disagree (Clang 14): landing pads
 * keep their notes in __wasm_lpad_context as one for all threads, libunwind has one for each.  Every exception then
 * matches `catch (...)` only.  So libunwind's file is compiled anew with one for all, and one thread at a time is
 * between throw and catch: destructors on that way must not wait for a thread that throws.
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

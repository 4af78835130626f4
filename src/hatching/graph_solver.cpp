// SPDX-License-Identifier: MIT
#include "hatching/graph_solver.h"

namespace hrbfnpr::hatching {

double inner(const base::Runtime& runtime, const base::Array<Complex>& a, const base::Array<Complex>& b) {
    base::Array<double> part(runtime.memory, (a.size() + samples_a_task - 1) / samples_a_task);
    runtime.parallel.for_chunks(a.size(), samples_a_task, [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t i = begin; i < end; ++i) sum += a[i].real() * b[i].real() + a[i].imag() * b[i].imag();
        part[begin / samples_a_task] = sum;
    });
    double all = 0.0;
    for (const double sum : part) all += sum;
    return all;
}

} // namespace hrbfnpr::hatching

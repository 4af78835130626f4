// SPDX-License-Identifier: MIT
// LAPACK as a baseline, loaded at run time if the machine has it (libopenblas0 or liblapack3).
#pragma once

#include "timing.h"

#include <dlfcn.h>

#include <cstdint>
#include <vector>

namespace bench {

class Lapack {
public:
    Lapack() {
        for (const char* name : {"libopenblas.so.0", "liblapack.so.3"}) {
            void* const library = dlopen(name, RTLD_NOW);
            if (library == nullptr) continue;
            name_ = name;
            potrf_ = reinterpret_cast<Potrf>(dlsym(library, "dpotrf_"));
            sysv_ = reinterpret_cast<Sysv>(dlsym(library, "dsysv_"));
            return;
        }
    }

    [[nodiscard]] bool found() const noexcept { return potrf_ != nullptr && sysv_ != nullptr; }
    [[nodiscard]] const char* name() const noexcept { return name_; }

    // Returns the seconds of a Cholesky factorisation of a matrix of this size; its entries do not matter.
    [[nodiscard]] double cholesky_seconds(int size) const {
        std::vector<double> matrix = dominant(size);
        int status = 0;
        return seconds([&] { potrf_("L", &size, matrix.data(), &size, &status, 1); });
    }

    // Returns the seconds of the solution of a symmetric indefinite system.
    [[nodiscard]] double indefinite_seconds(int size) const {
        std::vector<double> matrix = dominant(size);
        std::vector<double> x(static_cast<std::size_t>(size), 1.0);
        std::vector<int> pivot(static_cast<std::size_t>(size));
        std::vector<double> work(64 * static_cast<std::size_t>(size));
        const int columns = 1;
        const int room = 64 * size;
        int status = 0;
        return seconds([&] {
            sysv_("L", &size, &columns, matrix.data(), &size, pivot.data(), x.data(), &size, work.data(), &room,
                  &status, 1);
        });
    }

private:
    using Potrf = void (*)(const char*, const int*, double*, const int*, int*, std::size_t);
    using Sysv = void (*)(const char*, const int*, const int*, double*, const int*, int*, double*, const int*, double*,
                          const int*, int*, std::size_t);

    [[nodiscard]] static std::vector<double> dominant(int size) {
        const auto n = static_cast<std::size_t>(size);
        std::vector<double> matrix(n * n);
        for (std::size_t j = 0; j < n; ++j)
            for (std::size_t i = 0; i < n; ++i)
                matrix[j * n + i] = i == j ? static_cast<double>(n) : static_cast<double>((i * j) % 7) * 0.1;
        return matrix;
    }

    const char* name_ = "";
    Potrf potrf_ = nullptr;
    Sysv sysv_ = nullptr;
};

} // namespace bench

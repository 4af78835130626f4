// SPDX-License-Identifier: MIT
#include "mesh/pieces/read_once.h"

#include "base/list.h"
#include "implicit/pieces.h"

namespace hrbfnpr::mesh {
namespace {

using implicit::PiecesData;

struct Program {
    std::int32_t code[2 * ReadOnceTrees::most];
    std::int32_t size;
};

[[nodiscard]] Program of_one(std::int32_t function) noexcept {
    Program program{};
    program.code[program.size++] = function;
    return program;
}

// Both, and the operation on them.
[[nodiscard]] Program joined(const Program& a, const Program& b, std::int32_t operation) noexcept {
    Program program = a;
    for (std::int32_t i = 0; i < b.size; ++i) program.code[program.size++] = b.code[i];
    program.code[program.size++] = operation;
    return program;
}

// The trees over each set of functions (bits of its number), by the operation on their top.
class Lists {
public:
    using Programs = base::Array<Program>;

    explicit Lists(base::Memory& memory) : topped_(memory) {
        for (std::uint32_t set = 0; set < 1U << ReadOnceTrees::most; ++set)
            for (int top = 0; top < 2; ++top) topped_.add(memory);
        for (std::uint32_t set = 1; set < 1U << ReadOnceTrees::most; ++set)
            for (std::uint32_t top = 0; top < 2; ++top) make(set, top);
    }

    // top: 0 larger, 1 smaller.  Of one function: the same for both.
    [[nodiscard]] const Programs& topped(std::uint32_t set, std::uint32_t top) const noexcept {
        return topped_[2 * set + top];
    }

private:
    // Two parts or more: the one with the lowest function is that alone, or a tree with the other top.
    void make(std::uint32_t set, std::uint32_t top) {
        Programs& to = topped_[2 * set + top];
        const std::uint32_t lowest = set & (~set + 1U);
        const std::uint32_t others = set & ~lowest;
        if (others == 0) {
            std::int32_t function = 0;
            while ((set >> static_cast<unsigned>(function)) != 1U) ++function;
            return to.push_back(of_one(function));
        }
        const std::int32_t operation = top == 0 ? PiecesData::larger : PiecesData::smaller;
        for (std::uint32_t with = (others - 1) & others;; with = (with - 1) & others) {
            const std::uint32_t rest = others & ~with;
            for (const Program& part : topped(lowest | with, 1 - top)) {
                // The rest is one part, or several.
                for (const Program& one : topped(rest, 1 - top)) to.push_back(joined(part, one, operation));
                if ((rest & (rest - 1)) == 0) continue;
                for (const Program& several : topped(rest, top)) to.push_back(joined(part, several, operation));
            }
            if (with == 0) return;
        }
    }

    base::List<Programs> topped_;
};

} // namespace

ReadOnceTrees::ReadOnceTrees(base::Memory& memory) : first_(memory), begin_(memory), code_(memory) {
    const Lists lists(memory);
    first_.resize(2); // none of no functions
    for (std::int32_t functions = 1; functions <= most; ++functions) {
        const std::uint32_t all = (1U << static_cast<unsigned>(functions)) - 1U;
        for (std::uint32_t top = 0; top < (functions > 1 ? 2U : 1U); ++top)
            for (const Program& program : lists.topped(all, top)) {
                begin_.push_back(code_.size());
                for (std::int32_t i = 0; i < program.size; ++i) code_.push_back(program.code[i]);
            }
        first_.push_back(begin_.size());
    }
    begin_.push_back(code_.size());
}

std::span<const std::int32_t> ReadOnceTrees::program(std::int32_t functions, std::int64_t tree) const noexcept {
    const std::int64_t at = first_[functions] + tree;
    return code_.span().subspan(static_cast<std::size_t>(begin_[at]),
                                static_cast<std::size_t>(begin_[at + 1] - begin_[at]));
}

} // namespace hrbfnpr::mesh

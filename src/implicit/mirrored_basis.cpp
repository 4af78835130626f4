// SPDX-License-Identifier: MIT
#include "implicit/mirrored_basis.h"

#include "base/assert.h"
#include "implicit/cube_basis.h"
#include "implicit/triharmonic_basis.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace hrbfnpr::implicit {
namespace {

// The nodes of each odd degree n from 3 on. Three digits are a node, and a digit d is the coordinate cos(pi d / n).
// The nodes were chosen from all such points one by one. Each one has the largest product, over the eight parts, of the
// distances of its rows from the rows of the nodes before it. A row consists of the values of orthonormal polynomials.
constexpr std::array<std::string_view, 9> node_table = {
    "000110011101001010100111",
    "000020002200022202220110011101001100010111012210",
    "000002200020220022003300030202033303330332223011320132110001100010023203",
    "000003030300002033303330020200220402024240022333212232400404044440042204420444004324243234342040",
    "000400040004200020002034340403204042420302023230405540054502250025243324432222444524032500245005"
    "050450045504553352535521310225305354153335030300",
    "000500005050003030300045350504042420204540502025405054033230303062620560206202022255525452324243"
    "532235332445605210260065554600240036650613506056662326263006634466646362643346060412630626622430",
    "060600006000400040004020046460604200520052205650065506440404044250025502002630063306023320027270"
    "702302230032203067670706426264642562256625235352523554546465432720207072243324222644444627276456"
    "760607076763723372237074407740746574007700047470703070477035765500050005",
    "007070700050500005000003300030074407740470704047026620260504054450760607067305062602402024240207"
    "430045076670706042802280202028820082506220022650204265625562426752257523253542236654373546737733"
    "056465773377457334574342745807033780303206775087285757538825577580800058080238805482870008854708"
    "850328485085838078508388862883832368283006600060",
    "008800080600060006000400040004048804480408084840680806068064640406605056560072207720607076760020"
    "036603360205520088808880052440404044200802280028023302240609960096920209092002502472247742254425"
    "285527542735683456564368837235873320266448754723475545387662273352327523203232738757025578934785"
    "429484852444079270492907027856702249586909990099790993399939905293932590059975649009969900090925"
    "379793940699390065995395",
};

template <class T>
[[nodiscard]] std::array<base::Array<T>, 8> arrays(base::Memory& memory) {
    using Array = base::Array<T>;
    return {Array(memory), Array(memory), Array(memory), Array(memory),
            Array(memory), Array(memory), Array(memory), Array(memory)};
}

[[nodiscard]] geometry::VecArray nodes_of(base::Memory& memory, int degree) {
    const std::string_view digits = node_table[static_cast<std::size_t>(degree / 2 - 1)];
    geometry::VecArray nodes(memory);
    const auto coordinate = [&](std::size_t at) {
        return std::cos(3.14159265358979323846 * (digits[at] - '0') / degree);
    };
    for (std::size_t at = 0; at < digits.size(); at += 3)
        nodes.push_back({coordinate(at), coordinate(at + 1), coordinate(at + 2)});
    return nodes;
}

// A column of numbers, which are added up in four sums side by side.
[[nodiscard]] double dot(const double* a, const double* b, std::int64_t count) noexcept {
    double sum[4] = {};
    std::int64_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (std::int64_t lane = 0; lane < 4; ++lane) sum[lane] += a[i + lane] * b[i + lane];
    for (; i < count; ++i) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void add_scaled(double factor, const double* from, double* to, std::int64_t count) noexcept {
    for (std::int64_t i = 0; i < count; ++i) to[i] += factor * from[i];
}

// Makes the columns of values orthonormal, and changes the columns of terms in the same way. The second pass removes
// the errors of the first.
void orthonormalise(double* values, std::int64_t points, double* terms, std::int64_t rows, std::int64_t columns) {
    for (std::int64_t k = 0; k < columns; ++k) {
        double* const value = values + k * points;
        double* const term = terms + k * rows;
        for (int pass = 0; pass < 2; ++pass)
            for (std::int64_t j = 0; j < k; ++j) {
                const double share = -dot(value, values + j * points, points);
                add_scaled(share, values + j * points, value, points);
                add_scaled(share, terms + j * rows, term, rows);
            }
        const double scale = 1.0 / std::sqrt(dot(value, value, points));
        for (std::int64_t i = 0; i < points; ++i) value[i] *= scale;
        for (std::int64_t i = 0; i < rows; ++i) term[i] *= scale;
    }
}

// Returns the terms of degrees up to `degree` that belong to each part, as indices among all terms up to `order`.
[[nodiscard]] std::array<base::Array<std::int32_t>, 8> terms_of_parts(base::Memory& memory, int degree, int order) {
    std::array<base::Array<std::int32_t>, 8> parts = arrays<std::int32_t>(memory);
    std::int32_t at = 0;
    for (int a = 0; a <= order; ++a)
        for (int b = 0; a + b <= order; ++b)
            for (int c = 0; a + b + c <= order; ++c, ++at)
                if (a + b + c <= degree)
                    parts[static_cast<std::size_t>((a & 1) | (b & 1) << 1 | (c & 1) << 2)].push_back(at);
    return parts;
}

} // namespace

MirroredBasis::MirroredBasis(const base::Work& work, int degree)
    : degree_(degree), nodes_(nodes_of(work.memory, degree)), matrix_(arrays<double>(work.memory)) {
    HRBFNPR_ASSERT(degree % 2 == 1 && degree >= degree_min && degree <= degree_max);
    const base::Array<double> polynomials =
        triharmonic_coefficients(work.memory, degree_, CubeBasis::terms(degree_), work);
    work.for_each(8, [&](std::int64_t parity) { fit_part(work, polynomials, static_cast<std::size_t>(parity)); });
}

// A polynomial belongs to the part with the parity of all its terms.
void MirroredBasis::fit_part(const base::Work& work, const base::Array<double>& polynomials, std::size_t parity) {
    const base::Array<std::int32_t> term = std::move(terms_of_parts(work.memory, degree_, degree_)[parity]);
    const std::int64_t rows = term.size();
    base::Array<double> terms(work.memory);
    for (std::int64_t column = 0; column < triharmonic_size(degree_); ++column) {
        const double* const of = polynomials.data() + column * CubeBasis::terms(degree_);
        if (std::none_of(term.begin(), term.end(), [&](std::int32_t t) { return of[t] != 0.0; })) continue;
        for (const std::int32_t t : term) terms.push_back(of[t]);
    }
    const std::int64_t columns = terms.size() / rows;
    base::Array<double> values(work.memory, columns * groups());
    base::Array<double> all(work.memory, CubeBasis::terms(degree_));
    base::Array<double> some(work.memory, rows);
    for (std::int64_t g = 0; g < groups(); ++g) {
        work.check();
        CubeBasis::evaluate(degree_, nodes_[g], all.data());
        for (std::int64_t i = 0; i < rows; ++i) some[i] = all[term[i]];
        for (std::int64_t k = 0; k < columns; ++k)
            values[k * groups() + g] = dot(some.data(), terms.data() + k * rows, rows);
    }
    orthonormalise(values.data(), groups(), terms.data(), rows, columns);
    const std::int64_t stride = CubeBasis::padded(static_cast<int>(rows));
    matrix_[parity].resize(stride * groups());
    for (std::int64_t g = 0; g < groups(); ++g)
        for (std::int64_t k = 0; k < columns; ++k)
            add_scaled(values[k * groups() + g], terms.data() + k * rows, matrix_[parity].data() + g * stride, rows);
}

MirroredBasis::Batch::Batch(base::Memory& memory, const MirroredBasis& basis, int order)
    : basis_(basis), term_(terms_of_parts(memory, basis.degree(), order)), in_(memory, basis.size() * cube_batch),
      out_(memory, CubeBasis::padded(static_cast<int>(term_[0].size())) * cube_batch) {}

// Sums and differences over pairs of mirrored nodes, axis by axis, separate the eight parts.
void MirroredBasis::Batch::add(double* values, double factor, double* terms) noexcept {
    const std::int64_t groups = basis_.groups();
    for (std::int64_t bit = 1; bit < 8; bit *= 2)
        for (std::int64_t sign = 0; sign < 8; ++sign) {
            if ((sign & bit) != 0) continue;
            double* const a = values + sign * groups;
            double* const b = values + (sign | bit) * groups;
            for (std::int64_t g = 0; g < groups; ++g) {
                const double sum = a[g] + b[g];
                b[g] = a[g] - b[g];
                a[g] = sum;
            }
        }
    const double share = 0.125 * factor;
    for (std::int64_t i = 0; i < basis_.size(); ++i) in_[i * cube_batch + count_] = share * values[i];
    terms_[static_cast<std::size_t>(count_++)] = terms;
}

void MirroredBasis::Batch::flush(const CubeLoops& loops) noexcept {
    if (count_ == 0) return;
    const std::int64_t groups = basis_.groups();
    for (std::size_t parity = 0; parity < 8; ++parity) {
        const base::Array<std::int32_t>& term = term_[parity];
        const std::int64_t rows = term.size();
        const std::int64_t stride = CubeBasis::padded(static_cast<int>(rows));
        std::fill(out_.begin(), out_.end(), 0.0);
        double* out[cube_batch];
        for (std::int64_t v = 0; v < cube_batch; ++v) out[v] = out_.data() + v * stride;
        loops.multiply(basis_.matrix_[parity].data(), stride, static_cast<int>(stride), static_cast<int>(groups),
                       in_.data() + static_cast<std::int64_t>(parity) * groups * cube_batch, out, cube_batch);
        for (std::int64_t v = 0; v < count_; ++v)
            for (std::int64_t i = 0; i < rows; ++i) terms_[static_cast<std::size_t>(v)][term[i]] += out[v][i];
    }
    count_ = 0;
}

} // namespace hrbfnpr::implicit

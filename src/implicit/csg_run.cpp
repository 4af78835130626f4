// SPDX-License-Identifier: MIT
#include "implicit/csg_run.h"

namespace hrbfnpr::implicit {
namespace {

// scale M^T H M.
std::array<double, 6> moved(const std::array<double, 6>& h, const CsgPlace& place) noexcept {
    const glm::dmat3 full(h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]);
    const glm::dmat3 m = place.scale * (glm::transpose(place.to_local) * full * place.to_local);
    return {m[0][0], m[1][0], m[2][0], m[1][1], m[2][1], m[2][2]};
}

CsgJet negative(const CsgJet& jet, double add) noexcept {
    CsgJet turned{add - jet.value, -jet.gradient, jet.hessian};
    for (double& h : turned.hessian) h = -h;
    return turned;
}

// By the chain rule.
CsgJet chained(const BlendJet& f, const CsgJet& a, const CsgJet& b) noexcept {
    CsgJet jet{f.value, f.by_a * a.gradient + f.by_b * b.gradient, {}};
    std::size_t at = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j, ++at)
            jet.hessian[at] = f.by_a * a.hessian[at] + f.by_b * b.hessian[at] +
                              f.by_aa * a.gradient[i] * a.gradient[j] +
                              f.by_ab * (a.gradient[i] * b.gradient[j] + b.gradient[i] * a.gradient[j]) +
                              f.by_bb * b.gradient[i] * b.gradient[j];
    return jet;
}

} // namespace

CsgJet Csg::Run::take(const CsgRegister& from, std::int64_t lane) const noexcept {
    CsgJet jet;
    jet.value = from.value[lane];
    for (int c = 0; wanted_.gradient && c < 3; ++c) jet.gradient[c] = from.gradient[c][lane];
    for (std::size_t c = 0; wanted_.hessian && c < 6; ++c) jet.hessian[c] = from.hessian[c][lane];
    return jet;
}

void Csg::Run::set(CsgRegister& to, std::int64_t lane, const CsgJet& jet) const noexcept {
    to.value[lane] = jet.value;
    for (int c = 0; wanted_.gradient && c < 3; ++c) to.gradient[c][lane] = jet.gradient[c];
    for (std::size_t c = 0; wanted_.hessian && c < 6; ++c) to.hessian[c][lane] = jet.hessian[c];
}

// Of a leaf, in its own coordinates.
void Csg::Run::put(CsgRegister& to, std::int64_t lane, const CsgOp& op, const CsgPlace& place,
                   const CsgJet& jet) const noexcept {
    CsgJet here{place.scale * jet.value + op.add, glm::dvec3(0.0), {}};
    if (wanted_.gradient) here.gradient = place.scale * (jet.gradient * place.to_local);
    if (wanted_.hessian) here.hessian = moved(jet.hessian, place);
    set(to, lane, here);
}

void Csg::Run::shape(const CsgStep& step, const CsgOp& op, const PointBatch& points) noexcept {
    const CsgPlace& place = plan_.place(op);
    CsgRegister& to = registers_[step.to];
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = local(place, points, i);
        std::int32_t sheet = step.sheet;
        double value = 0.0;
        if (sheet < 0) value = place.shape.value(p, sheet);
        if (step.sheet < 0 && !wanted_.gradient)
            put(to, i, op, place, {value, glm::dvec3(0.0), {}});
        else
            put(to, i, op, place, place.shape.jet(sheet, p));
        if (wanted_.sheet) to.sheet[i] = sheet;
    }
}

// Whether a model can matter where f is `beyond` or more: it ends at its box.
bool Csg::Run::is_needed(const CsgStep& step, const CsgOp& op, const CsgPlace& place, std::int64_t lane,
                         double beyond) const noexcept {
    if (step.than < 0) return true;
    const CsgOp& both = plan_.ops()[step.than];
    if (both.takes_least() != (place.scale > 0.0)) return true;
    const double sign = place.scale > 0.0 ? 1.0 : -1.0;
    const double other = sign * registers_[step.to - 1].value[lane];
    const double least = sign * (place.scale * beyond + op.add);
    const double radius = both.blend.radius;
    return !(least > (both.blend.exponent > 0.0 ? std::max(radius, other) : other + radius));
}

void Csg::Run::ask(const CsgStep& step, const CsgPlace& place, std::int64_t count) {
    CsgRegister& answer = scratch_.answer;
    FieldBatch fields{answer.value, {}, {}};
    for (std::size_t c = 0; wanted_.gradient && c < 3; ++c) fields.gradient[c] = answer.gradient[c];
    for (std::size_t c = 0; wanted_.hessian && c < 6; ++c) fields.hessian[c] = answer.hessian[c];
    const PointBatch points{scratch_.at[0], scratch_.at[1], scratch_.at[2], count};
    const Implicit& model = *csg_.leaves_[place.model];
    const Sheets* const sheets = model.sheets();
    std::fill_n(answer.sheet, count, std::max(0, step.sheet));
    if (step.sheet >= 0 && sheets != nullptr)
        sheets->evaluate(step.sheet, points, fields);
    else
        model.evaluate(points, fields);
    if (step.sheet < 0 && wanted_.sheet && sheets != nullptr) sheets->active(points, answer.sheet);
}

// The larger of the model's f and the distance from its box: beyond that its f may be anything.
void Csg::Run::end_at_box(const CsgPlace& place, std::int64_t k) noexcept {
    CsgRegister& answer = scratch_.answer;
    const glm::dvec3 p(scratch_.at[0][k], scratch_.at[1][k], scratch_.at[2][k]);
    std::int32_t side = 0;
    const double beyond = place.shape.value(p - place.centre, side);
    const bool ends = beyond > 0.0 ? !(answer.value[k] >= beyond) : beyond > answer.value[k];
    if (!ends) return;
    set(answer, k, place.shape.jet(side, p - place.centre));
    answer.sheet[k] = place.model_sheets + side;
}

void Csg::Run::model(const CsgStep& step, const CsgOp& op, const PointBatch& points) {
    const CsgPlace& place = plan_.place(op);
    CsgRegister& to = registers_[step.to];
    const bool side = step.sheet >= place.model_sheets;
    std::int64_t asked = 0;
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p = local(place, points, i);
        if (side) {
            put(to, i, op, place, place.shape.jet(step.sheet - place.model_sheets, p - place.centre));
            continue;
        }
        std::int32_t nearest = 0;
        if (step.than >= 0 && !is_needed(step, op, place, i, place.shape.value(p - place.centre, nearest))) {
            const bool least = place.scale > 0.0;
            constexpr double infinity = std::numeric_limits<double>::infinity();
            set(to, i, {least ? infinity : -infinity, glm::dvec3(0.0), {}});
            to.sheet[i] = 0;
            continue;
        }
        scratch_.lane[asked] = static_cast<std::int32_t>(i);
        for (int c = 0; c < 3; ++c) scratch_.at[c][asked] = p[c];
        ++asked;
    }
    if (asked == 0) return;
    ask(step, place, asked);
    for (std::int64_t k = 0; k < asked; ++k) {
        if (step.sheet < 0) end_at_box(place, k);
        put(to, scratch_.lane[k], op, place, take(scratch_.answer, k));
        to.sheet[scratch_.lane[k]] = scratch_.answer.sheet[k];
    }
}

void Csg::Run::pick(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    CsgRegister& first = registers_[step.to];
    if (step.sheet >= 0) { // only one of them was made
        for (std::int64_t i = 0; i < count; ++i) first.value[i] += op.add;
        return;
    }
    const CsgRegister& second = registers_[step.to + 1];
    const CsgRegister& a = step.a_is_second ? second : first;
    const CsgRegister& b = step.a_is_second ? first : second;
    const std::int32_t sheets_of_a = plan_.ops()[op.a].sheets;
    const double sign = op.takes_least() ? 1.0 : -1.0;
    for (std::int64_t i = 0; i < count; ++i) {
        const bool takes_b = takes_lower(sign * a.value[i], sign * b.value[i]);
        const CsgRegister& from = takes_b ? b : a;
        if (wanted_.sheet) first.sheet[i] = op.merged ? 0 : from.sheet[i] + (takes_b ? sheets_of_a : 0);
        CsgJet jet = take(from, i);
        jet.value += op.add;
        set(first, i, jet);
    }
}

void Csg::Run::mix(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    CsgRegister& first = registers_[step.to];
    const CsgRegister& second = registers_[step.to + 1];
    const CsgRegister& a = step.a_is_second ? second : first;
    const CsgRegister& b = step.a_is_second ? first : second;
    const std::int32_t sheets_of_b = plan_.ops()[op.b].sheets;
    for (std::int64_t i = 0; i < count; ++i) {
        if (wanted_.sheet) first.sheet[i] = op.merged ? 0 : a.sheet[i] * sheets_of_b + b.sheet[i];
        const BlendJet blend =
            op.takes_least() ? op.blend.minimum(a.value[i], b.value[i]) : op.blend.maximum(a.value[i], b.value[i]);
        CsgJet jet;
        if (wanted_.gradient)
            jet = chained(blend, take(a, i), take(b, i));
        else
            jet.value = blend.value;
        jet.value += op.add;
        set(first, i, jet);
    }
}

void Csg::Run::shell(const CsgStep& step, const CsgOp& op, std::int64_t count) noexcept {
    CsgRegister& to = registers_[step.to];
    const std::int32_t sheets = plan_.ops()[op.a].sheets;
    const double sign = op.takes_least() ? 1.0 : -1.0;
    for (std::int64_t i = 0; i < count; ++i) {
        CsgJet jet = take(to, i);
        const bool inner =
            step.sheet >= 0 ? step.sheet >= sheets : takes_lower(sign * jet.value, op.thickness - sign * jet.value);
        if (inner) jet = negative(jet, sign * op.thickness);
        if (wanted_.sheet) to.sheet[i] = op.merged ? 0 : to.sheet[i] + (inner ? sheets : 0);
        jet.value += op.add;
        set(to, i, jet);
    }
}

void Csg::Run::run(std::span<const CsgStep> steps, const PointBatch& points) {
    for (const CsgStep& step : steps) {
        const CsgOp& op = plan_.ops()[step.op];
        switch (step.kind) {
        case CsgStep::Kind::leaf:
            if (op.kind == CsgOp::Kind::model)
                model(step, op, points);
            else
                shape(step, op, points);
            break;
        case CsgStep::Kind::combine:
            if (op.blend.radius > 0.0)
                mix(step, op, points.count);
            else
                pick(step, op, points.count);
            break;
        case CsgStep::Kind::shell: shell(step, op, points.count); break;
        case CsgStep::Kind::group: group(step, op, points); break;
        }
    }
}

} // namespace hrbfnpr::implicit

// SPDX-License-Identifier: MIT
#include "host/session.h"

namespace host_test {

Context make_context(const hrbfnpr_context_desc& desc) {
    scenes::Check check;
    hrbfnpr_context* context = nullptr;
    check(hrbfnpr_context_create(&desc, &context, check.error()));
    return Context(context);
}

Context make_context(std::int32_t threads) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.thread_backend = hrbfnpr::test::test_backend();
    return make_context(desc);
}

hrbfnpr_fit_desc fit_desc(const scenes::Samples& samples) {
    auto desc = made(hrbfnpr_fit_desc_init);
    desc.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    return desc;
}

Model fit(const Context& context, const hrbfnpr_fit_desc& desc) {
    scenes::Check check;
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, check.error()));
    return Model(model);
}

Model fit(const Context& context, int samples) {
    const scenes::Samples torus = scenes::torus(samples);
    return fit(context, fit_desc(torus));
}

PointSet generate(const Context& context, const Model& model, Generation desc) {
    scenes::Check check;
    hrbfnpr_point_set* marks = nullptr;
    check(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &marks, check.error()));
    return PointSet(marks);
}

PointSet generate(const Context& context, const Model& model) { return generate(context, model, three_layers(1000)); }

Bytes everything(const Scene& scene) {
    Bytes all;
    for (const Step& step : steps()) {
        const Bytes part = step.run(scene);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

} // namespace host_test

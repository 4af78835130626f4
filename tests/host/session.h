// SPDX-License-Identifier: MIT
// A host's session with the library, so that tests can run it in unusual places.
#pragma once

#include "scenes/shapes.h"
#include "support/generation.h"
#include "support/test_backend.h"

#include <cstdint>
#include <vector>

namespace host_test {

using hrbfnpr::test::Context;
using hrbfnpr::test::Drawing;
using hrbfnpr::test::Generation;
using hrbfnpr::test::LineSet;
using hrbfnpr::test::made;
using hrbfnpr::test::Model;
using hrbfnpr::test::PointSet;
using hrbfnpr::test::Renderer;
using hrbfnpr::test::three_layers;
using Bytes = std::vector<std::uint8_t>;

// These throw a message that says what went wrong.
Context make_context(const hrbfnpr_context_desc& desc);
Context make_context(std::int32_t threads);
hrbfnpr_fit_desc fit_desc(const scenes::Samples& samples);
Model fit(const Context& context, const hrbfnpr_fit_desc& desc);
Model fit(const Context& context, int samples = 192); // a fit of a torus
PointSet generate(const Context& context, const Model& model, Generation desc);
PointSet generate(const Context& context, const Model& model); // 1000 marks of each kind
Bytes draw(const Context& context, const PointSet& marks, const hrbfnpr_model* rays = nullptr);

// A torus and marks on it.
struct Scene {
    explicit Scene(Context made_context) : context(std::move(made_context)), model(fit(context)) {}
    Context context;
    Model model;
    PointSet marks = generate(context, model);
};

} // namespace host_test

// SPDX-License-Identifier: MIT
// A CSG tree of a model's: the nodes, the models that are its leaves, and the function that they make.
#pragma once

#include "base/operation.h"
#include "implicit/csg.h"

#include <memory>
#include <mutex>
#include <vector>

struct hrbfnpr_context;
struct hrbfnpr_model;

namespace hrbfnpr::api {

// Whether nodes are a tree, and their numbers in their ranges.  Throws Error{invalid_argument} that names the node.
// list: "csg_desc.nodes".
void check_csg_tree(const char* list, const implicit::CsgTree& tree);

class CsgSolid {
public:
    explicit CsgSolid(const base::Runtime& runtime) noexcept
        : runtime_(runtime), tree_(runtime.memory), models_(runtime.memory) {}
    CsgSolid(const CsgSolid&) = delete;
    CsgSolid& operator=(const CsgSolid&) = delete;
    ~CsgSolid();

    // First the nodes are added, each after its parent; the first has none, whatever it says.  A tree takes the place
    // of a leaf.  Returns the index of the first new one.
    std::int64_t add(const CsgSolid& of, const implicit::CsgNode& in_place_of);
    std::int64_t add(const implicit::CsgNode& node);
    // `model` of a node: keeps it; the same one has one number.
    [[nodiscard]] std::int64_t leaf(const hrbfnpr_model& model);

    // Then they are made a function.
    void plan();
    [[nodiscard]] const implicit::CsgPlan& planned() const noexcept { return *plan_; }
    void finish(const geometry::Bounds& bounds);

    // From then on:
    [[nodiscard]] const implicit::Csg& own() const noexcept { return *own_; }
    [[nodiscard]] const implicit::Implicit& implicit_for(double evaluations, const base::Progress& progress) const;
    [[nodiscard]] const implicit::CsgTree& tree() const noexcept { return tree_; }
    [[nodiscard]] const base::Array<const hrbfnpr_model*>& models() const noexcept { return models_; }
    [[nodiscard]] std::int64_t depth() const;
    [[nodiscard]] std::int64_t bytes() const noexcept { return tree_.bytes() + models_.bytes() + plan_->bytes(); }

private:
    void need_room(std::int64_t more) const;

    const base::Runtime& runtime_;
    implicit::CsgTree tree_;
    base::Array<const hrbfnpr_model*> models_;
    std::unique_ptr<implicit::CsgPlan> plan_;
    std::unique_ptr<implicit::Csg> own_;
    mutable std::mutex preparing_;
    mutable std::vector<std::unique_ptr<implicit::Csg>> prepared_; // with some leaves prepared
};

// bounds: null: those that the tree has, if it has some.
[[nodiscard]] hrbfnpr_model* make_csg_model(hrbfnpr_context& context, std::unique_ptr<CsgSolid> solid,
                                            const geometry::Bounds* bounds);

} // namespace hrbfnpr::api

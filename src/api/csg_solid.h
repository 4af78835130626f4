// SPDX-License-Identifier: MIT
// The CSG tree of a model: the nodes, the models that are its leaves, and the function that they make.
#pragma once

#include "base/operation.h"
#include "implicit/csg.h"

#include <memory>
#include <mutex>
#include <vector>

struct hrbfnpr_context;
struct hrbfnpr_model;

namespace hrbfnpr::api {

// Checks that the nodes form a tree and that their numbers are in range.  Throws Error{invalid_argument} that names the
// node in the list, such as "csg_desc.nodes[2]".
void check_csg_tree(const char* list, const implicit::CsgTree& tree);

class CsgSolid {
public:
    explicit CsgSolid(const base::Runtime& runtime) noexcept
        : runtime_(runtime), tree_(runtime.memory), models_(runtime.memory) {}
    CsgSolid(const CsgSolid&) = delete;
    CsgSolid& operator=(const CsgSolid&) = delete;
    ~CsgSolid();

    // Call these functions before plan(), and add each node after its parent. The first node is the root, whatever
    // parent it names. The first function adds the whole tree of `of` in place of the leaf `in_place_of`. The second
    // function adds a single node. Both functions return the index of the first node that they added.
    std::int64_t add(const CsgSolid& of, const implicit::CsgNode& in_place_of);
    std::int64_t add(const implicit::CsgNode& node);
    // Returns the index of a model in models(), for CsgNode::model, and adds a reference to a new model. Repeated calls
    // for a model return the same index.
    [[nodiscard]] std::int64_t leaf(const hrbfnpr_model& model);

    // Makes the function. Call it after all nodes have been added.
    void plan();
    [[nodiscard]] const implicit::CsgPlan& planned() const noexcept { return *plan_; }
    void finish(const geometry::Bounds& bounds);

    // The functions below may be called only after finish().
    [[nodiscard]] const implicit::Csg& function() const noexcept { return *function_; }
    [[nodiscard]] const implicit::Implicit& implicit_for(double evaluations, const base::Progress& progress) const;
    [[nodiscard]] const implicit::CsgTree& tree() const noexcept { return tree_; }
    [[nodiscard]] const base::Array<const hrbfnpr_model*>& models() const noexcept { return models_; }
    [[nodiscard]] std::int64_t depth() const;
    [[nodiscard]] std::int64_t bytes() const noexcept { return tree_.bytes() + models_.bytes() + plan_->bytes(); }

private:
    void require_room(std::int64_t more) const;

    const base::Runtime& runtime_;
    implicit::CsgTree tree_;
    base::Array<const hrbfnpr_model*> models_;
    std::unique_ptr<implicit::CsgPlan> plan_;
    std::unique_ptr<implicit::Csg> function_;
    mutable std::mutex preparing_;
    mutable std::vector<std::unique_ptr<implicit::Csg>> prepared_; // functions in which some leaves are prepared
};

// If `bounds` is null, uses the bounds of the tree. Throws if the tree has no bounds.
[[nodiscard]] hrbfnpr_model* make_csg_model(hrbfnpr_context& context, std::unique_ptr<CsgSolid> solid,
                                            const geometry::Bounds* bounds);

} // namespace hrbfnpr::api

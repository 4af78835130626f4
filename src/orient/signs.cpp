// SPDX-License-Identifier: MIT
// The steps of the solver are:
//
//   find_patches    joins places and their neighbours to patches, which are the first clusters; for large clouds only
//   Agglomeration   makes rounds in which each cluster joins a partner, until only one cluster is left
//   improve         sweeps from the largest clusters to single places, and turns each if that lowers the energy
//
// The energy is a sum of squares made from the terms of the sparse factor. The elements of a sparse term are a few
// places; those of the dense term are the coarsest places.
#include "orient/signs.h"

#include "base/assert.h"
#include "base/scratch_pool.h"
#include "base/sort.h"
#include "orient/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t clusters_a_task = 256;
constexpr std::int64_t places_a_look = 512;

// Sums numbers for each cluster. The name of a cluster is the index of its first place.
struct ClusterSums {
    explicit ClusterSums(const base::Runtime& runtime) noexcept
        : sum(runtime.memory), is_there(runtime.memory), names(runtime.memory) {}

    void clear(std::int64_t size) {
        sum.resize(size);
        is_there.resize(size);
        for (const std::int32_t name : names) is_there[name] = 0;
        names.clear();
    }
    void add(std::int32_t name, double number) {
        if (is_there[name] == 0) {
            is_there[name] = 1;
            sum[name] = 0.0;
            names.push_back(name);
        }
        sum[name] += number;
    }

    base::Array<double> sum;
    base::Array<std::uint8_t> is_there;
    base::Array<std::int32_t> names; // in the order in which they were first added
};

using Vec4 = std::array<double, 4>;

// For each level, from fine to coarse: the name of the cluster of each place. The name is the first place of the
// cluster.
using Levels = std::vector<base::Array<std::int32_t>>;

// The terms of the energy. The directions are fixed, and the signs are the unknowns.
struct SignTerms {
    SignTerms(const base::Work& work, const fit::HermiteEnergy& energy, const geometry::VecArray& normal)
        : runtime(work), terms(energy.terms(normal, work)), blocks(terms.blocks), size(energy.size()),
          dense(work.memory, size) {
        for (std::int64_t k = 0; k < blocks.coarse_count; ++k) dense[blocks.coarse[k]] = k + 1;
    }

    // Returns the contribution of an element to its term.
    [[nodiscard]] Vec4 part(std::int64_t element, const Signs& signs) const noexcept {
        const float* const a = terms.add.data() + 4 * element;
        const auto s = static_cast<float>(signs[blocks.set[element]]);
        return {double{s * a[0]}, double{s * a[1]}, double{s * a[2]}, double{s * a[3]}};
    }
    // Calls visit(element) for the elements of a term.
    template <class Visit>
    void for_elements(std::int64_t term, Visit&& visit) const {
        for (std::int64_t e = term * blocks.set_size; e < (term + 1) * blocks.set_size; ++e) visit(e);
    }
    // Returns the contribution of a sample to the dense term, if its sign is +1.
    [[nodiscard]] const double* dense_part(std::int64_t sample) const noexcept {
        return terms.coarse_add.data() + sample * blocks.coarse_columns;
    }

    const base::Runtime& runtime;
    fit::HermiteEnergy::Terms terms;
    fit::Preconditioner::Blocks blocks;
    std::int64_t size;
    base::Array<std::int64_t> dense; // for each place: 1 + its index in the dense term, or 0 if it is not in the term
};

// Joins clusters of places in pairs. Partners are each other's nearest cluster, measured by |coupling| / sqrt(self
// energies), and join with the signs that lower the energy. Their couplings are added. If the first level is given, it
// holds the initial clusters, and `signs` holds the signs inside them.
//
// Clusters are linked lists of their members. A term whose members are all in one cluster is finished and is skipped.
class Agglomeration {
public:
    Agglomeration(const SignTerms& energy, Levels& levels, Signs& signs, const base::Progress& progress)
        : energy_(energy), memory_(energy.runtime.memory), blocks_(energy.blocks), size_(energy.size), levels_(levels),
          signs_(signs), progress_(progress), cluster_(memory_, size_), next_(memory_, size_), last_(memory_, size_),
          self_(memory_, size_), partner_(memory_, size_), count_(memory_, size_), joined_(memory_, size_),
          finished_(memory_, size_), names_(memory_), sums_(energy.runtime) {
        for (std::int64_t at = 0; at < size_; ++at) {
            const std::int32_t name = levels.empty() ? static_cast<std::int32_t>(at) : levels.back()[at];
            HRBFNPR_ASSERT(name <= at);
            cluster_[at] = name;
            next_[at] = -1;
            last_[at] = static_cast<std::int32_t>(at);
            ++count_[name];
            if (name == at)
                names_.push_back(name);
            else
                append(name, static_cast<std::int32_t>(at));
        }
        for_names([&](std::int32_t name) { self_[name] = self_energy(name); });
    }

    void run() {
        std::int64_t kept = names_.size();
        while (names_.size() > 1) {
            const std::int64_t before = names_.size();
            mark_finished_terms();
            for_names([&](std::int32_t name) { partner_[name] = find_partner(name); });
            join_partners();
            if (names_.size() == before) break; // No two clusters are coupled any more.
            if (static_cast<double>(names_.size()) > tuning.kept_share * static_cast<double>(kept)) continue;
            kept = names_.size();
            levels_.emplace_back(memory_, size_);
            std::copy_n(cluster_.data(), size_, levels_.back().data());
        }
    }

private:
    struct Partner {
        std::int32_t name = -1; // -1 if no cluster is coupled to this one
        double coupling = 0.0;
        double strength = -1.0; // |coupling| divided by the root of the product of both self energies
    };
    struct ClusterLink {
        std::int32_t to; // the cluster that this one joins in the round; a root joins itself
        bool turned;     // true if the sign of the cluster differs from the sign of `to`
    };

    template <class F>
    void for_names(F&& f) const {
        energy_.runtime.parallel.for_chunks(names_.size(), clusters_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = begin; k < end; ++k) {
                progress_.check();
                f(names_[k]);
            }
        });
    }

    void append(std::int32_t to, std::int32_t other) noexcept {
        next_[last_[to]] = other;
        last_[to] = last_[other];
    }

    // Calls visit(term) once for each unfinished term that has a member in the cluster.
    template <class Visit>
    void for_terms(std::int32_t name, Visit&& visit) const {
        for (std::int32_t at = name; at >= 0; at = next_[at])
            for (std::int64_t u = blocks_.use_begin[at]; u < blocks_.use_begin[at + 1]; ++u) {
                const std::int64_t element = blocks_.use[u];
                const std::int64_t term = element / blocks_.set_size;
                if (finished_[term] != 0) continue;
                std::int64_t first = term * blocks_.set_size;
                while (cluster_[blocks_.set[first]] != name) ++first;
                if (first == element) visit(term);
            }
    }
    // For all pairs of the dense term whose first place is in the cluster, calls visit(name, product). `name` is the
    // cluster of the second place.
    template <class Visit>
    void for_dense(std::int32_t name, Visit&& visit) const {
        for (std::int32_t at = name; at >= 0; at = next_[at])
            for (std::int64_t k = 0; energy_.dense[at] > 0 && k < blocks_.coarse_count; ++k) {
                const std::int64_t other = blocks_.coarse[k];
                const double* const x = energy_.dense_part(energy_.dense[at] - 1);
                const double product = std::inner_product(x, x + blocks_.coarse_columns, energy_.dense_part(k), 0.0);
                visit(cluster_[other], product * signs_[at] * signs_[other]);
            }
    }

    [[nodiscard]] Vec4 part_of(std::int32_t name, std::int64_t term) const noexcept {
        Vec4 sum{};
        energy_.for_elements(term, [&](std::int64_t e) {
            if (cluster_[blocks_.set[e]] != name) return;
            const Vec4 part = energy_.part(e, signs_);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += part[c];
        });
        return sum;
    }

    [[nodiscard]] double self_energy(std::int32_t name) const {
        double sum = 0.0;
        for_terms(name, [&](std::int64_t term) {
            for (const double x : part_of(name, term)) sum += x * x;
        });
        for_dense(name, [&](std::int32_t other, double product) { sum += other == name ? product : 0.0; });
        return sum;
    }

    void mark_finished_terms() {
        energy_.runtime.parallel.for_chunks(
            size_, 8 * clusters_a_task, progress_, [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t term = begin; term < end; ++term) {
                    const std::int32_t* const set = blocks_.set + term * blocks_.set_size;
                    if (finished_[term] == 0 && set[0] >= 0 &&
                        std::all_of(set, set + blocks_.set_size,
                                    [&](std::int32_t at) { return cluster_[at] == cluster_[set[0]]; }))
                        finished_[term] = 1;
                }
            });
    }

    [[nodiscard]] Partner find_partner(std::int32_t name) {
        const base::ScratchPool<ClusterSums>::Lease sums(sums_);
        sums->clear(size_);
        for_terms(name, [&](std::int64_t term) {
            progress_.check(); // The check is inside the loop because a large cluster has many terms.
            const Vec4 own = part_of(name, term);
            energy_.for_elements(term, [&](std::int64_t e) {
                const std::int32_t other = cluster_[blocks_.set[e]];
                if (other == name) return;
                const Vec4 part = energy_.part(e, signs_);
                sums->add(other, own[0] * part[0] + own[1] * part[1] + own[2] * part[2] + own[3] * part[3]);
            });
        });
        for_dense(name, [&](std::int32_t other, double product) {
            if (other != name) sums->add(other, product);
        });
        Partner best;
        for (const std::int32_t other : sums->names) {
            const double coupling = sums->sum[other];
            const double strength = std::abs(coupling) / std::sqrt(std::max(self_[name] * self_[other], 1e-300));
            if (strength > best.strength || (strength == best.strength && other < best.name))
                best = {other, coupling, strength};
        }
        return best;
    }

    // Joins clusters that are each other's partner. To save rounds, it also joins clusters with a coupling that leaves
    // little doubt, and small clusters with a large one.
    void join_partners() {
        for (const std::int32_t name : names_) joined_[name] = {name, false};
        for (const bool mutual_ones : {true, false})
            for (const std::int32_t name : names_) {
                const std::int32_t other = partner_[name].name;
                if (other < 0) continue;
                const bool mutual = partner_[other].name == name;
                if (mutual != mutual_ones || (mutual && other < name)) continue;
                const bool small = size_ > tuning.careful && tuning.large * count_[name] < count_[other];
                if (mutual || small || partner_[name].strength > tuning.sure_strength) join(name, partner_[name]);
            }
        std::int32_t* const end =
            std::remove_if(names_.begin(), names_.end(), [&](std::int32_t name) { return joined_[name].to != name; });
        names_.resize(end - names_.begin());
    }

    [[nodiscard]] ClusterLink root_of(std::int32_t name) const noexcept {
        ClusterLink result{name, false};
        while (joined_[result.to].to != result.to) {
            result.turned ^= joined_[result.to].turned;
            result.to = joined_[result.to].to;
        }
        return result;
    }

    // partner.coupling was computed with the signs at the beginning of the round.
    void join(std::int32_t one, const Partner& partner) noexcept {
        ClusterLink a = root_of(one);
        ClusterLink b = root_of(partner.name);
        if (a.to == b.to) return;
        if (a.to > b.to) std::swap(a, b);
        const bool turn = (partner.coupling > 0.0) != (a.turned != b.turned);
        self_[a.to] = std::max(self_[a.to] + self_[b.to] - 2.0 * std::abs(partner.coupling), 1e-300);
        for (std::int32_t at = b.to; at >= 0; at = next_[at]) {
            cluster_[at] = a.to;
            if (turn) signs_[at] = static_cast<std::int8_t>(-signs_[at]);
        }
        append(a.to, b.to);
        count_[a.to] += count_[b.to];
        joined_[b.to] = {a.to, turn};
    }

    const SignTerms& energy_;
    base::Memory& memory_;
    fit::Preconditioner::Blocks blocks_;
    std::int64_t size_;
    Levels& levels_;
    Signs& signs_;
    const base::Progress& progress_;
    base::Array<std::int32_t> cluster_; // for each place: the name of its cluster
    base::Array<std::int32_t> next_;    // for each place: the next member of its cluster, or -1 for the last
    // The last member of each cluster; this and the four arrays below are indexed by the name of the cluster.
    base::Array<std::int32_t> last_;
    base::Array<double> self_; // the energy of the members of a cluster without the others
    base::Array<Partner> partner_;
    base::Array<std::int64_t> count_; // number of members
    base::Array<ClusterLink> joined_;
    base::Array<std::uint8_t> finished_; // for each term: 1 if it is finished
    base::Array<std::int32_t> names_;
    base::ScratchPool<ClusterSums> sums_;
};

// Turns sets of places if that lowers the energy. It keeps the totals of all terms, from which the change of the energy
// is computed.
class SignFlipper {
public:
    SignFlipper(const SignTerms& energy, Signs& signs, const base::Progress& progress)
        : energy_(energy), blocks_(energy.blocks), signs_(signs), total_(energy.runtime.memory, 4 * energy.size),
          dense_total_(energy.runtime.memory, blocks_.coarse_columns),
          dense_part_(energy.runtime.memory, blocks_.coarse_columns), seen_(energy.runtime.memory, energy.size),
          terms_(energy.runtime.memory), part_(energy.runtime.memory, 4 * energy.size) {
        for (std::int64_t k = 0; k < blocks_.coarse_count; ++k) add_dense(k, dense_total_);
        for_places(base::Work(energy.runtime, progress), energy.size, [&](std::int64_t term) {
            if (blocks_.set[term * blocks_.set_size] < 0) return;
            energy_.for_elements(term, [&](std::int64_t e) {
                const Vec4 part = energy_.part(e, signs_);
                for (std::size_t c = 0; c < 4; ++c) total_[4 * term + static_cast<std::int64_t>(c)] += part[c];
            });
        });
    }

    [[nodiscard]] double energy() const noexcept {
        double sum = 0.0;
        for (const double t : total_) sum += t * t;
        for (const double t : dense_total_) sum += t * t;
        return sum;
    }

    // Turns the places in `members` if that lowers the energy by more than rounding.
    bool turn(std::span<const std::int32_t> members) {
        ++visit_;
        terms_.clear();
        std::fill(dense_part_.begin(), dense_part_.end(), 0.0);
        bool dense = false;
        for (const std::int32_t at : members) {
            for (std::int64_t u = blocks_.use_begin[at]; u < blocks_.use_begin[at + 1]; ++u) add(blocks_.use[u]);
            if (energy_.dense[at] == 0) continue;
            add_dense(energy_.dense[at] - 1, dense_part_);
            dense = true;
        }
        const auto for_numbers = [&](auto&& visit) { // Calls visit(contribution of `members`, total) for each number.
            for (const std::int32_t term : terms_)
                for (std::int64_t c = 4 * std::int64_t{term}; c < 4 * (std::int64_t{term} + 1); ++c)
                    visit(part_[c], total_[c]);
            for (std::int64_t c = 0; dense && c < blocks_.coarse_columns; ++c) visit(dense_part_[c], dense_total_[c]);
        };
        double across = 0.0;
        double self = 0.0;
        for_numbers([&](double part, double total) {
            across += part * (total - part);
            self += part * part;
        });
        if (!(across > tuning.least_gain * self)) return false;
        for_numbers([](double part, double& total) { total -= 2.0 * part; });
        for (const std::int32_t at : members) signs_[at] = static_cast<std::int8_t>(-signs_[at]);
        return true;
    }

private:
    void add(std::int64_t element) {
        const auto term = static_cast<std::int32_t>(element / blocks_.set_size);
        double* const sum = part_.data() + 4 * std::int64_t{term};
        if (seen_[term] != visit_) {
            seen_[term] = visit_;
            terms_.push_back(term);
            std::fill_n(sum, 4, 0.0);
        }
        const Vec4 part = energy_.part(element, signs_);
        for (std::size_t c = 0; c < 4; ++c) sum[c] += part[c];
    }

    void add_dense(std::int64_t k, base::Array<double>& sum) const noexcept {
        const double* const a = energy_.dense_part(k);
        for (std::int64_t c = 0; c < blocks_.coarse_columns; ++c) sum[c] += signs_[blocks_.coarse[k]] * a[c];
    }

    const SignTerms& energy_;
    fit::Preconditioner::Blocks blocks_;
    Signs& signs_;
    base::Array<double> total_;
    base::Array<double> dense_total_;
    base::Array<double> dense_part_;
    base::Array<std::int64_t> seen_;  // for each term: the index of the last visit to it
    base::Array<std::int32_t> terms_; // the terms to which the places in `members` contribute
    base::Array<double> part_;        // for each term in `terms_`: the contribution of `members`
    std::int64_t visit_ = 0;
};

// Turns whole clusters, from coarse to fine, and then single places, if that lowers the energy. Returns the energy.
double improve(const SignTerms& energy, const Levels& levels, Signs& signs, const base::Progress& progress) {
    SignFlipper turning(energy, signs, progress);
    base::Array<std::int32_t> order(energy.runtime.memory, energy.size);
    for (int sweep = 0; sweep < tuning.most_sweeps; ++sweep) {
        bool turned = false;
        for (std::size_t level = levels.size() + 1; level-- > 0;) {
            progress.check();
            std::iota(order.begin(), order.end(), 0);
            const base::Array<std::int32_t>* const cluster = level > 0 ? &levels[level - 1] : nullptr;
            const auto name = [&](std::int32_t at) { return cluster != nullptr ? (*cluster)[at] : at; };
            if (cluster != nullptr)
                base::sort_long(
                    order.begin(), order.end(),
                    [&](std::int32_t a, std::int32_t b) { return std::pair(name(a), a) < std::pair(name(b), b); },
                    progress);
            std::int64_t looked = 0;
            for (std::int64_t begin = 0; begin < energy.size;) {
                if (begin >= looked) {
                    progress.check();
                    looked = begin + places_a_look;
                }
                std::int64_t end = begin + 1;
                while (end < energy.size && name(order[end]) == name(order[begin])) ++end;
                if (turning.turn({order.data() + begin, static_cast<std::size_t>(end - begin)})) turned = true;
                begin = end;
            }
        }
        if (!turned) break;
    }
    return turning.energy();
}

// Returns patches, which serve as first clusters. A patch is a place with those neighbours on its sheet whose normals
// agree with its normal. Writes the signs of the neighbours.
[[nodiscard]] base::Array<std::int32_t> find_patches(const OrderedPoints& places, const NeighbourLists& near,
                                                     const geometry::VecArray& normal, Signs& signs) {
    base::Array<std::int32_t> patch(signs.memory(), places.size());
    std::fill(patch.begin(), patch.end(), -1);
    for (std::int64_t at = 0; at < places.size(); ++at) {
        if (patch[at] >= 0) continue;
        patch[at] = static_cast<std::int32_t>(at);
        for (const std::int32_t other : near.of(at, tuning.patch_neighbours)) {
            if (patch[other] >= 0) continue;
            const double cosine = glm::dot(normal[at], normal[other]);
            const glm::dvec3 between = places.point(other) - places.point(at);
            const double off =
                std::max(std::abs(glm::dot(between, normal[at])), std::abs(glm::dot(between, normal[other])));
            if (std::abs(cosine) < tuning.patch_alike || off > tuning.patch_beside * glm::length(between)) continue;
            patch[other] = static_cast<std::int32_t>(at);
            signs[other] = cosine > 0.0 ? std::int8_t{1} : std::int8_t{-1};
        }
    }
    return patch;
}

} // namespace

Signs all_positive(base::Memory& memory, std::int64_t size) {
    Signs signs(memory, size);
    std::fill(signs.begin(), signs.end(), std::int8_t{1});
    return signs;
}

void find_signs(const base::Work& work, const OrderedPoints& places, const NeighbourLists& near,
                const fit::HermiteEnergy& energy, geometry::VecArray& normal) {
    HRBFNPR_ASSERT(normal.size() == places.size() && energy.size() == places.size());
    const SignTerms terms(work, energy, normal);
    Signs signs = all_positive(work.memory, places.size());
    const double given = SignFlipper(terms, signs, work).energy();
    Levels levels;
    if (places.size() > tuning.many_places) levels.push_back(find_patches(places, near, normal, signs));
    Agglomeration(terms, levels, signs, work).run();
    if (!(improve(terms, levels, signs, work) < given * (1.0 - 1e-9))) return;
    for (std::int64_t at = 0; at < places.size(); ++at)
        if (signs[at] < 0) normal.set(at, -normal[at]);
}

} // namespace hrbfnpr::orient

// SPDX-License-Identifier: MIT
#include "orient/signs.h"

#include "base/sort.h"
#include "orient/coupling_table.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t signs_a_task = 256;
constexpr std::int64_t terms_a_look = 1024;
constexpr std::int64_t places_a_look = 512;
// A coupling so strong, of at most 1, cancels most of what two clusters have for being apart.
constexpr double sure_strength = 0.5;
constexpr std::int64_t large = 4;      // times as many members
constexpr std::int64_t careful = 2000; // places: fewer wait
constexpr int most_sweeps = 4;
// Levels that are kept have at most this share of the clusters of the one before.
constexpr double kept_share = 0.3;
// Turning must lower the energy by more than rounding does: of the cluster's own.
constexpr double least_gain = 1e-6;

} // namespace

// Members are linked lists that are put together in no time; a term whose members are all of one cluster is passed
// over.
class SignEnergy::Agglomeration {
public:
    Agglomeration(const SignEnergy& energy, const base::Array<std::int32_t>* first, const Signs* signs,
                  const base::Progress& progress)
        : energy_(energy), blocks_(energy.terms_.blocks), size_(energy.size_), cluster_(energy.runtime_.memory, size_),
          next_(energy.runtime_.memory, size_), last_(energy.runtime_.memory, size_),
          signs_(energy.runtime_.memory, size_), self_(energy.runtime_.memory, size_),
          partner_(energy.runtime_.memory, size_), coupling_(energy.runtime_.memory, size_),
          strength_(energy.runtime_.memory, size_), count_(energy.runtime_.memory, size_),
          joined_(energy.runtime_.memory, size_), over_(energy.runtime_.memory, size_),
          coarse_of_(energy.runtime_.memory, size_), names_(energy.runtime_.memory) {
        for (std::int64_t k = 0; k < blocks_.coarse_count; ++k) coarse_of_[blocks_.coarse[k]] = k + 1;
        for (std::int64_t at = 0; at < size_; ++at) {
            signs_[at] = signs != nullptr ? (*signs)[at] : std::int8_t{1};
            const std::int32_t name = first != nullptr ? (*first)[at] : static_cast<std::int32_t>(at);
            cluster_[at] = name;
            next_[at] = -1;
            last_[at] = static_cast<std::int32_t>(at);
            ++count_[name];
            if (name == at)
                names_.push_back(name);
            else // names are of the first member, so that it has been seen
                append(name, static_cast<std::int32_t>(at));
        }
        measure_selves(progress);
    }

    Signs run(Levels& levels, const base::Progress& progress) {
        std::int64_t kept = names_.size();
        while (names_.size() > 1) {
            const std::int64_t before = names_.size();
            find_partners(progress);
            join_partners();
            if (names_.size() == before) break; // nothing is coupled
            if (static_cast<double>(names_.size()) > kept_share * static_cast<double>(kept)) continue;
            kept = names_.size();
            keep(levels);
        }
        return std::move(signs_);
    }

private:
    void append(std::int32_t to, std::int32_t other) noexcept {
        next_[last_[to]] = other;
        last_[to] = last_[other];
    }

    void keep(Levels& levels) const {
        levels.cluster.emplace_back(energy_.runtime_.memory, size_);
        std::copy_n(cluster_.data(), size_, levels.cluster.back().data());
    }

    // Calls visit(term) once for each term that the cluster has a member in, but those that are over.
    template <class Visit>
    void for_terms(std::int32_t name, Visit&& visit) const {
        for (std::int32_t at = name; at >= 0; at = next_[at])
            for (std::int64_t u = blocks_.use_begin[at]; u < blocks_.use_begin[at + 1]; ++u) {
                const std::int64_t element = blocks_.use[u];
                const std::int64_t term = element / blocks_.set_size;
                if (over_[term] != 0) continue;
                std::int64_t first = term * blocks_.set_size;
                while (cluster_[blocks_.set[first]] != name) ++first;
                if (first == element) visit(term);
            }
    }

    [[nodiscard]] Four part_of(std::int32_t name, std::int64_t term) const noexcept {
        Four sum{};
        for (std::int64_t e = term * blocks_.set_size; e < (term + 1) * blocks_.set_size; ++e) {
            if (cluster_[blocks_.set[e]] != name) continue;
            const Four part = energy_.part(e, signs_);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += part[c];
        }
        return sum;
    }

    [[nodiscard]] double coarse_product(std::int64_t a, std::int64_t b) const noexcept {
        const double* x = energy_.terms_.coarse_add.data() + a * blocks_.coarse_columns;
        const double* y = energy_.terms_.coarse_add.data() + b * blocks_.coarse_columns;
        double sum = 0.0;
        for (std::int64_t c = 0; c < blocks_.coarse_columns; ++c) sum += x[c] * y[c];
        return sum * signs_[blocks_.coarse[a]] * signs_[blocks_.coarse[b]];
    }

    void measure_selves(const base::Progress& progress) {
        energy_.runtime_.parallel.for_chunks(names_.size(), signs_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = begin; k < end; ++k) {
                progress.check();
                const std::int32_t name = names_[k];
                double sum = 0.0;
                for_terms(name, [&](std::int64_t term) {
                    for (const double x : part_of(name, term)) sum += x * x;
                });
                for_coarse(name, [&](std::int64_t own, std::int64_t other) {
                    if (cluster_[blocks_.coarse[other]] == name) sum += coarse_product(own, other);
                });
                self_[name] = sum;
            }
        });
    }

    // Pairs of the dense term's members of which the first is of the cluster.
    template <class Visit>
    void for_coarse(std::int32_t name, Visit&& visit) const {
        for (std::int32_t at = name; at >= 0; at = next_[at])
            if (coarse_of_[at] > 0)
                for (std::int64_t other = 0; other < blocks_.coarse_count; ++other) visit(coarse_of_[at] - 1, other);
    }

    void mark_over(const base::Progress& progress) {
        energy_.runtime_.parallel.for_chunks(size_, 8 * signs_a_task, progress,
                                             [&](std::int64_t begin, std::int64_t end) {
                                                 for (std::int64_t term = begin; term < end; ++term) {
                                                     const std::int32_t* set = blocks_.set + term * blocks_.set_size;
                                                     if (over_[term] != 0 || set[0] < 0) continue;
                                                     bool one = true;
                                                     for (std::int64_t k = 1; k < blocks_.set_size && one; ++k)
                                                         one = cluster_[set[k]] == cluster_[set[0]];
                                                     over_[term] = one ? 1 : 0;
                                                 }
                                             });
    }

    void find_partners(const base::Progress& progress) {
        mark_over(progress);
        energy_.runtime_.parallel.for_chunks(names_.size(), signs_a_task, [&](std::int64_t begin, std::int64_t end) {
            CouplingTable table(energy_.runtime_.memory);
            for (std::int64_t k = begin; k < end; ++k) find_partner(names_[k], table, progress);
        });
    }

    void find_partner(std::int32_t name, CouplingTable& table, const base::Progress& progress) {
        table.clear();
        std::int64_t terms = 0; // many of a large cluster
        for_terms(name, [&](std::int64_t term) {
            if (terms++ % terms_a_look == 0) progress.check();
            const Four own = part_of(name, term);
            for (std::int64_t e = term * blocks_.set_size; e < (term + 1) * blocks_.set_size; ++e) {
                const std::int32_t other = cluster_[blocks_.set[e]];
                if (other == name) continue;
                const Four part = energy_.part(e, signs_);
                table.add(other, own[0] * part[0] + own[1] * part[1] + own[2] * part[2] + own[3] * part[3]);
            }
        });
        for_coarse(name, [&](std::int64_t own, std::int64_t other) {
            const std::int32_t there = cluster_[blocks_.coarse[other]];
            if (there != name) table.add(there, coarse_product(own, other));
        });
        partner_[name] = -1;
        double best = -1.0;
        table.for_each([&](std::int32_t other, double coupling) {
            const double strength = std::abs(coupling) / std::sqrt(std::max(self_[name] * self_[other], 1e-300));
            if (strength < best || (strength == best && other > partner_[name])) return;
            best = strength;
            partner_[name] = other;
            coupling_[name] = coupling;
            strength_[name] = strength;
        });
    }

    // Those that are each other's nearest, and of those that are not the ones whose coupling leaves little doubt, and
    // small ones beside a large one, which would have to wait for their turn.
    void join_partners() {
        for (const std::int32_t name : names_) joined_[name] = {name, false};
        for (const bool mutual_ones : {true, false})
            for (const std::int32_t name : names_) {
                const std::int32_t other = partner_[name];
                if (other < 0) continue;
                const bool mutual = partner_[other] == name;
                if (mutual != mutual_ones || (mutual && other < name)) continue;
                const bool small = size_ > careful && large * count_[name] < count_[other];
                if (mutual || small || strength_[name] > sure_strength) join(name, other);
            }
        base::Array<std::int32_t> left(energy_.runtime_.memory);
        for (const std::int32_t name : names_)
            if (joined_[name].to == name) left.push_back(name);
        names_ = std::move(left);
    }

    struct Joined {
        std::int32_t to; // in this round; a root is joined to itself
        bool turned;     // against it
    };
    [[nodiscard]] Joined root_of(std::int32_t name) const noexcept {
        Joined result{name, false};
        while (joined_[result.to].to != result.to) {
            result.turned ^= joined_[result.to].turned;
            result.to = joined_[result.to].to;
        }
        return result;
    }

    // The coupling is that of the signs at the round's beginning.
    void join(std::int32_t one, std::int32_t two) noexcept {
        Joined a = root_of(one);
        Joined b = root_of(two);
        if (a.to == b.to) return;
        if (a.to > b.to) std::swap(a, b);
        const bool turn = (coupling_[one] > 0.0) != (a.turned != b.turned);
        self_[a.to] = std::max(self_[a.to] + self_[b.to] - 2.0 * std::abs(coupling_[one]), 1e-300);
        for (std::int32_t at = b.to; at >= 0; at = next_[at]) {
            cluster_[at] = a.to;
            if (turn) signs_[at] = static_cast<std::int8_t>(-signs_[at]);
        }
        append(a.to, b.to);
        count_[a.to] += count_[b.to];
        joined_[b.to] = {a.to, turn};
    }

    const SignEnergy& energy_;
    fit::Preconditioner::Blocks blocks_;
    std::int64_t size_;
    base::Array<std::int32_t> cluster_; // named for its first member
    base::Array<std::int32_t> next_;    // member; -1: the last
    base::Array<std::int32_t> last_;    // member, by name
    Signs signs_;
    base::Array<double> self_; // energy of the members alone, by name, as are the next two
    base::Array<std::int32_t> partner_;
    base::Array<double> coupling_;
    base::Array<double> strength_;
    base::Array<std::int64_t> count_; // of members
    base::Array<Joined> joined_;
    base::Array<std::uint8_t> over_;      // of each term
    base::Array<std::int64_t> coarse_of_; // 1 + number in the dense term; 0: none
    base::Array<std::int32_t> names_;
};

// Totals of all terms, and what turning a cluster would do to them.
class SignEnergy::Turning {
public:
    Turning(const SignEnergy& energy, Signs& signs, const base::Progress& progress = {})
        : energy_(energy), blocks_(energy.terms_.blocks), signs_(signs),
          total_(energy.runtime_.memory, 4 * energy.size_),
          coarse_total_(energy.runtime_.memory, blocks_.coarse_columns),
          coarse_part_(energy.runtime_.memory, blocks_.coarse_columns), seen_(energy.runtime_.memory, energy.size_),
          coarse_of_(energy.runtime_.memory, energy.size_), terms_(energy.runtime_.memory),
          part_(energy.runtime_.memory, 4 * energy.size_) {
        for (std::int64_t k = 0; k < blocks_.coarse_count; ++k) {
            coarse_of_[blocks_.coarse[k]] = k + 1;
            add_coarse(k, coarse_total_);
        }
        const auto& parallel = energy.runtime_.parallel;
        parallel.for_chunks(energy.size_, signs_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t term = begin; term < end; ++term) {
                if (blocks_.set[term * blocks_.set_size] < 0) continue;
                for (std::int64_t e = term * blocks_.set_size; e < (term + 1) * blocks_.set_size; ++e) {
                    const Four part = energy_.part(e, signs_);
                    for (std::size_t c = 0; c < 4; ++c) total_[4 * term + static_cast<std::int64_t>(c)] += part[c];
                }
            }
        });
    }

    [[nodiscard]] double energy() const noexcept {
        double sum = 0.0;
        for (const double t : total_) sum += t * t;
        for (const double t : coarse_total_) sum += t * t;
        return sum;
    }

    // Turns the members if half what that takes off the energy is more than this share of their own.
    bool turn(std::span<const std::int32_t> members, double least) {
        ++visit_;
        terms_.clear();
        std::fill(coarse_part_.begin(), coarse_part_.end(), 0.0);
        bool coarse = false;
        for (const std::int32_t at : members) {
            for (std::int64_t u = blocks_.use_begin[at]; u < blocks_.use_begin[at + 1]; ++u) add(blocks_.use[u]);
            if (coarse_of_[at] == 0) continue;
            add_coarse(coarse_of_[at] - 1, coarse_part_);
            coarse = true;
        }
        double across = 0.0;
        double self = 0.0;
        const auto count = [&](double part, double total) {
            across += part * (total - part);
            self += part * part;
        };
        for (const std::int32_t term : terms_)
            for (std::int64_t c = 4 * static_cast<std::int64_t>(term); c < 4 * (std::int64_t{term} + 1); ++c)
                count(part_[c], total_[c]);
        for (std::int64_t c = 0; coarse && c < blocks_.coarse_columns; ++c) count(coarse_part_[c], coarse_total_[c]);
        if (!(across > least * self)) return false;
        for (const std::int32_t term : terms_)
            for (std::int64_t c = 4 * static_cast<std::int64_t>(term); c < 4 * (std::int64_t{term} + 1); ++c)
                total_[c] -= 2.0 * part_[c];
        for (std::int64_t c = 0; coarse && c < blocks_.coarse_columns; ++c) coarse_total_[c] -= 2.0 * coarse_part_[c];
        for (const std::int32_t at : members) signs_[at] = static_cast<std::int8_t>(-signs_[at]);
        return true;
    }

private:
    void add(std::int64_t element) {
        const auto term = static_cast<std::int32_t>(element / blocks_.set_size);
        double* sum = part_.data() + 4 * static_cast<std::int64_t>(term);
        if (seen_[term] != visit_) {
            seen_[term] = visit_;
            terms_.push_back(term);
            std::fill_n(sum, 4, 0.0);
        }
        const Four part = energy_.part(element, signs_);
        for (std::size_t c = 0; c < 4; ++c) sum[c] += part[c];
    }

    void add_coarse(std::int64_t k, base::Array<double>& sum) const noexcept {
        const double* a = energy_.terms_.coarse_add.data() + k * blocks_.coarse_columns;
        for (std::int64_t c = 0; c < blocks_.coarse_columns; ++c) sum[c] += signs_[blocks_.coarse[k]] * a[c];
    }

    const SignEnergy& energy_;
    fit::Preconditioner::Blocks blocks_;
    Signs& signs_;
    base::Array<double> total_;
    base::Array<double> coarse_total_;
    base::Array<double> coarse_part_;
    base::Array<std::int64_t> seen_; // by which visit
    base::Array<std::int64_t> coarse_of_;
    base::Array<std::int32_t> terms_; // of the members
    base::Array<double> part_;        // theirs in these
    std::int64_t visit_ = 0;
};

SignEnergy::SignEnergy(const base::Runtime& runtime, const fit::HermiteEnergy& energy, const geometry::VecArray& normal,
                       const base::Progress& progress)
    : runtime_(runtime), terms_(energy.terms(normal, progress)), size_(energy.size()) {}

double SignEnergy::of(const Signs& signs, const base::Progress& progress) const {
    Signs copy(runtime_.memory, size_);
    std::copy_n(signs.data(), size_, copy.data());
    return Turning(*this, copy, progress).energy();
}

Signs SignEnergy::agglomerate(const base::Array<std::int32_t>* first, const Signs* signs, Levels& levels,
                              const base::Progress& progress) const {
    return Agglomeration(*this, first, signs, progress).run(levels, progress);
}

base::Array<std::uint8_t> SignEnergy::turn(const Groups& groups, double most, Signs& signs) const {
    Turning turning(*this, signs);
    base::Array<std::uint8_t> turned(runtime_.memory);
    for (std::int64_t k = 0; k < groups.size(); ++k) turned.push_back(turning.turn(groups.of(k), -most) ? 1 : 0);
    return turned;
}

std::int64_t SignEnergy::improve(const Levels& levels, Signs& signs, const base::Progress& progress) const {
    Turning turning(*this, signs, progress);
    std::int64_t turned = 0;
    base::Array<std::int32_t> order(runtime_.memory, size_);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        const std::int64_t before = turned;
        for (std::size_t level = levels.cluster.size() + 1; level-- > 0;) {
            progress.check();
            for (std::int64_t at = 0; at < size_; ++at) order[at] = static_cast<std::int32_t>(at);
            const base::Array<std::int32_t>* cluster = level > 0 ? &levels.cluster[level - 1] : nullptr;
            if (cluster != nullptr)
                base::sort_long(
                    order.begin(), order.end(),
                    [&](std::int32_t a, std::int32_t b) {
                        return (*cluster)[a] < (*cluster)[b] || ((*cluster)[a] == (*cluster)[b] && a < b);
                    },
                    progress);
            std::int64_t looked = 0;
            for (std::int64_t begin = 0; begin < size_;) {
                if (begin >= looked) {
                    progress.check();
                    looked = begin + places_a_look;
                }
                std::int64_t end = begin + 1;
                while (cluster != nullptr && end < size_ && (*cluster)[order[end]] == (*cluster)[order[begin]]) ++end;
                if (turning.turn({order.data() + begin, static_cast<std::size_t>(end - begin)}, least_gain))
                    turned += end - begin;
                begin = end;
            }
        }
        if (turned == before) break;
    }
    return turned;
}

} // namespace hrbfnpr::orient

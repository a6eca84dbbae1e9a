#include "Analysis/NestedDissection.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace idiophone {
namespace {

using Pattern = Eigen::SparseMatrix<double>;
using Nodes = std::vector<int>;

constexpr std::size_t wholeUpTo = 200; ///< unknowns of a part that is not cut
constexpr int smoothingSweeps = 8;
constexpr std::array cutShares{0.5, 0.45, 0.55, 0.4, 0.6, 0.35, 0.65};

class Dissection {
public:
    explicit Dissection(const Pattern& graph)
        : graph_(graph), part_(graph.cols(), 0), mark_(graph.cols(), -1), key_(graph.cols()),
          smoothed_(graph.cols()), match_(graph.cols()), reachedFrom_(graph.cols()),
          visited_(graph.cols(), -1) {}

    Nodes order();

private:
    struct Halves {
        Nodes first, second, separator;
    };

    template <class Visit>
    void forNeighbours(int node, const Visit& visit) const {
        for (Pattern::InnerIterator entry(graph_, node); entry; ++entry)
            if (const auto other = static_cast<int>(entry.row());
                other != node && part_[other] == part_[node])
                visit(other);
    }
    Nodes reached(int start);
    Halves cut(const Nodes& nodes);
    Nodes separatorOf(const Nodes& nodes);
    bool findPartner(int root);
    Nodes orderWhole(const Nodes& nodes);
    void makePart(const Nodes& nodes) {
        ++parts_;
        for (const int node : nodes)
            part_[node] = parts_;
    }

    const Pattern& graph_;
    std::vector<int> part_; ///< of each node; negative once it is in the order
    std::vector<int> mark_; ///< a node's distance or half, within its part
    std::vector<double> key_, smoothed_;
    std::vector<int> match_, reachedFrom_, visited_; ///< of the search for partners
    int parts_ = 0, round_ = 0;
};

/// Returns the connected nodes by their distance from `start`, which `mark_` then holds.
Nodes Dissection::reached(int start) {
    Nodes nodes{start};
    mark_[start] = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        forNeighbours(nodes[i], [&](int other) {
            if (mark_[other] < 0) {
                mark_[other] = mark_[nodes[i]] + 1;
                nodes.push_back(other);
            }
        });
    return nodes;
}

/// Finds partners in the second half for a node of the first and for those it displaces. Marks the
/// nodes of alternating paths from it as visited. Returns false if it gets no partner.
bool Dissection::findPartner(int root) {
    Nodes firsts{root};
    visited_[root] = round_;
    int end = -1;
    for (std::size_t i = 0; i < firsts.size() && end < 0; ++i)
        forNeighbours(firsts[i], [&](int other) {
            if (end >= 0 || mark_[other] == 0 || visited_[other] == round_)
                return;
            visited_[other] = round_;
            reachedFrom_[other] = firsts[i];
            if (match_[other] < 0) {
                end = other;
            } else {
                visited_[match_[other]] = round_;
                firsts.push_back(match_[other]);
            }
        });
    for (int second = end; second >= 0;) {
        const int first = reachedFrom_[second];
        match_[second] = first;
        second = std::exchange(match_[first], second);
    }
    return end >= 0;
}

/// Returns the fewest nodes that cover all edges between the halves (König's theorem).
Nodes Dissection::separatorOf(const Nodes& nodes) {
    for (const int node : nodes)
        match_[node] = -1;
    ++round_;
    // After a search without success its nodes stay visited, because later ones would end there.
    for (const int node : nodes)
        if (mark_[node] == 0 && findPartner(node))
            ++round_;
    ++round_;
    for (const int node : nodes)
        if (mark_[node] == 0 && match_[node] < 0)
            findPartner(node);
    Nodes separator;
    for (const int node : nodes)
        if (match_[node] >= 0 && (visited_[node] == round_) == (mark_[node] == 1))
            separator.push_back(node);
    return separator;
}

/// Cuts a part between two distant nodes, or between what is connected and what is not.
Dissection::Halves Dissection::cut(const Nodes& nodes) {
    Halves halves;
    int end = nodes.front();
    for (const int sign : {0, -1, 1}) {
        for (const int node : nodes)
            mark_[node] = -1;
        Nodes byDistance = reached(end);
        if (byDistance.size() < nodes.size()) {
            std::ranges::copy_if(nodes, std::back_inserter(halves.first),
                                 [&](int node) { return mark_[node] < 0; });
            halves.second = std::move(byDistance);
            return halves;
        }
        for (const int node : nodes)
            key_[node] = sign * mark_[node] + (sign > 0 ? key_[node] : 0);
        end = byDistance.back();
    }
    // Distances are whole numbers. Means over neighbours make the cut flat.
    for (int sweep = 0; sweep < smoothingSweeps; ++sweep) {
        for (const int node : nodes) {
            double sum = key_[node];
            int count = 1;
            forNeighbours(node, [&](int other) {
                sum += key_[other];
                ++count;
            });
            smoothed_[node] = sum / count;
        }
        for (const int node : nodes)
            key_[node] = smoothed_[node];
    }
    Nodes sorted = nodes;
    std::ranges::sort(sorted, {}, [&](int node) { return std::pair(key_[node], node); });
    // Uneven halves are worth a smaller separator, as in a neck of the body.
    const auto size = static_cast<double>(nodes.size());
    const auto divide = [&](double share) {
        for (std::size_t i = 0; i < sorted.size(); ++i)
            mark_[sorted[i]] = static_cast<double>(i) < share * size ? 0 : 1;
        return separatorOf(sorted);
    };
    double best = 0, lowest = std::numeric_limits<double>::infinity();
    for (const double share : cutShares) {
        const double cost = static_cast<double>(divide(share).size()) / (share * (1 - share));
        if (cost < lowest) {
            lowest = cost;
            best = share;
        }
    }
    halves.separator = divide(best);
    for (const int node : halves.separator)
        mark_[node] = 2;
    for (const int node : sorted)
        if (mark_[node] < 2)
            (mark_[node] == 0 ? halves.first : halves.second).push_back(node);
    return halves;
}

Nodes Dissection::orderWhole(const Nodes& nodes) {
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
        mark_[nodes[i]] = i;
    std::vector<Eigen::Triplet<double>> entries;
    for (const int node : nodes) {
        entries.emplace_back(mark_[node], mark_[node], 1);
        forNeighbours(node, [&](int other) { entries.emplace_back(mark_[other], mark_[node], 1); });
    }
    const auto count = static_cast<Eigen::Index>(nodes.size());
    Pattern places(count, count);
    places.setFromTriplets(entries.begin(), entries.end());
    Nodes ordered = minimumDegreeOrder(places);
    for (int& node : ordered)
        node = nodes[node];
    return ordered;
}

Nodes Dissection::order() {
    Nodes all(graph_.cols());
    std::iota(all.begin(), all.end(), 0);
    // The order is made from its end: separators come after both halves.
    std::vector<Nodes> waiting{std::move(all)};
    Nodes backwards;
    while (!waiting.empty()) {
        const Nodes nodes = std::move(waiting.back());
        waiting.pop_back();
        makePart(nodes);
        if (nodes.size() <= wholeUpTo) {
            const Nodes ordered = orderWhole(nodes);
            backwards.insert(backwards.end(), ordered.rbegin(), ordered.rend());
            continue;
        }
        Halves halves = cut(nodes);
        backwards.insert(backwards.end(), halves.separator.rbegin(), halves.separator.rend());
        makePart(halves.separator);
        waiting.push_back(std::move(halves.first));
        waiting.push_back(std::move(halves.second));
    }
    return {backwards.rbegin(), backwards.rend()};
}

} // namespace

std::vector<int> minimumDegreeOrder(const Eigen::SparseMatrix<double>& symmetric) {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
    Eigen::AMDOrdering<int>()(symmetric, permutation);
    return {permutation.indices().begin(), permutation.indices().end()};
}

std::vector<int> nestedDissectionOrder(const Eigen::SparseMatrix<double>& symmetric) {
    return Dissection(symmetric).order();
}

} // namespace idiophone

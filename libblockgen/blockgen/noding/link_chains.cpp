#include "blockgen/noding/link_chains.hpp"

#include <algorithm>
#include <numeric>

#include "blockgen/noding/bucket_grid.hpp"

namespace rockslope::blockgen {

namespace {

constexpr std::int64_t cell_width = 2;  // in fine-grid units; edges end at the centres of cells

/// Two successive cells of a chain, and one source along them.
struct Link {
    std::int32_t a, b;
    std::int32_t source;
    bool reversed, is_changed;

    bool is_before(const Link& other) const {
        if (b != other.b) return b < other.b;
        if (source != other.source) return source < other.source;
        return reversed < other.reversed;
    }
};

/// Collects the cells that occur in a chain. @return per cell its number in `used`, or -1.
std::vector<std::int32_t> number_used_cells(const SnappedChains& chains, std::vector<GridPoint>& used) {
    std::vector<std::int32_t> number(chains.cells.size(), -1);
    for (std::size_t k = 0; k < chains.size(); ++k)
        if (const auto chain = chains.chain(k); chain.size() > 1)
            for (const std::int32_t cell : chain) number[cell] = 0;
    used.clear();
    for (std::size_t c = 0; c < number.size(); ++c) {
        if (number[c] < 0) continue;
        number[c] = used.size();
        used.push_back(chains.cells[c]);
    }
    return number;
}

template <class Visit>
void for_each_link(const SnappedChains& chains, const LineSources& along,
                   const std::vector<std::int32_t>& number, const Visit& visit) {
    for (std::size_t k = 0; k < chains.size(); ++k) {
        const auto chain = chains.chain(k);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const std::int32_t a = number[chain[i]];
            const std::int32_t b = number[chain[i + 1]];
            for (std::int32_t s = along.first[k]; s < along.first[k + 1]; ++s) {
                const EdgeSource& source = along.sources[s];
                visit(Link{std::min(a, b), std::max(a, b), source.source, source.reversed != (b < a),
                           chain.size() != 2});
            }
        }
    }
}

/// All links, grouped by their first vertex (counting sort) and sorted within each group.
std::vector<Link> sorted_links(const SnappedChains& chains, const LineSources& along,
                               const std::vector<std::int32_t>& number, std::size_t vertices) {
    std::vector<std::int32_t> first(vertices + 1, 0);
    for_each_link(chains, along, number, [&](const Link& link) { ++first[link.a + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Link> links(first.back());
    std::vector<std::int32_t> fill(first.begin(), first.end() - 1);
    for_each_link(chains, along, number, [&](const Link& link) { links[fill[link.a]++] = link; });
    for (std::size_t v = 0; v < vertices; ++v)
        std::sort(links.begin() + first[v], links.begin() + first[v + 1],
                  [](const Link& l, const Link& m) { return l.is_before(m); });
    return links;
}

/// The changed edges and the edges that share a bucket with one; all edges when more than a quarter changed.
/// Two edges that cross or nearly touch share a bucket.
std::vector<std::int32_t> edges_near_changed(std::span<const FineSegment> lines,
                                             std::span<const char> changed) {
    std::vector<std::int32_t> edges(lines.size());
    std::iota(edges.begin(), edges.end(), 0);
    const auto all = static_cast<std::ptrdiff_t>(lines.size());
    if (changed.empty() || 4 * std::count(changed.begin(), changed.end(), 1) > all) return edges;
    const BucketGrid grid(lines, cell_width, changed);
    std::erase_if(edges, [&](std::int32_t e) {
        const std::size_t k = e;
        return !changed[k] && !grid.overlaps_occupied_bucket(lines[k]);
    });
    return edges;
}

}  // namespace

std::vector<char> link_chains(const SnappedChains& chains, const LineSources& along, NodedEdges& network) {
    std::vector<GridPoint> vertices;
    const std::vector<std::int32_t> number = number_used_cells(chains, vertices);
    const std::vector<Link> links = sorted_links(chains, along, number, vertices.size());
    network.vertices = std::move(vertices);
    network.edges.clear();
    network.first_source = {0};
    network.sources.clear();
    network.sources.reserve(links.size());
    std::vector<char> changed;
    for (const Link& link : links) {
        const std::pair edge(link.a, link.b);
        if (network.edges.empty() || network.edges.back() != edge) {
            network.edges.push_back(edge);
            network.first_source.push_back(0);
            changed.push_back(0);
        }
        network.sources.push_back({link.source, link.reversed});
        network.first_source.back() = network.sources.size();
        changed.back() = changed.back() || link.is_changed;
    }
    return changed;
}

SnapRoundingPass snap_round_edges(std::span<const GridPoint> vertices,
                                  std::span<const std::pair<std::int32_t, std::int32_t>> edges,
                                  std::span<const char> changed) {
    std::vector<FineSegment> lines;
    lines.reserve(edges.size());
    const auto middle = [&](std::int32_t v) {
        const GridPoint& p = vertices[v];
        return GridPoint{cell_width * p.x, cell_width * p.y};
    };
    for (const auto& [a, b] : edges) lines.push_back({middle(a), middle(b)});

    SnapRoundingPass round;
    round.edges = edges_near_changed(lines, changed);
    std::vector<char> is_end(vertices.size(), 0);
    for (std::size_t k = 0; k < round.edges.size(); ++k) {
        const std::size_t e = round.edges[k];
        lines[k] = lines[e];
        is_end[edges[e].first] = is_end[edges[e].second] = 1;
    }
    lines.resize(round.edges.size());
    std::vector<GridPoint> ends;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        if (is_end[v]) ends.push_back(vertices[v]);
    round.chains = snap_round(lines, cell_width, std::move(ends));
    return round;
}

SnappedChains chains_of_all_edges(const SnapRoundingPass& round, const NodedEdges& network) {
    SnappedChains all;
    const std::vector<GridPoint>&old = network.vertices, &hot = round.chains.cells;
    all.cells.reserve(old.size() + hot.size());
    std::set_union(old.begin(), old.end(), hot.begin(), hot.end(), std::back_inserter(all.cells));
    const auto numbers_of = [&](const std::vector<GridPoint>& part) {
        std::vector<std::int32_t> number;
        number.reserve(part.size());
        std::size_t k = 0;
        for (const GridPoint& p : part) {
            while (all.cells[k] != p) ++k;
            number.push_back(k);
        }
        return number;
    };
    const std::vector<std::int32_t> number_of_old = numbers_of(old), number_of_hot = numbers_of(hot);
    all.first.reserve(network.edges.size() + 1);
    all.items.reserve(2 * network.edges.size() + round.chains.items.size());
    std::size_t next = 0;
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
        if (next < round.edges.size() && round.edges[next] == static_cast<std::int32_t>(e)) {
            for (const std::int32_t cell : round.chains.chain(next++))
                all.items.push_back(number_of_hot[cell]);
        } else {
            const auto& [a, b] = network.edges[e];
            all.items.push_back(number_of_old[a]);
            all.items.push_back(number_of_old[b]);
        }
        all.first.push_back(static_cast<std::int64_t>(all.items.size()));
    }
    return all;
}

}  // namespace rockslope::blockgen

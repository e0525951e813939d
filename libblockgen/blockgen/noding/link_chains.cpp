#include "blockgen/noding/link_chains.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "blockgen/noding/bucket_grid.hpp"
#include "blockgen/noding/cells.hpp"
#include "common/base/parallel_collect.hpp"

namespace rockslope::blockgen {

namespace {

constexpr std::int64_t cell_width = 2;  // in fine-grid units; edges end at the centres of cells

/// Two successive cells of a chain, and one source along them.
struct Link {
    NodeIndex a, b;
    SourceIndex source;
    bool reversed, is_changed;

    bool is_before(const Link& other) const {
        if (b != other.b) return b < other.b;
        if (source != other.source) return source < other.source;
        return reversed < other.reversed;
    }
};

/// Collects the cells that occur in a chain as vertices. @return the vertex at each cell, or none.
PerCell<NodeIndex> vertices_at_cells(const SnappedChains& chains, PerNode<GridPoint>& vertices) {
    PerCell<NodeIndex> vertex_at(chains.cells.size(), NodeIndex::none());
    for (const SegmentIndex k : indices<SegmentIndex>(chains.size()))
        if (const auto chain = chains.chain(k); chain.size() > 1)
            for (const CellIndex cell : chain) vertex_at[cell] = 0;
    vertices.clear();
    for (const CellIndex c : vertex_at.indices()) {
        if (!vertex_at[c].exists()) continue;
        vertex_at[c] = vertices.size();
        vertices.push_back(chains.cells[c]);
    }
    return vertex_at;
}

template <class Visit>
void for_each_link(const SnappedChains& chains, const LineSources& along, const PerCell<NodeIndex>& vertex_at,
                   const Visit& visit) {
    for (const SegmentIndex k : indices<SegmentIndex>(chains.size())) {
        const auto chain = chains.chain(k);
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const NodeIndex a = vertex_at[chain[i]], b = vertex_at[chain[i + 1]];
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
                               const PerCell<NodeIndex>& vertex_at, std::size_t vertices,
                               const ThreadPool& pool) {
    PerNode<std::int32_t> first(vertices + 1, 0);
    for_each_link(chains, along, vertex_at, [&](const Link& link) { ++first[link.a + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Link> links(first.back());
    PerNode<std::int32_t> fill(first.begin(), first.end() - 1);
    for_each_link(chains, along, vertex_at, [&](const Link& link) { links[fill[link.a]++] = link; });
    pool.parallel_for(vertices, [&](std::size_t begin, std::size_t end) {
        for (const NodeIndex v : indices<NodeIndex>(begin, end))
            std::sort(links.begin() + first[v], links.begin() + first[v + 1],
                      [](const Link& l, const Link& m) { return l.is_before(m); });
    });
    return links;
}

/// The changed edges and the edges that share a bucket with one, ascending; nothing, which stands for all
/// edges, when more than a quarter changed. Two edges that cross or nearly touch share a bucket.
std::optional<std::vector<EdgeIndex>> edges_near_changed(EdgeSpan<const FineSegment> lines,
                                                         EdgeSpan<const char> changed,
                                                         const ThreadPool& pool) {
    const auto all = static_cast<std::ptrdiff_t>(lines.size());
    if (changed.empty() || 4 * std::count(changed.begin(), changed.end(), 1) > all) return std::nullopt;
    const BucketGrid grid(std::span<const FineSegment>(lines), cell_width, std::span<const char>(changed),
                          pool);
    const auto collect = [&](std::size_t begin, std::size_t end, std::vector<EdgeIndex>& edges) {
        for (const EdgeIndex e : indices<EdgeIndex>(begin, end))
            if (changed[e] || grid.overlaps_occupied_bucket(lines[e])) edges.push_back(e);
    };
    return parallel_collect<EdgeIndex>(pool, lines.size(), collect);
}

/// The vertices at which edges end.
std::vector<GridPoint> ends_of(NodeSpan<const GridPoint> vertices, EdgeSpan<const EdgeEnds> edges,
                               const std::optional<std::vector<EdgeIndex>>& some) {
    PerNode<char> is_end(vertices.size(), 0);
    if (some) {
        for (const EdgeIndex e : *some) is_end[edges[e].first] = is_end[edges[e].second] = 1;
    } else {
        for (const auto& [a, b] : edges) is_end[a] = is_end[b] = 1;
    }
    std::vector<GridPoint> ends;
    ends.reserve(std::count(is_end.begin(), is_end.end(), 1));
    for (const NodeIndex v : vertices.indices())
        if (is_end[v]) ends.push_back(vertices[v]);
    return ends;
}

}  // namespace

PerEdge<char> link_chains(const SnappedChains& chains, const LineSources& along, NodedEdges& network,
                          const ThreadPool& pool) {
    PerNode<GridPoint> vertices;
    const PerCell<NodeIndex> vertex_at = vertices_at_cells(chains, vertices);
    const std::vector<Link> links = sorted_links(chains, along, vertex_at, vertices.size(), pool);
    network.vertices = std::move(vertices);
    network.edges.clear();
    network.first_source = {0};
    network.sources.clear();
    network.edges.reserve(links.size());
    network.first_source.reserve(links.size() + 1);
    network.sources.reserve(links.size());
    PerEdge<char> changed;
    changed.reserve(links.size());
    for (const Link& link : links) {
        const EdgeEnds edge(link.a, link.b);
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

SnapRoundingPass snap_round_edges(NodeSpan<const GridPoint> vertices, EdgeSpan<const EdgeEnds> edges,
                                  EdgeSpan<const char> changed, const ThreadPool& pool) {
    PerEdge<FineSegment> lines(edges.size());
    pool.parallel_for(edges.size(), [&](std::size_t begin, std::size_t end) {
        for (const EdgeIndex e : indices<EdgeIndex>(begin, end))
            lines[e] = {centre_of(vertices[edges[e].first], cell_width),
                        centre_of(vertices[edges[e].second], cell_width)};
    });
    const auto some = edges_near_changed(lines, changed, pool);
    const std::vector<GridPoint> ends = ends_of(vertices, edges, some);
    if (some) {
        for (std::size_t k = 0; k < some->size(); ++k) lines[k] = lines[(*some)[k]];
        lines.resize(some->size());
    }
    BentSegments bent = bend_segments(std::span<const FineSegment>(lines), cell_width, ends, pool);
    SnapRoundingPass round;
    round.edges.reserve(bent.segments.size());
    for (const SegmentIndex k : bent.segments)
        round.edges.push_back(some ? (*some)[k] : EdgeIndex(k.value()));
    round.chains = std::move(bent.chains);
    return round;
}

SnappedChains chains_of_all_edges(const SnapRoundingPass& round, const NodedEdges& network) {
    SnappedChains all;
    const PerNode<GridPoint>& old = network.vertices;
    const PerCell<GridPoint>& hot = round.chains.cells;
    all.cells.reserve(old.size() + hot.size());
    std::set_union(old.begin(), old.end(), hot.begin(), hot.end(), std::back_inserter(all.cells));
    const auto cells_of = [&](const std::vector<GridPoint>& part) {
        std::vector<CellIndex> cells;
        cells.reserve(part.size());
        CellIndex c = 0;
        for (const GridPoint& p : part) {
            while (all.cells[c] != p) ++c;
            cells.push_back(c);
        }
        return cells;
    };
    const PerNode<CellIndex> cell_of_old = cells_of(old);
    const PerCell<CellIndex> cell_of_hot = cells_of(hot);
    all.first.reserve(network.edges.size() + 1);
    all.items.reserve(2 * network.edges.size() + round.chains.items.size());
    SegmentIndex next = 0;
    for (const EdgeIndex e : network.edges.indices()) {
        if (next < round.edges.size() && round.edges[next] == e) {
            for (const CellIndex cell : round.chains.chain(next++)) all.items.push_back(cell_of_hot[cell]);
        } else {
            const auto& [a, b] = network.edges[e];
            all.items.push_back(cell_of_old[a]);
            all.items.push_back(cell_of_old[b]);
        }
        all.first.push_back(all.items.size());
    }
    return all;
}

}  // namespace rockslope::blockgen

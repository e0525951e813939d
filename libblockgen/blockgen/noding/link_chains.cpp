#include "blockgen/noding/link_chains.hpp"

#include <algorithm>
#include <numeric>

#include "blockgen/noding/bucket_grid.hpp"

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
                               const PerCell<NodeIndex>& vertex_at, std::size_t vertices) {
    PerNode<std::int32_t> first(vertices + 1, 0);
    for_each_link(chains, along, vertex_at, [&](const Link& link) { ++first[link.a + 1]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Link> links(first.back());
    PerNode<std::int32_t> fill(first.begin(), first.end() - 1);
    for_each_link(chains, along, vertex_at, [&](const Link& link) { links[fill[link.a]++] = link; });
    for (const NodeIndex v : indices<NodeIndex>(vertices))
        std::sort(links.begin() + first[v], links.begin() + first[v + 1],
                  [](const Link& l, const Link& m) { return l.is_before(m); });
    return links;
}

/// The changed edges and the edges that share a bucket with one; all edges when more than a quarter changed.
/// Two edges that cross or nearly touch share a bucket.
std::vector<EdgeIndex> edges_near_changed(EdgeSpan<const FineSegment> lines, EdgeSpan<const char> changed) {
    std::vector<EdgeIndex> edges(lines.size());
    std::iota(edges.begin(), edges.end(), EdgeIndex(0));
    const auto all = static_cast<std::ptrdiff_t>(lines.size());
    if (changed.empty() || 4 * std::count(changed.begin(), changed.end(), 1) > all) return edges;
    const BucketGrid grid(std::span<const FineSegment>(lines), cell_width, std::span<const char>(changed));
    std::erase_if(edges,
                  [&](EdgeIndex e) { return !changed[e] && !grid.overlaps_occupied_bucket(lines[e]); });
    return edges;
}

}  // namespace

PerEdge<char> link_chains(const SnappedChains& chains, const LineSources& along, NodedEdges& network) {
    PerNode<GridPoint> vertices;
    const PerCell<NodeIndex> vertex_at = vertices_at_cells(chains, vertices);
    const std::vector<Link> links = sorted_links(chains, along, vertex_at, vertices.size());
    network.vertices = std::move(vertices);
    network.edges.clear();
    network.first_source = {0};
    network.sources.clear();
    network.sources.reserve(links.size());
    PerEdge<char> changed;
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
                                  EdgeSpan<const char> changed) {
    PerEdge<FineSegment> lines;
    lines.reserve(edges.size());
    const auto middle = [&](NodeIndex v) {
        const GridPoint& p = vertices[v];
        return GridPoint{cell_width * p.x, cell_width * p.y};
    };
    for (const auto& [a, b] : edges) lines.push_back({middle(a), middle(b)});

    SnapRoundingPass round;
    round.edges = edges_near_changed(lines, changed);
    PerNode<char> is_end(vertices.size(), 0);
    std::size_t kept = 0;
    for (const EdgeIndex e : round.edges) {
        lines[kept++] = lines[e];
        is_end[edges[e].first] = is_end[edges[e].second] = 1;
    }
    lines.resize(kept);
    std::vector<GridPoint> ends;
    for (const NodeIndex v : vertices.indices())
        if (is_end[v]) ends.push_back(vertices[v]);
    round.chains = snap_round(std::span<const FineSegment>(lines), cell_width, std::move(ends));
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

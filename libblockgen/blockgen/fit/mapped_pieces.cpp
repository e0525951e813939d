#include "blockgen/fit/mapped_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/segment.hpp"

namespace rockslope::blockgen {

namespace {

template <class Visit>
void for_each_side(const MapWindow& window, const Visit& visit) {
    for (const std::vector<Ring>* rings : {&window.outer, &window.holes})
        for (const Ring& ring : *rings)
            for (std::size_t k = 0; k < ring.size(); ++k) visit(ring[k], ring[(k + 1) % ring.size()]);
}

bool is_at_edge(const MapWindow& window, const Point& p, double edge) {
    bool near = false;
    for_each_side(
        window, [&](const Point& a, const Point& b) { near = near || distance_to_segment(p, a, b) <= edge; });
    return near;
}

/// Joins the parts of one trace within the window into pieces.
class PieceCollector {
  public:
    PieceCollector(const MapWindow& window, double edge, std::vector<MappedPiece>& pieces)
        : window_(window), edge_(edge), pieces_(pieces) {}

    void add(const Trace& trace, std::size_t number) {
        number_ = number;
        const std::vector<Point>& points = trace.points;
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const Point &a = points[k], &b = points[k + 1];
            const std::vector<double> at = stretches_within(window_, a, b, 0, 1);
            for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
                if (at[i] > 0) close();
                if (!is_open_) open(between(a, b, at[i]), k == 0 && at[i] == 0);
                piece_.b = between(a, b, at[i + 1]);
                piece_.length += (at[i + 1] - at[i]) * std::hypot(b.x - a.x, b.y - a.y);
                if (at[i + 1] < 1) close();
            }
            if (at.empty()) close();
        }
        if (is_open_ && !is_at_edge(window_, piece_.b, edge_)) ++piece_.ends;
        close();
    }

  private:
    static Point between(const Point& a, const Point& b, double t) {
        return t <= 0 ? a : t >= 1 ? b : Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    }
    void open(const Point& a, bool is_end) {
        piece_ = {a, a, 0, is_end && !is_at_edge(window_, a, edge_), number_};
        is_open_ = true;
    }
    void close() {
        if (is_open_ && piece_.length > 0) pieces_.push_back(piece_);
        is_open_ = false;
    }

    const MapWindow& window_;
    double edge_;
    std::vector<MappedPiece>& pieces_;
    MappedPiece piece_;
    bool is_open_ = false;
    std::size_t number_ = 0;
};

}  // namespace

double MapWindow::area() const {
    double area = 0;
    for (const Ring& ring : outer) area += std::abs(twice_signed_area(ring)) / 2;
    for (const Ring& ring : holes) area -= std::abs(twice_signed_area(ring)) / 2;
    return area;
}

bool MapWindow::contains(const Point& p) const {
    const auto holds = [&](const Ring& ring) { return side_of_ring(ring, p) >= 0; };
    const auto encloses = [&](const Ring& ring) { return side_of_ring(ring, p) > 0; };
    return std::any_of(outer.begin(), outer.end(), holds) &&
           std::none_of(holes.begin(), holes.end(), encloses);
}

std::vector<double> stretches_within(const MapWindow& window, const Point& a, const Point& b, double low,
                                     double high) {
    const Point u{b.x - a.x, b.y - a.y};
    std::vector<double> cuts = {low, high};
    for_each_side(window, [&](const Point& p, const Point& q) {
        const Point v{q.x - p.x, q.y - p.y}, w{p.x - a.x, p.y - a.y};
        const double denominator = u.x * v.y - u.y * v.x;
        if (denominator == 0) return;
        const double t = (w.x * v.y - w.y * v.x) / denominator, s = (w.x * u.y - w.y * u.x) / denominator;
        if (s >= 0 && s <= 1 && t > low && t < high) cuts.push_back(t);
    });
    std::sort(cuts.begin(), cuts.end());
    std::vector<double> stretches;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = (cuts[k] + cuts[k + 1]) / 2;
        if (!(cuts[k + 1] > cuts[k]) || !window.contains({a.x + middle * u.x, a.y + middle * u.y})) continue;
        if (!stretches.empty() && stretches.back() == cuts[k])
            stretches.back() = cuts[k + 1];
        else
            stretches.insert(stretches.end(), {cuts[k], cuts[k + 1]});
    }
    return stretches;
}

std::vector<MappedPiece> mapped_pieces(const std::vector<Trace>& traces, const MapWindow& window,
                                       double edge) {
    std::vector<MappedPiece> pieces;
    PieceCollector collector(window, edge, pieces);
    for (std::size_t k = 0; k < traces.size(); ++k) collector.add(traces[k], k);
    return pieces;
}

}  // namespace rockslope::blockgen

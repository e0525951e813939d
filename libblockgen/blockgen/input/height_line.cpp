#include "blockgen/input/height_line.hpp"

#include <algorithm>

namespace rockslope::blockgen {

namespace {

double height_on(const Point& p, const Point& q, double x) {
    if (x == p.x) return p.y;
    if (x == q.x) return q.y;
    return p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
}

/// Walks along a line over intervals without a point inside.
class Walk {
  public:
    explicit Walk(const HeightLine& line) : line_(line) { skip_steps(); }

    /// The x at which the straight piece ends.
    double end() const { return line_[piece_ + 1].x; }
    bool has_point_at(double x) const { return line_[piece_].x == x; }
    double height(double x) const { return height_on(line_[piece_], line_[piece_ + 1], x); }
    /// Goes on to the piece that begins at x, if one does. Returns whether there is more of the line.
    bool move_to(double x) {
        if (end() != x) return true;
        ++piece_;
        skip_steps();
        return piece_ + 1 < line_.size();
    }

  private:
    void skip_steps() {
        while (piece_ + 1 < line_.size() && line_[piece_].x == line_[piece_ + 1].x) ++piece_;
    }

    const HeightLine& line_;
    std::size_t piece_ = 0;
};

/// Two lines over an interval in which both are straight.
struct Interval {
    double left, right;             ///< x
    double a_left, a_right;         ///< heights of the first line, within the interval
    double b_left, b_right;         ///< of the second
    bool a_has_point, b_has_point;  ///< at the left end
    double rise_left() const { return a_left - b_left; }
    double rise_right() const { return a_right - b_right; }
};

template <class Visit>
void for_each_interval(const HeightLine& a, const HeightLine& b, const Visit& visit) {
    Walk of_a(a), of_b(b);
    double x = a.front().x;
    for (bool more = true; more;) {
        const double end = std::min(of_a.end(), of_b.end());
        visit(Interval{x, end, of_a.height(x), of_a.height(end), of_b.height(x), of_b.height(end),
                       of_a.has_point_at(x), of_b.has_point_at(x)});
        const bool a_goes_on = of_a.move_to(end), b_goes_on = of_b.move_to(end);
        more = a_goes_on && b_goes_on;
        x = end;
    }
}

void append(HeightLine& line, const Point& p) {
    if (line.empty() || line.back() != p) line.push_back(p);
}

/// Puts a line together from pieces of two lines.
class Selection {
  public:
    /// Chooses a line from x on, where the heights of both are given.
    void choose(bool takes_b, double x, double a, double b, bool has_point) {
        const bool changes = line.empty() || takes_b != takes_b_;
        takes_b_ = takes_b;
        if (!changes && !has_point) return;
        if (!line.empty()) append(line, {x, last_height_});
        append(line, {x, takes_b ? b : a});
    }
    /// The heights at the right end of the piece.
    void reach(double a, double b) { last_height_ = takes_b_ ? b : a; }
    void finish(double x) { append(line, {x, last_height_}); }
    bool takes_b() const { return takes_b_; }

    HeightLine line;

  private:
    bool takes_b_ = false;
    double last_height_ = 0;
};

/// @param sign +1 for the lower of both lines, -1 for the higher one.
HeightLine select(const HeightLine& a, const HeightLine& b, double sign) {
    Selection selection;
    for_each_interval(a, b, [&](const Interval& i) {
        const double left = sign * i.rise_left(), right = sign * i.rise_right();
        // The first line where both coincide; b is chosen where it is better at one end and no worse at the
        // other, or first of the two where they cross.
        const bool takes_b = left > 0 || (left == 0 && right > 0);
        selection.choose(takes_b, i.left, i.a_left, i.b_left, takes_b ? i.b_has_point : i.a_has_point);
        if ((left > 0 && right < 0) || (left < 0 && right > 0)) {
            const double x = std::clamp(i.left + left / (left - right) * (i.right - i.left), i.left, i.right);
            const double y = height_on({i.left, i.a_left}, {i.right, i.a_right}, x);
            selection.reach(y, y);
            selection.choose(!takes_b, x, y, y, false);
        }
        selection.reach(i.a_right, i.b_right);
    });
    selection.finish(a.back().x);
    return selection.line;
}

}  // namespace

std::optional<Point> first_turn_back(const std::vector<Point>& points) {
    for (std::size_t k = 1; k < points.size(); ++k)
        if (points[k].x < points[k - 1].x) return points[k];
    return std::nullopt;
}

HeightLine height_line(const std::vector<Point>& points, double left, double right) {
    const Point &first = points.front(), &last = points.back();
    if (last.x <= left) return {{left, last.y}, {right, last.y}};
    if (first.x >= right) return {{left, first.y}, {right, first.y}};
    HeightLine line;
    if (first.x > left) append(line, {left, first.y});
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Point& p = points[k];
        const Point& before = points[k > 0 ? k - 1 : 0];
        if (before.x < left && p.x > left) append(line, {left, height_on(before, p, left)});
        if (p.x >= left && p.x <= right) append(line, p);
        if (before.x < right && p.x > right) append(line, {right, height_on(before, p, right)});
    }
    if (last.x < right) append(line, {right, last.y});
    return line;
}

HeightLine lower_of(const HeightLine& a, const HeightLine& b) {
    return select(a, b, 1);
}

HeightLine upper_of(const HeightLine& a, const HeightLine& b) {
    return select(a, b, -1);
}

HeightLine clamped(const HeightLine& line, double low, double high) {
    const double left = line.front().x, right = line.back().x;
    return upper_of(lower_of(line, {{left, high}, {right, high}}), {{left, low}, {right, low}});
}

HeightLine moved_up(HeightLine line, double rise) {
    for (Point& p : line) p.y += rise;
    return line;
}

Rise largest_rise(const HeightLine& a, const HeightLine& b, double left, double right) {
    std::optional<Rise> largest;
    for_each_interval(a, b, [&](const Interval& i) {
        const double from = std::max(i.left, left), to = std::min(i.right, right);
        if (from > to) return;
        for (const double x : {from, to}) {
            const double height = height_on({i.left, i.a_left}, {i.right, i.a_right}, x);
            const double rise = height - height_on({i.left, i.b_left}, {i.right, i.b_right}, x);
            if (!largest || rise > largest->height) largest = {{x, height}, rise};
        }
    });
    return largest.value_or(Rise{});
}

Ring ring_between(const HeightLine& upper, const HeightLine& lower) {
    Ring ring;
    for (const Point& p : lower) append(ring, p);
    std::for_each(upper.rbegin(), upper.rend(), [&](const Point& p) { append(ring, p); });
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return twice_signed_area(ring) > 0 ? ring : Ring{};
}

}  // namespace rockslope::blockgen

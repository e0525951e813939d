#pragma once

#include <random>

#include "support/scene.hpp"

namespace rockslope::scene {

/// Random numbers that are the same with every compiler and library.
class RandomSource {
  public:
    explicit RandomSource(unsigned seed) : engine_(seed) { engine_.discard(16); }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    /// Log-uniform in [low, high).
    double magnitude(double low, double high) { return low * std::pow(high / low, uniform()); }
    /// One of 0, 1, ..., count - 1.
    unsigned index_below(unsigned count) { return static_cast<unsigned>(uniform() * count); }
    Vec2 direction() {
        const double angle = between(0, 2 * std::numbers::pi);
        return {std::cos(angle), std::sin(angle)};
    }

  private:
    double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }
    std::mt19937 engine_;
};

using Ring = std::vector<Vec2>;

/// The point x, rotated by an angle, rad, and shifted.
inline Vec2 placed(const Vec2& x, double angle, const Vec2& shift) {
    return shift + Vec2(std::cos(angle) * x.x() - std::sin(angle) * x.y(),
                        std::sin(angle) * x.x() + std::cos(angle) * x.y());
}

/// A polygon about the origin, counter-clockwise, of about the given size, m: convex, star-shaped with reflex
/// corners, angular, thin, a sliver, or with straight corners.
inline Ring random_ring(RandomSource& random, double size) {
    const double r = size / 2;
    Ring ring;
    switch (random.index_below(6)) {
        case 0:  // corners on a circle: convex
        case 1:  // or at random distances: any corner may be reflex
        {
            const unsigned count = 3 + random.index_below(6);
            const bool star = random.index_below(2) == 0;
            for (unsigned k = 0; k < count; ++k) {
                const double angle = 2 * std::numbers::pi * (k + random.between(0, .8)) / count;
                ring.push_back((star ? random.between(.4 * r, r) : r) *
                               Vec2(std::cos(angle), std::sin(angle)));
            }
            return ring;
        }
        case 2: {  // an L
            const double leg = random.between(.2, .8) * r;
            return {{-r, -r}, {r, -r}, {r, leg - r}, {leg - r, leg - r}, {leg - r, r}, {-r, r}};
        }
        case 3: {  // a plate, a hundred times as long as thick
            const double half = r / 100;
            return {{-r, -half}, {r, -half}, {r, half}, {-r, half}};
        }
        case 4: {  // a sliver of a triangle
            const double tip = random.between(-r, r);
            return {{-r, 0}, {r, 0}, {tip, r * random.magnitude(.02, .2)}};
        }
        default: {  // a rectangle with straight corners
            const double h = random.between(.2, 1) * r;
            const double x = random.between(-.9, .9) * r;
            return {{-r, -h}, {x, -h}, {r, -h}, {r, 0}, {r, h}, {-x, h}, {-r, h}, {-r, -.1 * h}};
        }
    }
}

/// A ring, rotated and shifted.
inline Ring placed(const Ring& ring, double angle, const Vec2& shift) {
    Ring result;
    for (const Vec2& v : ring) result.push_back(placed(v, angle, shift));
    return result;
}

/// A random ring about a point, turned at random. The numbers of a seed are drawn in the same order by every
/// compiler: arguments of one call are not.
inline Ring random_ring_at(RandomSource& random, double size, const Vec2& place) {
    const double angle = random.between(0, 6);
    return placed(random_ring(random, size), angle, place);
}
/// A point at a random distance in a range, m, from the origin.
inline Vec2 random_point(RandomSource& random, double least, double largest) {
    const Vec2 direction = random.direction();
    return random.between(least, largest) * direction;
}

}  // namespace rockslope::scene

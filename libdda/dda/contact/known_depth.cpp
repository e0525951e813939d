#include "dda/contact/known_depth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dda/contact/detect.hpp"

namespace dda {

namespace {

using Keyed = std::pair<int, int>;  // a key, and what is found by it

std::span<const Keyed> entries_of(const std::vector<Keyed>& sorted, int key) {
    const auto [first, last] =
        std::equal_range(sorted.begin(), sorted.end(), Keyed{key, 0},
                         [](const Keyed& a, const Keyed& b) { return a.first < b.first; });
    return {first, last};
}

/// The end of a line's edge that is nearer to its corner: the other corner of the pair.
int partner_of(const Model& model, std::span<const Vec2> vertices, const Contact& line) {
    const int end = model.topology.next[static_cast<std::size_t>(line.edge)];
    const auto from_corner = [&](int other) {
        return (vertices[static_cast<std::size_t>(other)] - vertices[static_cast<std::size_t>(line.corner)])
            .squaredNorm();
    };
    return from_corner(end) < from_corner(line.edge) ? end : line.edge;
}

/// The corners of every group, by group; a group's lines may have either of its two.
std::vector<Keyed> corners_by_group(const Model& model, std::span<const Vec2> vertices,
                                    std::span<const Contact> contacts) {
    std::vector<Keyed> corners;
    for (const Contact& contact : contacts) {
        if (contact.group < 0) continue;
        corners.emplace_back(contact.group, contact.corner);
        corners.emplace_back(contact.group, partner_of(model, vertices, contact));
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::vector<Keyed> pressed_by_corner(std::span<const Contact> contacts) {
    std::vector<Keyed> pressed;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (contacts[k].state != ContactState::open && contacts[k].gap < 0)
            pressed.emplace_back(contacts[k].corner, static_cast<int>(k));
    }
    std::sort(pressed.begin(), pressed.end());
    return pressed;
}

}  // namespace

std::vector<double> known_depths(const Model& model, std::span<const Vec2> vertices,
                                 std::span<const Contact> contacts) {
    const std::vector<Keyed> corners = corners_by_group(model, vertices, contacts);
    const std::vector<Keyed> pressed = pressed_by_corner(contacts);
    const double along_the_line = std::sqrt(1 - parallel_tolerance * parallel_tolerance);
    std::vector<double> depths(contacts.size(), 0);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Contact& line = contacts[k];
        if (line.group < 0) continue;
        for (const auto& [group, corner] : entries_of(corners, line.group)) {
            const bool same_side =
                model.topology.block_of[static_cast<std::size_t>(corner)] == line.corner_block;
            for (const auto& [of, index] : entries_of(pressed, corner)) {
                const Contact& contact = contacts[static_cast<std::size_t>(index)];
                const double facing = contact.normal.dot(line.normal) * (same_side ? 1 : -1);
                if (facing >= along_the_line) depths[k] = std::max(depths[k], -contact.gap);
            }
        }
    }
    return depths;
}

}  // namespace dda

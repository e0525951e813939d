#include "blockgen/fit/fit_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "blockgen/fit/direction_sets.hpp"
#include "blockgen/fit/resample.hpp"
#include "blockgen/fit/set_lines.hpp"
#include "blockgen/fit/trace_lengths.hpp"

namespace rockslope::blockgen {

namespace {

/// With fewer ends than this share of all, seen or cut off, joints are taken to cross the map.
constexpr double few_ends = 0.1;
/// Traces lie on lines when there are fewer lines than this share of them.
constexpr double few_lines = 0.75;

double direction_of(const MappedPiece& piece) {
    return std::atan2(piece.b.y - piece.a.y, piece.b.x - piece.a.x);
}

/// The pieces of one set, and the probability of each piece of the map to belong to it.
struct SetMembers {
    DirectionSet direction;
    std::vector<MappedPiece> pieces;
    std::vector<double> probability;  ///< of all pieces of the map

    std::size_t ends() const {
        std::size_t ends = 0;
        for (const MappedPiece& piece : pieces) ends += piece.ends;
        return ends;
    }
};

class SetFitter {
  public:
    SetFitter(const SetMembers& set, const std::vector<MappedPiece>& all, const MapWindow& window,
              std::uint64_t seed, std::string name)
        : set_(set), all_(all), window_(window), area_(window.area()), seed_(seed) {
        fitted_.name = std::move(name);
        fitted_.pieces = set.pieces.size();
        fitted_.cut = 2 * set.pieces.size() - set.ends();
    }

    FittedSet run() {
        const auto pieces = static_cast<double>(set_.pieces.size());
        if (static_cast<double>(set_.ends()) < few_ends * 2 * pieces) {
            fitted_.pattern = SetPattern::through;
            lines_ = own_lines(set_.pieces, set_.direction, window_);
        } else {
            lines_ = common_lines(set_.pieces, set_.direction, window_);
            if (static_cast<double>(lines_.lines) < few_lines * pieces)
                fitted_.pattern = SetPattern::on_lines;
        }
        fit_directions();
        if (fitted_.pattern != SetPattern::through) fit_lengths();
        fit_intensity();
        if (fitted_.pattern != SetPattern::anywhere) fit_spacing();
        return std::move(fitted_);
    }

  private:
    /// Pieces of one trace, and traces on one line, do not lie anywhere independently: they are drawn
    /// together.
    double weight_of(std::size_t piece, const std::vector<double>& weights) const {
        return weights[lines_.line_of[piece]];
    }
    std::size_t units() const { return lines_.lines; }
    std::vector<Estimate> estimated(const char* purpose, const Statistic& statistic) const {
        return resampled(units(), statistic, seed_, fitted_.name + ' ' + purpose);
    }

    /// All pieces count by their probability, so that sets which overlap keep their tails.
    void fit_directions() {
        const auto statistic = [&](const std::vector<double>& weights) {
            double sum = 0, shift = 0, square = 0;
            for (std::size_t k = 0; k < all_.size(); ++k) {
                const double w = weights[k] * set_.probability[k];
                if (w == 0) continue;
                const double d = axial_difference(direction_of(all_[k]), set_.direction.mean);
                sum += w;
                shift += w * d;
                square += w * d * d;
            }
            const double mean = shift / sum, variance = std::max(square / sum - mean * mean, 0.0);
            return std::vector<double>{set_.direction.mean + mean,
                                       std::sqrt(variance * sum / std::max(sum - 1, 1.0))};
        };
        const std::vector<Estimate> estimates =
            resampled(all_.size(), statistic, seed_, fitted_.name + " directions");
        fitted_.direction = estimates[0];
        fitted_.scatter = estimates[1];
    }

    std::vector<SeenLength> seen_lengths(const std::vector<double>& weights) const {
        std::vector<SeenLength> seen;
        for (std::size_t k = 0; k < set_.pieces.size(); ++k)
            seen.push_back({set_.pieces[k].length, set_.pieces[k].ends, weight_of(k, weights)});
        return seen;
    }

    void fit_lengths() {
        const std::vector<SeenLength> all = seen_lengths(std::vector<double>(units(), 1));
        const Distribution law = fit_length_law(all, mean_trace_length(all));
        fitted_.length_law = law.law;
        const auto statistic = [&](const std::vector<double>& weights) {
            const std::vector<SeenLength> seen = seen_lengths(weights);
            const double mean = mean_trace_length(seen);
            const bool has_sd = law.law == Law::lognormal && std::isfinite(mean);
            return std::vector<double>{mean, has_sd ? lognormal_sd(seen, mean, law.sd / law.mean) : mean};
        };
        const std::vector<Estimate> estimates = estimated("lengths", statistic);
        fitted_.length = estimates[0];
        if (law.law == Law::lognormal) fitted_.length_sd = estimates[1];
    }

    void fit_intensity() {
        const auto statistic = [&](const std::vector<double>& weights) {
            double length = 0, across = 0, ends = 0, on_lines = 0;
            for (std::size_t k = 0; k < set_.pieces.size(); ++k) {
                const MappedPiece& piece = set_.pieces[k];
                const double w = weight_of(k, weights);
                length += w * piece.length;
                across +=
                    w * piece.length * std::cos(axial_difference(direction_of(piece), set_.direction.mean));
                ends += w * piece.ends;
            }
            for (std::size_t k = 0; k < lines_.lines; ++k)
                if (fitted_.pattern == SetPattern::on_lines) on_lines += weights[k] * lines_.chord[k];
            return std::vector<double>{length / area_, ends / 2 / area_, area_ / across, length / on_lines};
        };
        const std::vector<Estimate> estimates = estimated("intensity", statistic);
        fitted_.p21 = estimates[0];
        fitted_.p20 = fitted_.pattern == SetPattern::through ? Estimate{} : estimates[1];
        fitted_.spacing = estimates[2];
        if (fitted_.pattern == SetPattern::on_lines) fitted_.persistence = estimates[3];
    }

    /// Spacings between neighbouring lines, of which each is drawn independently. The spread of a lognormal
    /// law follows from that of the logarithms.
    void fit_spacing() {
        const std::vector<double>& gaps = lines_.gaps;
        if (gaps.size() < 2) return;
        const auto statistic = [&](const std::vector<double>& weights) {
            double n = 0, sum = 0, shift = 0, square = 0;
            for (std::size_t k = 0; k < gaps.size(); ++k) {
                const double x = std::log(std::max(gaps[k], 1e-300));
                n += weights[k];
                sum += weights[k] * gaps[k];
                shift += weights[k] * x;
                square += weights[k] * x * x;
            }
            const double mean = sum / n, log_mean = shift / n;
            const double log_variance =
                std::max(square / n - log_mean * log_mean, 0.0) * n / std::max(n - 1, 1.0);
            return std::vector<double>{mean, mean * std::sqrt(std::expm1(log_variance))};
        };
        const std::vector<Estimate> estimates =
            resampled(gaps.size(), statistic, seed_, fitted_.name + " spacing");
        fitted_.spacing = estimates[0];
        fitted_.spacing_law = law_of_gaps(gaps);
        if (fitted_.spacing_law == Law::lognormal) fitted_.spacing_sd = estimates[1];
        if (fitted_.pattern == SetPattern::through) spread_length_as_spacing();
    }

    /// Joints that cross the map are as long per area as they are many across it. Their lengths differ by the
    /// shape of the map, which makes the sum of lengths vary somewhat more than their number.
    void spread_length_as_spacing() {
        double sum = 0, square = 0;
        for (const MappedPiece& piece : set_.pieces) {
            sum += piece.length;
            square += piece.length * piece.length;
        }
        const double shape = std::sqrt(static_cast<double>(set_.pieces.size()) * square) / sum;
        const Estimate& spacing = fitted_.spacing;
        Estimate& p21 = fitted_.p21;
        p21.low = p21.value * (1 - shape * (1 - spacing.value / spacing.high));
        p21.high = p21.value * (1 + shape * (spacing.value / spacing.low - 1));
    }

    const SetMembers& set_;
    const std::vector<MappedPiece>& all_;
    const MapWindow& window_;
    double area_;
    std::uint64_t seed_;
    SetLines lines_;
    FittedSet fitted_;
};

std::vector<SetMembers> members_of_sets(const std::vector<MappedPiece>& pieces, std::size_t count) {
    std::vector<double> directions;
    for (const MappedPiece& piece : pieces) directions.push_back(direction_of(piece));
    const DirectionSets divided = divide_directions(directions, count);
    std::vector<SetMembers> sets(divided.sets.size());
    for (std::size_t k = 0; k < sets.size(); ++k) {
        sets[k].direction = divided.sets[k];
        sets[k].probability = divided.probability[k];
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) sets[divided.set_of[k]].pieces.push_back(pieces[k]);
    std::erase_if(sets, [](const SetMembers& set) { return set.pieces.empty(); });
    return sets;
}

}  // namespace

MapFit fit_map(const JointMap& map, const FitOptions& options) {
    MapFit fit;
    fit.area = map.window.area();
    const double edge = options.edge > 0 ? options.edge : 5e-4 * std::sqrt(fit.area);
    const std::vector<MappedPiece> pieces = mapped_pieces(map.traces, map.window, edge);
    if (pieces.empty()) throw std::invalid_argument("no trace lies in the mapped area");
    std::size_t number = 0;
    for (const SetMembers& set : members_of_sets(pieces, options.sets)) {
        const std::string name = "set " + std::to_string(++number);
        fit.sets.push_back(SetFitter(set, pieces, map.window, options.seed, name).run());
        constexpr std::size_t few = 30;
        if (set.pieces.size() < few)
            fit.notes.push_back(name + " has only " + std::to_string(set.pieces.size()) +
                                " traces: its intervals are rough");
    }
    return fit;
}

}  // namespace rockslope::blockgen

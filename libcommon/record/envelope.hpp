#pragma once

namespace rockslope::record {

/// How the strength of shaking grows and dies away (Jennings, Housner & Tsai 1968): a parabola up to `rise`,
/// then 1 for `strong` seconds, then exp(-decay (t - rise - strong)).
struct Envelope {
    double rise = 2;     ///< s, positive
    double strong = 6;   ///< s
    double decay = 0.5;  ///< 1/s

    double at(double time) const;
};

/// The envelope of an earthquake of moment magnitude M at a distance R (km). Strong shaking lasts as long as
/// the source radiates and the path spreads it, 1 / f_0 + 0.05 R, where f_0 = 4.9e6 beta (stress drop /
/// M_0)^(1/3) is the source's corner frequency with beta = 3.5 km/s, 100 bar and M_0 = 10^(1.5 M + 16.05) dyn
/// cm (Brune 1970; Boore 2003). Rise takes a third of that, and the decay reaches 5 % in twice that.
/// @param magnitude 4 to 8.5; @param distance_km 0 to 300; otherwise std::invalid_argument.
Envelope envelope_of_earthquake(double magnitude, double distance_km);

}  // namespace rockslope::record

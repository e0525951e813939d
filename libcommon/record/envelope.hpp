#pragma once

namespace rockslope::record {

/// Envelope of the amplitude of shaking (Jennings, Housner & Tsai 1968): (t / rise)^2 up to `rise`, then 1
/// for `strong` seconds, then exp(-decay (t - rise - strong)).
struct Envelope {
    double rise = 2;     ///< s, positive
    double strong = 6;   ///< s
    double decay = 0.5;  ///< 1/s

    /// The factor at a time, s.
    double at(double time) const;
};

/// The envelope of an earthquake of moment magnitude M at a distance R (km). Strong shaking lasts 1 / f_0 +
/// 0.05 R seconds: the source duration plus the spreading along the path. f_0 = 4.9e6 beta (stress drop /
/// M_0)^(1/3) is the corner frequency of the source, with beta = 3.5 km/s, a stress drop of 100 bar and M_0
/// = 10^(1.5 M + 16.05) dyn cm (Brune 1970; Boore 2003). The rise takes a third of that time, and the decay
/// reaches 5 % in twice that time.
/// @param magnitude 4 to 8.5; @param distance_km 0 to 300; otherwise std::invalid_argument.
Envelope envelope_of_earthquake(double magnitude, double distance_km);

}  // namespace rockslope::record

#pragma once

namespace rockslope::record {

/// The shape of the power spectral density of strong ground acceleration: white rock motion filtered by the
/// ground (Kanai 1957, Tajimi 1960), cleaned of its low frequencies (Clough & Penzien 1993), with its high
/// frequencies attenuated near the surface (Anderson & Hough 1984).
struct PowerSpectrum {
    double ground_frequency = 5.0;   ///< Hz, of the ground filter; 2.5 is firm soil, 4 to 8 rock
    double ground_damping = 0.6;     ///< of critical
    double low_cut_frequency = 0.3;  ///< Hz, of the second filter; below it the displacement does not grow
    double low_cut_damping = 0.6;    ///< of critical
    double kappa = 0.035;            ///< s, amplitude decays as exp(-pi kappa f); 0.02 to 0.05 on rock
};

/// The ground's part for a white input of density 1, dimensionless, f >= 0 in Hz, r = f / f_g:
///   S_g = (1 + 4 z_g^2 r^2) / ((1 - r^2)^2 + 4 z_g^2 r^2) * exp(-2 pi kappa f)
double ground_density(const PowerSpectrum& spectrum, double frequency);

/// The low cut's part, s = f / f_c: the squared gain of an oscillator from ground to relative acceleration,
///   s^4 / ((1 - s^2)^2 + 4 z_c^2 s^2)
double low_cut_gain(const PowerSpectrum& spectrum, double frequency);

/// Their product: the density of the motion.
double density(const PowerSpectrum& spectrum, double frequency);

}  // namespace rockslope::record

#pragma once

namespace rockslope::record {

/// Shape of the power spectral density of strong ground acceleration: white noise in the rock, filtered by
/// the ground (Kanai 1957, Tajimi 1960), with a low-cut filter (Clough & Penzien 1993) and attenuation of
/// high frequencies near the surface (Anderson & Hough 1984).
struct PowerSpectrum {
    double ground_frequency = 5.0;   ///< f_g, Hz, of the ground filter; 2.5 is firm soil, 4 to 8 rock
    double ground_damping = 0.6;     ///< z_g, damping ratio of the ground filter
    double low_cut_frequency = 0.3;  ///< f_c, Hz, of the low-cut filter, which limits the displacement
    double low_cut_damping = 0.6;    ///< z_c, damping ratio of the low-cut filter
    double kappa = 0.035;            ///< s, amplitude decays as exp(-pi kappa f); 0.02 to 0.05 on rock
};

/// Density after the ground filter for a white input of density 1, dimensionless, f >= 0 in Hz, r = f / f_g:
///   S_g = (1 + 4 z_g^2 r^2) / ((1 - r^2)^2 + 4 z_g^2 r^2) * exp(-2 pi kappa f)
double ground_density(const PowerSpectrum& spectrum, double frequency);

/// Gain of the low-cut filter, s = f / f_c: the squared gain of an oscillator from ground to relative
/// acceleration,
///   s^4 / ((1 - s^2)^2 + 4 z_c^2 s^2)
double low_cut_gain(const PowerSpectrum& spectrum, double frequency);

/// Density of the motion: ground_density times low_cut_gain.
double density(const PowerSpectrum& spectrum, double frequency);

}  // namespace rockslope::record

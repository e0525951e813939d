#pragma once

#include <vector>

#include "blockgen/input/distribution.hpp"

namespace rockslope::blockgen {

/// A length of a trace as far as the window shows it, m.
struct SeenLength {
    double length = 0;
    int ends = 0;  ///< ends that are seen: 2 of a whole trace, 1 or 0 of one cut at the window's edge
    double weight = 1;
};

/// The mean length of traces, m: their total length in the window over half the number of their ends there
/// (Mauldon 1998). It supposes no distribution, and traces cut at the edge do not bias it. Infinite without
/// an end.
double mean_trace_length(const std::vector<SeenLength>& seen);

/// Log-likelihood of the shape of a length distribution of a given mean, by which a whole trace has its
/// density, one of which one end is seen its survival function, and one of which none is seen the integral of
/// that (Laslett 1982). The law is exponential or lognormal.
double log_likelihood(const std::vector<SeenLength>& seen, const Distribution& law);

/// The law of trace lengths with a given mean: exponential, or lognormal with the most likely standard
/// deviation where Akaike's criterion prefers it.
Distribution fit_length_law(const std::vector<SeenLength>& seen, double mean);

/// The most likely standard deviation of a lognormal law of a given mean, m. @param near a value of sd /
/// mean, of which it lies within a factor of three, where one is known; 0: none.
double lognormal_sd(const std::vector<SeenLength>& seen, double mean, double near = 0);

}  // namespace rockslope::blockgen

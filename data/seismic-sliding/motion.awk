# The second derivative of u = amplitude E(t) sin(2 pi f t) with the envelope E = (t/9)^4 exp(4 (1 - t/9)), for 25 s.
#   awk -v amplitude=0.0187 -v frequency=2 -f motion.awk
BEGIN {
    w = 2 * 3.14159265358979 * frequency
    print "time (s),acceleration (m/s2)"
    for (k = 0; k <= 5000; ++k) {
        t = k * 0.005
        a = 0
        if (k > 0) {
            envelope = (t / 9) ^ 4 * exp(4 * (1 - t / 9))
            growth = 4 / t - 4 / 9
            a = amplitude * envelope * ((growth ^ 2 - 4 / t ^ 2 - w ^ 2) * sin(w * t) + 2 * growth * w * cos(w * t))
        }
        printf "%.3f,%.9g\n", t, a
    }
}

# Reads a joints.csv. Prints the backward slip near 10 s of shaking, the shear stress of the joint then, the number of
# changes of direction, and the slip at the end.
$2 == "shake" {
    if (start == "") start = $1
    t = $1 - start
    if (t > 9.9 && t < 10.25) {
        if (highest == "" || $8 > highest) highest = $8
        if (lowest == "" || $8 < lowest) lowest = $8
        if (-$5 > most) most = -$5
    }
}
END {
    printf "%-18s slips back by %.3f mm, bears %.1f kPa; %d changes of direction, %.2f m after 25 s\n",
        run, (highest - lowest) * 1000, most / 1000, $12, $3
}

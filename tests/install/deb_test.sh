#!/bin/sh
# Makes the Debian package, unpacks it and runs an example with its programs.
#   deb_test.sh BUILD
set -eu
build=$1
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/../cli/common.sh"

cpack --config "$build/CPackConfig.cmake" -G DEB -B "$folder" >cpack.log 2>&1 || fail "cpack: $(tail -n 5 cpack.log)"
deb=$(echo rockslope_*.deb)
[ -f "$deb" ] || fail "no package: $(ls)"
dpkg-deb -f "$deb" Depends >depends.txt
for library in libc6 libcairo2 libhdf5-103-1 libmetis5 fonts-dejavu-core; do
    grep -q "$library" depends.txt || fail "the package does not depend on $library: $(cat depends.txt)"
done
dpkg-deb -x "$deb" root
for file in bin/dda-run lib/cmake/rockslope/rockslope-config.cmake share/doc/rockslope/CITATION.cff share/doc/rockslope/copyright \
    share/man/man1/dda-run.1 share/bash-completion/completions/dda-run include/rockslope/dda/analysis/run.hpp; do
    found=$(find root/usr -path "*${file#lib/}" | head -n 1)
    [ -n "$found" ] || fail "the package has no $file"
done

# An example, copied from the package, with its programs on the path and no build tree.
cp -r root/usr/share/rockslope/examples examples
PATH="$folder/root/usr/bin:$PATH" make -C examples/incline >make.log 2>&1 || fail "make: $(tail -n 5 make.log)"
grep -q "^$folder/root/usr/bin/dda-run run.toml" make.log || fail "make used other programs: $(cat make.log)"
[ -s examples/incline/pictures/incline.history.png ] || fail "the example drew nothing: $(ls examples/incline/pictures)"

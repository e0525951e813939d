#!/bin/sh
# Fields, looks and films of dda-plot, for a block that slides on an incline.
#   dda_plot_test.sh BIN DATA
set -eu
bin=$1
data=$2
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
cp "$data"/incline/*.toml "$data"/incline/*.csv .
"$bin/blockgen" slope.toml >cut.txt
"$bin/dda-run" run.toml --set 'stage[1].duration=0.4' --set 'stage[1].step=0.002' --set output.frames=4 >run.txt 2>&1 ||
    fail "dda-run: $(tail -n 2 run.txt)"

# Each field that --help names is drawn, under its own name.
"$bin/dda-plot" --help | tr -d '\n' | sed 's/.*what the colours show: *//; s/(default.*//; s/  */ /g; s/, /\n/g' >fields.txt
[ "$(wc -l <fields.txt)" -ge 14 ] || fail "too few fields: $(cat fields.txt)"
while read -r field; do
    "$bin/dda-plot" out --frames last --field "$field" --format svg -o fields || fail "--field $field is not drawn"
done <fields.txt
for field in sigma_xx principal_stresses slip normal_stress material; do
    [ -s fields/incline."$field"-0005.svg ] || fail "no picture of $field: $(ls fields)"
done
grep -q '>shake, 0.400 s</text>' fields/incline.sigma_xx-0005.svg || fail "no stage and time in the title"
grep -q 'tension positive (kPa)</text>' fields/incline.sigma_xx-0005.svg || fail "no unit at the colour bar"
grep -q '>rock</text>' fields/incline.material-0005.svg || fail "no name of the material"

# A picture for a column of a paper: its width, letters, labels, exaggerated displacements.
"$bin/dda-plot" out --frames last --format svg -o paper --width 85mm --font 'DejaVu Serif' --font-size 8 --labels joints \
    --labels blocks
picture=paper/incline.frame-0005.svg
for_a_column "$picture"
grep -q 'font-size="8.00".*DejaVu Serif.*>x (m)</text>' "$picture" || fail "another font: $(grep '(m)<' "$picture")"
"$bin/dda-plot" out --history --format svg -o paper --width 85mm --font-size 8
for_a_column paper/incline.history.svg
grep -q '>plane</text>' "$picture" || fail "the joint has no label"
grep -q '>1</text>' "$picture" || fail "the block has no label"
"$bin/dda-plot" out --frames last --format svg -o large --scale 100
grep -q 'displacements × 100</text>' large/incline.frame-0005.svg || fail "the factor is not told"

# A run without a file of contacts is drawn without them, and has a report.
mkdir blocks-only && cp out/*.csv out/incline.vtkhdf out/summary.json out/run.toml blocks-only
"$bin/dda-plot" blocks-only --frames last --format svg -o blocks-only || fail "a run without contacts is not drawn"
"$bin/dda-plot" blocks-only --report blocks-only/report.html || fail "a run without contacts has no report"

# The last frame of a strength reduction is the mechanism, with its factor: tan 25 / tan 16.26 = 1.599.
sed '/^\[\[stage\]\]/,$d' run.toml >reduction.toml
printf '[[stage]]\nname = "strength"\nkind = "strength-reduction"\n' >>reduction.toml
"$bin/dda-run" reduction.toml -o reduced >/dev/null 2>&1 || fail "the strength reduction fails"
"$bin/dda-plot" reduced --frames last --format svg -o reduced
grep -q '>strength: mechanism, factor of safety 1\.59[0-9]</text>' reduced/*.svg || fail "no factor of safety: $(grep 'bold' reduced/*.svg)"

refused() {
    expected=$1
    shift
    run_refused "$expected" "$bin/dda-plot" out -o refused "$@"
    [ ! -e refused ] || fail "left behind by: $*"
}
refused "did you mean 'sigma_xx'?" --field sigma_xz
refused 'one of displacement, velocity' --field '?'
refused 'unit: mm, cm, in or pt' --width 85
refused "'Font of Nowhere', which is not installed" --font 'Font of Nowhere' --history
refused 'blocks or joints' --labels faces
refused 'a positive factor' --scale 0
refused 'moves blocks, not joints' --scale 2 --field slip
refused '.mp4, .webm or .gif' --movie film.avi
refused 'without --movie' --speed 2

# A film, where ffmpeg is; without it one line says so.
run_refused 'ffmpeg, which makes films, is not installed' env PATH=/nowhere "$bin/dda-plot" out --movie film.mp4
[ ! -e film.mp4 ] || fail "a film without ffmpeg"
if command -v ffmpeg >/dev/null; then
    # The name that a part of a film once had is a user's.
    echo precious >victim
    ln -s victim film.mp4.part
    for film in film.mp4 film.webm film.gif; do
        "$bin/dda-plot" out --movie "$film" --speed 0.4 --fps 12 --frames first,middle,last || fail "no $film"
        # From the first frame to the last, and a second of the run's end.
        ffprobe -v error -count_frames -show_entries stream=width,nb_read_frames -of csv=p=0 "$film" >shown.txt
        case $film in *.gif) width=720 ;; *) width=1280 ;; esac
        awk -F, -v width=$width '{ exit !($1 == width && $2 > 20 && $2 < 40) }' shown.txt || fail "$film has $(cat shown.txt)"
    done
    [ "$(cat victim)" = precious ] || fail "a link is followed"
    [ -L film.mp4.part ] || fail "a link is gone"
    mkdir broken
    cat >broken/ffmpeg <<'FFMPEG'
#!/bin/sh
for part; do :; done
echo half >"${part#file:}"
exit 3
FFMPEG
    chmod +x broken/ffmpeg
    cp film.mp4 before.mp4
    code=0
    PATH=$PWD/broken:$PATH "$bin/dda-plot" out --movie film.mp4 --frames first 2>err.txt || code=$?
    [ "$code" -eq 2 ] || fail "exit code $code of a broken ffmpeg"
    grep -q 'film.mp4: is not made: ffmpeg failed with exit code 3' err.txt || fail "a broken ffmpeg: $(cat err.txt)"
    cmp film.mp4 before.mp4 || fail "a broken ffmpeg spoils the film"
    ls film.*tmp* 2>/dev/null && fail "a part of a film is left"
else
    echo "ffmpeg is not here: no film is made"
fi
exit 0

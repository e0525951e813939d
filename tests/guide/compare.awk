# Compares the output that a page shows with that of the program.
#   awk -v name=PAGE -v renewed=FILE -f compare.awk SHOWN PRINTED
# SHOWN has lines "line<TAB>text". A line "..." stands for any number of lines, a word "..." for one word. All else must be the
# same, but for the number of blanks. Prints the differences, and writes the lines as they should be into FILE.
function normal(text) {
    gsub(/[ \t]+/, " ", text)
    sub(/ $/, "", text)
    return text
}

# The words of a line with '#' for the digits of its numbers: what lines of a different run have in common.
function form(text) {
    text = normal(text)
    gsub(/-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/, "#", text)
    return text
}

# Whether two texts have the same words, where '...' of the first is any word.
function same(pattern, text,    p, t, n, i) {
    n = split(normal(pattern), p, " ")
    if (n != split(normal(text), t, " ")) return 0
    for (i = 1; i <= n; ++i)
        if (p[i] != "..." && p[i] != t[i]) return 0
    return 1
}

# The printed line with the '...' of the page's line.
function with_gaps(pattern, text,    p, t, n, i) {
    if (pattern !~ /(^| )\.\.\.( |$)/) return text
    n = split(normal(pattern), p, " ")
    split(normal(text), t, " ")
    text = ""
    for (i = 1; i <= n; ++i) text = text (i > 1 ? " " : "") (p[i] == "..." ? "..." : t[i])
    return text
}

FNR == NR {
    tab = index($0, "\t")
    at[++shown] = substr($0, 1, tab - 1)
    page[shown] = substr($0, tab + 1)
    next
}
{ printed[++count] = $0 }
END {
    position = 1
    for (i = 1; i <= shown; ++i) {
        if (page[i] == "...") {
            gap = 1
            continue
        }
        found = position
        if (gap)
            while (found <= count && !same(form(page[i]), form(printed[found]))) ++found
        if (found > count) {
            print name ":" at[i] ": the page has '" page[i] "', the program prints no such line"
            continue
        }
        position = found + 1
        gap = 0
        if (same(page[i], printed[found])) continue
        print name ":" at[i] ": the page has '" page[i] "', the program prints '" printed[found] "'"
        print at[i] "\t" with_gaps(page[i], printed[found]) >> renewed
    }
    if (gap || position > count) exit
    print name ":" at[shown] ": the program prints one line more: '" printed[position] "'"
    for (i = position; i <= count; ++i) print at[shown] "+\t" printed[i] >> renewed
}

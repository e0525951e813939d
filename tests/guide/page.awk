# Splits a page into steps for run_page.sh, which explains the marks.
#   awk -v steps=FOLDER -v name=PAGE -v long=0|1 -f page.awk PAGE
# Writes FOLDER/list with a line "number kind line exit-code argument" for each step, its text as FOLDER/number, the output that
# the page shows as FOLDER/number.shown ("line<TAB>text"), and the page's prose as FOLDER/prose. Prints what is neither run
# nor marked.
function complain(line, message) {
    print name ":" line ": " message
}

function add_step(kind, line, text, argument) {
    commands = commands "\n" text
    if (skipped) return
    number = sprintf("%03d", ++count)
    printf "%s", text > (steps "/" number)
    close(steps "/" number)
    print number, kind, line, exit_code, argument > (steps "/list")
    printf "" > (steps "/" number ".shown")
}

function add_shown(line, text) {
    if (!skipped) print line "\t" text >> (steps "/" number ".shown")
}

# A session: commands behind "$ ", continued while lines end with a backslash, and what they print.
function add_session(    i, command, line) {
    for (i = 1; i <= size; ++i) {
        if (body[i] !~ /^\$ /) {
            if (i == 1) complain(start + i, "a session begins with a command behind '$ '")
            add_shown(start + i, body[i])
            continue
        }
        line = start + i
        command = substr(body[i], 3)
        while (command ~ /\\$/ && i < size) command = command "\n" body[++i]
        add_step("session", line, command "\n", "-")
        close(steps "/" number ".shown")
    }
}

function whole_body(    i, text) {
    text = ""
    for (i = 1; i <= size; ++i) text = text body[i] "\n"
    return text
}

function end_block(    parts) {
    if (unrun) commands = commands "\n" whole_body()
    else if (info == "console") add_session()
    else if (info == "sh") add_step("commands", start, whole_body(), "-")
    else if (split(info, parts, " ") == 4 && parts[2] " " parts[3] == "part of") add_step("part", start, whole_body(), parts[4])
    else if (split(info, parts, " ") == 2) add_step("file", start, whole_body(), parts[2])
    else if (info != "text") complain(start, "a block of kind '" info "' is neither run nor marked 'not run'")
    unrun = 0
    exit_code = 0
    in_block = size = 0
}

# The text of a comment behind "name:", without blanks at its ends.
function argument_of(text) {
    sub(/^[^:]*:[ \n]*/, "", text)
    sub(/[ \n]*$/, "", text)
    return text
}

function end_comment(line, text) {
    if (text ~ /^not run:/) {
        unrun = 1
        if (argument_of(text) == "") complain(line, "'not run' without a reason")
    } else if (text ~ /^long:/) {
        if (argument_of(text) == "") complain(line, "'long' without a reason")
        skipped = !long
    } else if (text ~ /^exit [0-9]+:/) {
        exit_code = text
        sub(/^exit /, "", exit_code)
        sub(/:.*/, "", exit_code)
    } else if (text ~ /^says:/) add_step("says", line, argument_of(text) "\n", "-")
    else if (text ~ /^run:/) add_step("commands", line, argument_of(text) "\n", "-")
    else complain(line, "an unknown mark: " text)
}

# Commands within a sentence must be run by a block or a mark, too.
function check_inline(    text, span, wanted, have) {
    have = commands
    gsub(/[ \\\n]+/, " ", have)
    text = prose
    while (match(text, /`[^`]+`/)) {
        span = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        if (span ~ /^(blockgen|dda-run|dda-plot|joint-shear|make|ground-motion [a-z]+|\.?\/?tools\/[a-z-]+) +[^ ]/ && !index(have, span))
            complain(1, "the command `" span "` is not run")
    }
}

BEGIN { exit_code = 0 }
in_block && /^```$/ { end_block(); next }
in_block { body[++size] = $0; next }
/^```/ {
    in_block = 1
    start = NR
    info = substr($0, 4)
    next
}
!in_comment && /^<!-- / {
    in_comment = NR
    comment = ""
    sub(/^<!-- /, "")
}
in_comment {
    if (/-->$/) {
        sub(/ *-->$/, "")
        end_comment(in_comment, comment $0)
        in_comment = 0
    } else comment = comment $0 "\n"
    next
}
/^    / && blank { complain(NR, "an indented block; the test runs fenced ones only") }
{
    blank = /^ *$/
    prose = prose " " $0
}
END {
    if (in_block) complain(start, "a block without an end")
    gsub(/ +/, " ", prose)
    print prose > (steps "/prose")
    check_inline()
    if (commands == "") complain(1, "the page has no command")
}

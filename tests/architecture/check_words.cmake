# Checks that names which were private coinages do not come back, and that no comment opens as a riddle.
#   cmake -D ROOT=<source tree> -P check_words.cmake
# docs/glossary.md defines the words of ours that are left.
cmake_minimum_required(VERSION 3.25)

# "coinage>the field's word"
set(retired
    "Crew>ThreadPool" "taken_together>parallel_reduce" "for_ranges>parallel_for" "Look>Prediction"
    "look_again>retry" "turned_unexpectedly>rotation_prediction_failed" "HeldFriction>FrictionCoupling"
    "JudgedContact>EvaluatedContact" "choose_springs>update_active_set" "choose_lines>EntranceLines::select_first"
    "belongs_to_faces>history scope" "KnownDepth>inherited penetration" "stood_for>inherited penetration"
    "held_back>inhibited" "faces_outwards>entrance-angle test" "Intrusion>UndetectedPenetration" "Estate>predecessors"
    "heirs>successors" "Kin>match level" "rest_gap>stress_free_gap" "go_as_told>prescribed slip"
    "outrun>spring overtaken" "way_left>remaining displacement" "tear>break_bonds")
set(openings "///?<? ?Of (the|a|all|its|every|each|them)[ ,]")

set(violations "")
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/libcommon/*.[ch]pp ${ROOT}/libblockgen/*.[ch]pp ${ROOT}/libdda/*.[ch]pp
     ${ROOT}/tools/*.[ch]pp ${ROOT}/tests/*.[ch]pp ${ROOT}/bench/*.[ch]pp)
list(FILTER files EXCLUDE REGEX "/planted")
list(LENGTH files file_count)
if(file_count EQUAL 0)
    message(FATAL_ERROR "no sources under ${ROOT}")
endif()
foreach(file IN LISTS files)
    file(READ ${ROOT}/${file} text)
    foreach(pair IN LISTS retired)
        string(REGEX REPLACE ">.*" "" word "${pair}")
        string(REGEX REPLACE ".*>" "" instead "${pair}")
        string(FIND "${text}" "${word}" at)
        if(NOT at EQUAL -1 AND text MATCHES "(^|[^A-Za-z0-9_])${word}([^A-Za-z0-9_]|$)")
            list(APPEND violations "${file}: '${word}' is retired, use '${instead}'")
        endif()
    endforeach()
    if(text MATCHES "${openings}")
        list(APPEND violations "${file}: a comment opens with '${CMAKE_MATCH_0}', name its subject first")
    endif()
endforeach()

if(violations)
    list(JOIN violations "\n  " text)
    message(FATAL_ERROR "words:\n  ${text}")
endif()
message(STATUS "${file_count} files use no retired word")

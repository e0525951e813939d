# Bundles the program of the report page, web/report, into the file that dda-plot is built with, or checks that file.
#   cmake -D MODE=write|check [-D ESBUILD=<program>] -P web/bundle.cmake
# The first line of the bundle is a digest of its sources, which is checked everywhere; where esbuild is, of Debian's package,
# the check bundles again and compares every byte.
cmake_minimum_required(VERSION 3.25)
set(web ${CMAKE_CURRENT_LIST_DIR})
set(bundle ${web}/report.bundle.js)
if(NOT ESBUILD)
    find_program(ESBUILD esbuild)
endif()

file(GLOB sources RELATIVE ${web} ${web}/report/*.ts ${web}/vendor/*/*.js ${web}/bundle.cmake)
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
    file(SHA256 ${web}/${source} digest)
    string(APPEND digests "${source} ${digest}\n")
endforeach()
string(SHA256 digest "${digests}")
set(notice "// Contains uPlot 1.6.32, Copyright (c) 2022 Leon Sorokin, MIT licence, and earcut 3.2.4, Copyright (c) 2026 Mapbox, ISC licence.")
set(first_line "// Bundled from web/report and web/vendor by web/bundle.cmake; sources ${digest}\n${notice}\n")

# The bundle that the sources give.
function(make_bundle variable)
    execute_process(COMMAND ${ESBUILD} report/main.ts --bundle --minify --format=iife --target=es2022 --charset=utf8
                            --legal-comments=inline --log-level=warning
                    WORKING_DIRECTORY ${web} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    set(${variable} "${first_line}${text}" PARENT_SCOPE)
endfunction()

if(MODE STREQUAL write)
    if(NOT ESBUILD)
        message(FATAL_ERROR "esbuild is not here; expected Debian's package esbuild")
    endif()
    make_bundle(text)
    file(WRITE ${bundle} "${text}")
elseif(MODE STREQUAL check)
    file(READ ${bundle} text)
    string(FIND "${text}" "${first_line}" at)
    if(NOT at EQUAL 0)
        message(FATAL_ERROR "web/report.bundle.js is not made from the sources as they are; "
                            "run: cmake -D MODE=write -P web/bundle.cmake")
    endif()
    if(NOT ESBUILD)
        message(STATUS "esbuild is not here: the bundle is held to its sources by their digest alone")
        return()
    endif()
    make_bundle(expected)
    if(NOT text STREQUAL expected)
        message(FATAL_ERROR "web/report.bundle.js is not what esbuild makes of its sources")
    endif()
else()
    message(FATAL_ERROR "MODE is '${MODE}'; expected write or check")
endif()

# Writes the source of report_assets.hpp: the page, the style and the program of a report as string literals.
#   cmake -D OUT=<file.cpp> -P web/embed.cmake
cmake_minimum_required(VERSION 3.25)
set(web ${CMAKE_CURRENT_LIST_DIR})
set(text "// Written by CMake from the files of web.\n#include \"report_assets.hpp\"\n\nnamespace rockslope {\n")

function(embed name file)
    file(READ ${web}/${file} content)
    if(content MATCHES "\\)rockslope\"")
        message(FATAL_ERROR "${file} contains the end of a string literal")
    endif()
    # Compilers limit the length of one literal.
    set(pieces "")
    string(LENGTH "${content}" length)
    set(at 0)
    while(at LESS length)
        string(SUBSTRING "${content}" ${at} 12000 piece)
        string(APPEND pieces "\nR\"rockslope(${piece})rockslope\"")
        math(EXPR at "${at} + 12000")
    endwhile()
    set(text "${text}const std::string_view ${name} =${pieces};\n" PARENT_SCOPE)
endfunction()

embed(report_page report/page.html)
embed(report_style report/style.css)
embed(report_script report.bundle.js)
file(WRITE ${OUT} "${text}}  // namespace rockslope\n")

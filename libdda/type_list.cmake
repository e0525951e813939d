# Writes a header with the types of a list: includes the header of each and declares them as one std::variant. A type's header
# has its name in lower case with underscores: MohrCoulomb is in mohr_coulomb.hpp.
#   list     text file: one type a line; lines that begin with '#' are comments
#   alias    name of the variant
#   folder   where the types' headers are, as the includes name it
#   header   file to write
function(write_type_list list alias folder header)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
    file(STRINGS ${list} types REGEX "^[^#]")
    set(includes "")
    foreach(type IN LISTS types)
        if(NOT type MATCHES "^[A-Z][A-Za-z0-9]*$")
            message(FATAL_ERROR "${list}: '${type}' is not the name of a type; expected one name a line, e.g. MohrCoulomb")
        endif()
        string(REGEX REPLACE "([a-z0-9])([A-Z])" "\\1_\\2" file ${type})
        string(TOLOWER ${file} file)
        list(APPEND includes "#include \"${folder}/${file}.hpp\"")
    endforeach()
    list(JOIN includes "\n" includes)
    list(JOIN types ", " types)
    cmake_path(GET list FILENAME name)
    file(CONFIGURE OUTPUT ${header} @ONLY CONTENT
"// Written by CMake from ${name}.
#pragma once

#include <variant>

@includes@

namespace rockslope::dda {
using @alias@ = std::variant<@types@>;
}
")
endfunction()

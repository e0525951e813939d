# Checks that dependencies point down only and that each package stays private to its folder.
#   cmake -D ROOT=<source tree> -P check_includes.cmake
# Reads the #include lines of libblockgen, libdda and tools; names every one that breaks a rule, and fails if any does.
cmake_minimum_required(VERSION 3.25)

# The floors of libdda from the ground up; floors of one line do not see each other.
set(storeys "base" "geometry linear joint record" "model" "block" "contact" "terms" "analysis" "io")
set(rank 0)
foreach(storey IN LISTS storeys)
    string(REPLACE " " ";" floors "${storey}")
    foreach(floor IN LISTS floors)
        set(rank_of_${floor} ${rank})
    endforeach()
    math(EXPR rank "${rank} + 1")
endforeach()

# Which folders of blockgen a folder may see: "folder of the including file|what it may include".
set(blockgen_views
    "libblockgen/blockgen/base|base"
    "libblockgen/blockgen/config|base config"
    "libblockgen/blockgen/mesh|base mesh"
    "libblockgen/blockgen/picture|base mesh picture"
    "libdda/dda/io|base config mesh picture"
    "libdda/dda|base")

# "package's headers|folders that may include them".
set(private_packages
    "CGAL/|libblockgen/blockgen/detail"
    "toml(\\+\\+|plusplus)|libblockgen/blockgen/config"
    "cairo|libblockgen/blockgen/picture"
    "(hdf5|H5[A-Za-z]*)\\.h|libdda/dda/io"
    "(gdal|cpl_[a-z]*|ogr_[a-z_]*)\\.h|libblockgen/blockgen/input"
    "nlohmann/|libdda/dda/io libblockgen/blockgen/input libblockgen/blockgen"
    "(suitesparse/)?(cholmod|SuiteSparse_config|amd|camd|ccolamd|metis)\\.h|libdda/dda/linear")

set(violations "")
macro(violation text)
    list(APPEND violations "${file} includes ${header}: ${text}")
endmacro()

function(check_floors)
    if(NOT folder MATCHES "^libdda/dda/([^/]+)" OR NOT header MATCHES "^dda/([^/]+)/")
        return()
    endif()
    string(REGEX REPLACE "^libdda/dda/([^/]+).*" "\\1" own "${folder}")
    string(REGEX REPLACE "^dda/([^/]+)/.*" "\\1" other "${header}")
    foreach(floor IN ITEMS ${own} ${other})
        if(NOT DEFINED rank_of_${floor})
            violation("'${floor}' is not a floor")
            set(violations "${violations}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
    if(NOT own STREQUAL other AND NOT rank_of_${other} LESS rank_of_${own})
        violation("${other} is not below ${own}")
    endif()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

function(check_blockgen_views)
    if(NOT header MATCHES "^blockgen/")
        return()
    endif()
    foreach(view IN LISTS blockgen_views)
        string(REGEX MATCH "^[^|]*" place "${view}")
        string(REGEX REPLACE "^[^|]*\\|" "" seen "${view}")
        if("${folder}/" MATCHES "^${place}/")
            string(REGEX REPLACE "^blockgen/" "" part "${header}")
            get_filename_component(part "${part}" DIRECTORY)
            string(REPLACE " " ";" parts "${seen}")
            if(NOT part IN_LIST parts)
                violation("${place} sees only ${seen} of blockgen")
            endif()
            break()
        endif()
    endforeach()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

function(check_private_packages)
    foreach(rule IN LISTS private_packages)
        string(REGEX REPLACE "\\|[^|]*$" "" pattern "${rule}")
        string(REGEX REPLACE ".*\\|" "" places "${rule}")
        if(header MATCHES "^${pattern}")
            string(REPLACE " " ";" places "${places}")
            if(NOT folder IN_LIST places)
                violation("only ${places} may")
            endif()
        endif()
    endforeach()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/libblockgen/*.[ch]pp ${ROOT}/libdda/*.[ch]pp ${ROOT}/tools/*.[ch]pp)
list(LENGTH files file_count)
if(file_count EQUAL 0)
    message(FATAL_ERROR "no sources under ${ROOT}")
endif()
foreach(file IN LISTS files)
    get_filename_component(folder ${file} DIRECTORY)
    file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*).*" "\\1" header "${line}")
        check_floors()
        check_blockgen_views()
        check_private_packages()
    endforeach()
endforeach()

if(violations)
    list(JOIN violations "\n  " text)
    message(FATAL_ERROR "includes that break the floors:\n  ${text}")
endif()
message(STATUS "${file_count} files keep the floors")

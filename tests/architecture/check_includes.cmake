# Checks that dependencies point down only and that each package stays private to its folder.
#   cmake -D ROOT=<source tree> -P check_includes.cmake
# Reads the #include lines of libcommon, libblockgen, libdda, libstudy and tools, reports each that violates a rule, and fails if any
# does.
cmake_minimum_required(VERSION 3.25)

include(${CMAKE_CURRENT_LIST_DIR}/floors.cmake)

# The folders of another library that a folder may include: "folder of the including file|library|folders". The first
# matching row applies; "." allows the whole library.
set(views
    "libcommon/common|blockgen|" "libcommon/common|dda|" "libcommon/common|record|"
    "libcommon/record|common|base" "libcommon/record|blockgen|" "libcommon/record|dda|"
    "libblockgen/blockgen/mesh|common|base geometry"
    "libblockgen/blockgen/input|common|base config geometry"
    "libblockgen/blockgen/picture|common|base drawing geometry"
    "libblockgen/blockgen|common|base geometry"
    "libblockgen/blockgen|dda|" "libblockgen/blockgen|record|"
    "libdda/dda/input|common|base config geometry" "libdda/dda/input|blockgen|mesh" "libdda/dda/input|record|."
    "libdda/dda/laboratory|common|base config"
    "libdda/dda/monitor|record|."
    "libdda/dda|common|base" "libdda/dda|blockgen|" "libdda/dda|record|"
    "libcommon/common|study|" "libcommon/record|study|" "libblockgen/blockgen|study|" "libdda/dda|study|"
    "libstudy/study/statistics|common|" "libstudy/study/statistics|blockgen|" "libstudy/study/statistics|dda|"
    "libstudy/study/statistics|record|"
    "libstudy/study/design|common|" "libstudy/study/design|blockgen|" "libstudy/study/design|dda|"
    "libstudy/study/design|record|"
    "libstudy/study/plan|common|base config" "libstudy/study/plan|blockgen|input" "libstudy/study/plan|dda|"
    "libstudy/study/plan|record|"
    "libstudy/study/folder|common|base config" "libstudy/study/folder|dda|input checkpoint"
    "libstudy/study/folder|blockgen|." "libstudy/study/folder|record|."
    "libstudy/study/table|common|base geometry" "libstudy/study/table|dda|hdf"
    "libstudy/study/picture|common|base drawing geometry" "libstudy/study/picture|blockgen|"
    "libstudy/study/picture|dda|" "libstudy/study/picture|record|"
    "libstudy/study|common|base" "libstudy/study|blockgen|" "libstudy/study|dda|" "libstudy/study|record|")

# "package's headers|folders that may include them".
set(private_packages
    "CGAL/|libblockgen/blockgen/arrangement"
    "toml(\\+\\+|plusplus)|libcommon/common/config"
    "(cairo|fontconfig)|libcommon/common/drawing"
    "(hdf5|H5[A-Za-z]*)\\.h|libdda/dda/hdf"
    "(gdal|cpl_[a-z]*|ogr_[a-z_]*)\\.h|libblockgen/blockgen/input"
    "nlohmann/|libdda/dda/results libblockgen/blockgen/input libblockgen/blockgen/report libblockgen/blockgen/fit tools/blockgen libstudy/study/folder libstudy/study/table tools/dda-study tools/dda-plot"
    "simdjson|libblockgen/blockgen/input"
    "openssl/|libcommon/common/base"
    "sqlite3|libstudy/study/table"
    "(suitesparse/)?(cholmod|SuiteSparse_config|amd|camd|ccolamd)\\.h|bench"
    "metis\\.h|libdda/dda/linear")

set(violations "")
macro(violation text)
    list(APPEND violations "${file} includes ${header}: ${text}")
endmacro()

function(check_floors)
    foreach(end IN ITEMS own other)
        if(NOT DEFINED rank_of_${${end}_library}_${${end}_floor})
            violation("'${${end}_floor}' is not a floor of ${${end}_library}")
            set(violations "${violations}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
    if(NOT own_floor STREQUAL other_floor AND
       NOT rank_of_${own_library}_${other_floor} LESS rank_of_${own_library}_${own_floor})
        violation("${other_floor} is not below ${own_floor}")
    endif()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

# Files of a large room include only files of that room on lower levels.
function(check_levels)
    set(room ${own_floor})
    get_filename_component(own ${file} NAME_WE)
    get_filename_component(other ${header} NAME_WE)
    foreach(stem IN ITEMS ${own} ${other})
        if(NOT DEFINED level_of_${room}_${stem})
            violation("'${stem}' is on no level of dda/${room}")
            set(violations "${violations}" PARENT_SCOPE)
            return()
        endif()
    endforeach()
    if(NOT own STREQUAL other AND NOT level_of_${room}_${other} LESS level_of_${room}_${own})
        violation("${other} is not below ${own}")
    endif()
    set(violations "${violations}" PARENT_SCOPE)
endfunction()

function(check_views)
    foreach(view IN LISTS views)
        string(REPLACE "|" ";" parts "${view};")
        list(GET parts 0 place)
        list(GET parts 1 library)
        list(GET parts 2 seen)
        if("${folder}/" MATCHES "^${place}/" AND other_library STREQUAL library)
            string(REPLACE " " ";" floors "${seen}")
            if(NOT seen STREQUAL "." AND NOT other_floor IN_LIST floors)
                if(seen STREQUAL "")
                    violation("${place} sees nothing of ${library}")
                else()
                    violation("${place} sees only ${seen} of ${library}")
                endif()
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

find_sources(files)
list(LENGTH files file_count)
if(file_count EQUAL 0)
    message(FATAL_ERROR "no sources under ${ROOT}")
endif()
foreach(file IN LISTS files)
    get_filename_component(folder ${file} DIRECTORY)
    locate("${file}" own_library own_floor)
    file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*).*" "\\1" header "${line}")
        locate("${header}" other_library other_floor)
        if(own_library AND own_library STREQUAL other_library)
            check_floors()
            if(own_library STREQUAL "dda" AND DEFINED levels_of_${own_floor} AND own_floor STREQUAL other_floor)
                check_levels()
            endif()
        elseif(own_library AND other_library)
            check_views()
        endif()
        check_private_packages()
    endforeach()
endforeach()

if(violations)
    list(JOIN violations "\n  " text)
    message(FATAL_ERROR "includes that break the floors:\n  ${text}")
endif()
message(STATUS "${file_count} files keep the floors")

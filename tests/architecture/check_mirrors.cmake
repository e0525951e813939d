# Fails when a source of dda/analysis has no unit test of its name.
#   cmake -D ROOT=<folder of the project> -P check_mirrors.cmake
file(GLOB sources RELATIVE ${ROOT}/libdda ${ROOT}/libdda/dda/analysis/*.cpp)
set(missing 0)
foreach(source IN LISTS sources)
    string(REGEX REPLACE "\\.cpp$" "_test.cpp" test tests/unit/${source})
    if(NOT EXISTS ${ROOT}/${test})
        message("${source} has no test ${test}")
        math(EXPR missing "${missing} + 1")
    endif()
endforeach()
if(missing OR NOT sources)
    message(FATAL_ERROR "${missing} sources without a test")
endif()

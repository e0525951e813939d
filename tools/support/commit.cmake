# Writes the source that knows the commit; only when it has changed, so that nothing is linked again without need.
#   cmake -D ROOT=<source tree> -D OUTPUT=<commit.cpp> -P commit.cmake
execute_process(COMMAND git -C ${ROOT} describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed OR NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
    set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#include \"support/commit.hpp\"

namespace rockslope::tool_support {

std::string commit() {
    return \"${commit}\";
}

}  // namespace rockslope::tool_support
" @ONLY)

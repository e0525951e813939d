#include "blockgen/input/gdal_library.hpp"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace rockslope::blockgen {

namespace {

/// @throws std::runtime_error with the loader's reason.
void* loaded_library() {
    void* const library = ::dlopen(GDAL_SONAME, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        throw std::runtime_error("the library " GDAL_SONAME
                                 ", which reads map files and coordinate systems, cannot be loaded: " +
                                 std::string(::dlerror()));
    return library;
}

template <class Function>
void look_up(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    if (function == nullptr) throw std::runtime_error(std::string(GDAL_SONAME " has no function ") + name);
}

GdalLibrary load() {
    void* const library = loaded_library();
    GdalLibrary functions;
#define GDAL_FUNCTION(name) look_up(library, #name, functions.name);
#include "blockgen/input/gdal_functions.def"
#undef GDAL_FUNCTION
    functions.GDALAllRegister();
    return functions;
}

}  // namespace

const GdalLibrary& gdal() {
    static const GdalLibrary library = load();
    return library;
}

}  // namespace rockslope::blockgen

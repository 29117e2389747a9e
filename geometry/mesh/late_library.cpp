// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/late_library.hpp"

#include <dlfcn.h>

#include <cstring>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

LateLibrary::LateLibrary(const std::string& name, const std::string& path)
    : name_(name), handle_(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) failure_ = dlerror();
    if (handle_ == nullptr) handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
}

void* LateLibrary::symbol(const char* function_name, const std::string& file) const {
    if (handle_ == nullptr)
        throw InputError(file, "the library " + name_ + " that reads files of this kind cannot be loaded (" + failure_ + ")",
                         "install it; it was there when this program was built");
    const char* scope = std::strrchr(function_name, ':');
    if (scope != nullptr) function_name = scope + 1;  // C knows no namespaces
    void* address = dlsym(handle_, function_name);
    if (address == nullptr)
        throw InputError(file, "the library " + name_ + " that reads files of this kind has no " + function_name,
                         "install the version that this program was built with");
    return address;
}

}  // namespace abut::geometry

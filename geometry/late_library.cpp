// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/late_library.hpp"

#include <dlfcn.h>

#include "geometry/input_error.hpp"

namespace abut::geometry {

LateLibrary::LateLibrary(const std::string& name, const std::string& what_for)
    : name_(name), what_for_(what_for), handle_(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr)
        throw InputError(what_for_, "the library " + name_ + " that reads files of this kind cannot be loaded",
                         "install it; it was there when this program was built");
}

void* LateLibrary::symbol(const char* name) const {
    void* address = dlsym(handle_, name);
    if (address == nullptr)
        throw InputError(what_for_, "the library " + name_ + " that reads files of this kind has no " + name,
                         "install the version that this program was built with");
    return address;
}

}  // namespace abut::geometry

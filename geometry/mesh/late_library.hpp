// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries that are loaded when they are first needed. Those that read meshes, with what they need in turn, would take
// three quarters of the program's start, and most scenes have no mesh.
#pragma once
#include <string>

namespace abut::geometry {

/// A shared library, loaded when this is made.
class LateLibrary {
public:
    /// Loads it, for good: by its name ("libassimp.so.5"), or from where it was when the program was built.
    LateLibrary(const std::string& name, const std::string& path);

    /// The library's function of this name, of C linkage. Throws InputError (file: what is to be read) where there is no such
    /// library or function.
    template <class Function>
    Function* function(const char* function_name, const std::string& file) const {
        return reinterpret_cast<Function*>(symbol(function_name, file));
    }

private:
    void* symbol(const char* function_name, const std::string& file) const;

    std::string name_, failure_;
    void* handle_;
};

/// A function of a library's by its name in a header, with its namespace.
#define ABUT_LATE(library, name, file) (library).function<decltype(name)>(#name, file)

}  // namespace abut::geometry

// SPDX-License-Identifier: GPL-3.0-or-later
// Shared libraries that are loaded when they are first needed. Those that read meshes, with what they need in turn, would take
// three quarters of the program's start, and most scenes have no mesh.
#pragma once
#include <string>

namespace abut::geometry {

class LateLibrary {
public:
    /// name: as the loader knows it ("libassimp.so.5"). what_for: the file that asks for it, in the error. Throws InputError
    /// (what_for) where there is no such library. Stays loaded to the program's end.
    LateLibrary(const std::string& name, const std::string& what_for);

    /// Of C linkage. Throws InputError (what_for) where it has none of this name.
    template <class Function>
    Function* function(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

private:
    void* symbol(const char* name) const;

    std::string name_, what_for_;
    void* handle_;
};

}  // namespace abut::geometry

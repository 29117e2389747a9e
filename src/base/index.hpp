// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>

namespace abut {

/// An int that counts from 0, as an index of a container.
inline std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace abut

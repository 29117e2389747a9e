// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "apps/arguments.hpp"

namespace abut {

/// The value of --threads; 0 where it is not given: as many as there are processors. Throws InputError if it is no whole number
/// from 1 on.
int threads_of(const Arguments& arguments);

}  // namespace abut

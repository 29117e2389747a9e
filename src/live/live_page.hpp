// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace abut {

/// The page of `abut live`: style and script alone. What it shows it asks for.
std::string live_html();

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/results/result.hpp"

namespace abut {

/// The text of report.html: one file, no network.
std::string report_html(const Result& result);

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
// Names of files that are being written, and what is left of them where a process died over it.
#pragma once
#include <string>

namespace abut {

/// The name of this computer, as the names of files and messages have it; "host" where it does not tell.
std::string host_name();

/// A name to write a file of this name under, in the same folder; hosts and processes that write there at the same time have
/// names of their own.
std::string temporary_name(const std::string& file);

/// Removes the files of such names from a folder whose process ran on this host and is gone.
void remove_abandoned(const std::string& folder);

}  // namespace abut

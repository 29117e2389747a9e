// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/whole_file.hpp"

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "geometry/brep/input_error.hpp"

namespace abut {

std::optional<std::string> whole_file(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return std::nullopt;
    std::string text(static_cast<std::size_t>(std::filesystem::file_size(path, error)), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return stream.bad() ? std::nullopt : std::optional(std::move(text));
}

std::string read_whole_file(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) throw InputError(path, "there is no such file", "check the name and the folder");
    std::optional<std::string> text = whole_file(path);
    if (!text) throw InputError(path, "the file cannot be read", "check its permissions, and that it is no folder");
    return std::move(*text);
}

std::string ending_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

}  // namespace abut

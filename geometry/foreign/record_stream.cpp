// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/record_stream.hpp"

#include <algorithm>
#include <cstdint>

#include "geometry/brep/input_error.hpp"

namespace abut::geometry {

namespace {

/// What is waiting is sent from this size on, as much as a pipe holds.
constexpr std::size_t portion = 1 << 16;

}  // namespace

void RecordWriter::append(const void* bytes, std::size_t n) {
    waiting_.append(static_cast<const char*>(bytes), n);
    if (waiting_.size() >= portion) flush();
}

void RecordWriter::flush() {
    send_(waiting_);
    waiting_.clear();
}

void RecordWriter::count(std::size_t n) {
    const std::uint64_t value = n;
    append(&value, sizeof value);
}

void RecordWriter::text(std::string_view text) {
    text = text.substr(0, most_record_text);
    count(text.size());
    append(text.data(), text.size());
}

void RecordReader::refuse() const {
    throw InputError(file_, "the program that reads files of this kind answered nonsense; the file is damaged",
                     "export it again");
}

char RecordReader::kind() {
    char kind = 0;
    receive_(&kind, 1);
    if (kind != failure_record) return kind;
    const std::string what = text(), hint = text();
    throw InputError(file_, what, hint);
}

std::size_t RecordReader::count(std::size_t most) {
    std::uint64_t n = 0;
    receive_(reinterpret_cast<char*>(&n), sizeof n);
    if (n > most) refuse();
    return static_cast<std::size_t>(n);
}

double RecordReader::number() {
    double value = 0;
    numbers(&value, 1);
    return value;
}

std::string RecordReader::text() {
    std::string text(count(most_record_text), '\0');
    receive_(text.data(), text.size());
    return text;
}

}  // namespace abut::geometry

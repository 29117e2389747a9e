// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader in a process of its own hands over: records of a kind, a letter, and of numbers and texts, whose order both
// sides know. Nothing that comes in is believed: what wrote it may have been overwritten by the file that it read.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::geometry {

/// The largest text of a record, bytes.
inline constexpr std::size_t most_record_text = 1 << 20;

/// Kinds that every stream has: the first record, a failure (what is wrong, what to do), and the last record.
inline constexpr char begin_record = 'b', failure_record = '!', end_record = 'z';

/// Writes records; what was written is sent in large portions, the rest by flush().
class RecordWriter {
public:
    using Send = std::function<void(std::string_view)>;
    explicit RecordWriter(Send send) : send_(std::move(send)) {}

    void kind(char kind) { append(&kind, 1); }
    void count(std::size_t n);
    void number(double value) { append(&value, sizeof value); }
    void numbers(const double* values, std::size_t n) { append(values, n * sizeof *values); }
    void indices(const int* values, std::size_t n) { append(values, n * sizeof *values); }
    /// Cut after most_record_text bytes.
    void text(std::string_view text);
    void flush();

private:
    void append(const void* bytes, std::size_t n);

    Send send_;
    std::string waiting_;
};

/// Reads what a RecordWriter wrote. Throws InputError (file: what is being read) for a failure record, with its words, and for
/// what no writer writes.
class RecordReader {
public:
    /// Fills as many bytes as asked for, or throws.
    using Receive = std::function<void(char*, std::size_t)>;
    RecordReader(std::string file, Receive receive) : file_(std::move(file)), receive_(std::move(receive)) {}

    char kind();
    /// A number of things, not above `most`.
    std::size_t count(std::size_t most);
    double number();
    void numbers(double* values, std::size_t n) { receive_(reinterpret_cast<char*>(values), n * sizeof *values); }
    void indices(int* values, std::size_t n) { receive_(reinterpret_cast<char*>(values), n * sizeof *values); }
    std::string text();
    /// For values that no writer writes.
    [[noreturn]] void refuse() const;

private:
    std::string file_;
    Receive receive_;
};

}  // namespace abut::geometry

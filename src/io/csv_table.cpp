// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/csv_table.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include "src/io/csv_field.hpp"
#include "src/io/json_document.hpp"
#include "src/io/nearest_name.hpp"
#include "src/io/whole_file.hpp"

namespace abut {

namespace {

constexpr const char* byte_order_mark = "\xEF\xBB\xBF";

std::string without_mark(const std::string& text) {
    return text.rfind(byte_order_mark, 0) == 0 ? text.substr(std::string(byte_order_mark).size()) : text;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// One line of the table, quoted fields and all.
struct Record {
    std::vector<std::string> fields;
    int line = 0;
};

class CsvReader {
public:
    CsvReader(const std::string& text, const std::string& file, std::vector<Problem>& problems)
        : text_(text), file_(file), problems_(problems) {}

    /// The next record that is no blank line; nothing at the end.
    std::optional<Record> next() {
        while (at_ < text_.size()) {
            Record record{{}, line_};
            if (text_[at_] == '#') {
                skip_line();
                continue;
            }
            read_fields(record);
            if (record.fields.size() > 1 || !record.fields[0].empty()) return record;
        }
        return std::nullopt;
    }

private:
    bool at_line_end() const { return at_ >= text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }

    void end_line() {
        if (at_ < text_.size() && text_[at_] == '\r') ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++at_;
        ++line_;
    }

    void skip_line() {
        while (!at_line_end()) ++at_;
        end_line();
    }

    void read_fields(Record& record) {
        for (;;) {
            record.fields.push_back(read_field());
            if (at_line_end()) break;
            ++at_;  // the comma
        }
        end_line();
    }

    std::string read_field() {
        while (!at_line_end() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        if (!at_line_end() && text_[at_] == '"') return read_quoted();
        const std::size_t begin = at_;
        while (!at_line_end() && text_[at_] != ',') ++at_;
        return trimmed(text_.substr(begin, at_ - begin));
    }

    std::string read_quoted() {
        const int begin = line_;
        std::string field;
        for (++at_; at_ < text_.size(); ++at_) {
            if (text_[at_] == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
                ++at_;
            } else if (text_[at_] == '"') {
                ++at_;
                skip_after_quotes();
                return field;
            }
            line_ += text_[at_] == '\n';
            field += text_[at_];
        }
        problems_.push_back({file_ + ":" + std::to_string(begin), "the quotes of a field do not close", "write \" at its end"});
        return field;
    }

    void skip_after_quotes() {
        const std::size_t begin = at_;
        while (!at_line_end() && text_[at_] != ',') ++at_;
        if (trimmed(text_.substr(begin, at_ - begin)).empty()) return;
        problems_.push_back({file_ + ":" + std::to_string(line_), "there is text after the quotes of a field",
                             "quotes inside a field are doubled: \"\""});
    }

    const std::string& text_;
    const std::string& file_;
    std::vector<Problem>& problems_;
    std::size_t at_ = 0;
    int line_ = 1;
};

void check_columns(const Table& table, int line, std::vector<Problem>& problems) {
    const std::string where = table.file + ":" + std::to_string(line);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& name = table.columns[i];
        if (name.empty())
            problems.push_back({where, "column " + std::to_string(i + 1) + " has no name", "the first line names the columns"});
        else if (std::find(table.columns.begin(), table.columns.begin() + static_cast<std::ptrdiff_t>(i), name) !=
                 table.columns.begin() + static_cast<std::ptrdiff_t>(i))
            problems.push_back({where, "there are two columns '" + shortened(name) + "'", "rename one of them"});
    }
    if (table.columns.size() == 1 && table.columns[0].find(';') != std::string::npos)
        problems.push_back({where, "the columns are separated by semicolons", "separate them by commas"});
}

void add_row(Table& table, Record record, std::vector<Problem>& problems) {
    if (record.fields.size() > table.columns.size()) {
        problems.push_back({table.file + ":" + std::to_string(record.line),
                            "this row has " + std::to_string(record.fields.size()) + " fields, and there are " +
                                std::to_string(table.columns.size()) + " columns",
                            "put fields that hold commas into quotes"});
        return;
    }
    TableRow row{{}, record.line};
    for (std::size_t i = 0; i < record.fields.size(); ++i)
        if (!record.fields[i].empty()) row.cells[table.columns[i]] = std::move(record.fields[i]);
    table.rows.push_back(std::move(row));
}

void add_object(Table& table, const JsonDocument& document, int line, std::vector<Problem>& problems) {
    const std::string where = table.file + ":" + std::to_string(line);
    for (const Problem& p : document.problems) problems.push_back({where, p.what, p.hint});
    if (document.root.kind != JsonValue::Kind::object) {
        problems.push_back(
            {where, "expected an object, found " + described(document.root), "write {\"file\": ...} on each line"});
        return;
    }
    TableRow row{{}, line};
    for (const JsonValue& item : document.root.items) {
        if (std::find(table.columns.begin(), table.columns.end(), item.key) == table.columns.end())
            table.columns.push_back(item.key);
        if (item.kind == JsonValue::Kind::number)
            row.cells[item.key] = csv_field(item.number);
        else if (item.kind == JsonValue::Kind::string && !item.text.empty())
            row.cells[item.key] = item.text;
        else if (item.kind != JsonValue::Kind::string && item.kind != JsonValue::Kind::null)
            problems.push_back({where + " " + item.pointer, "expected a text or a number, found " + described(item), ""});
    }
    table.rows.push_back(std::move(row));
}

}  // namespace

Table parse_csv(const std::string& text, const std::string& file) {
    std::vector<Problem> problems;
    const std::string content = without_mark(text);
    CsvReader reader(content, file, problems);
    Table table{file, {}, {}};
    std::optional<Record> header = reader.next();
    if (!header) throw InputError(file, "the table is empty", "the first line names the columns: file,name,...");
    table.columns = std::move(header->fields);
    check_columns(table, header->line, problems);
    while (std::optional<Record> record = reader.next()) add_row(table, std::move(*record), problems);
    if (!problems.empty()) throw InputError(std::move(problems));
    return table;
}

Table parse_json_lines(const std::string& text, const std::string& file) {
    std::vector<Problem> problems;
    std::istringstream lines(without_mark(text));
    Table table{file, {}, {}};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        try {
            add_object(table, parse_json(line, file), number, problems);
        } catch (const InputError& error) {
            const std::string where = file + ":" + std::to_string(number);
            for (const Problem& p : error.problems()) problems.push_back({where, p.what, p.hint});
        }
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    return table;
}

bool is_table(const std::string& path) {
    const std::string ending = ending_of(path);
    return ending == ".csv" || ending == ".jsonl" || ending == ".ndjson";
}

Table read_table(const std::string& path) {
    const std::string text = read_whole_file(path);
    return ending_of(path) == ".csv" ? parse_csv(text, path) : parse_json_lines(text, path);
}

std::string place_of(const Table& table, const TableRow& row) {
    return table.file + ":" + std::to_string(row.line);
}

std::optional<std::string> cell(const TableRow& row, const std::string& column) {
    const auto found = row.cells.find(column);
    return found == row.cells.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/io/json_edit.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "src/io/json_document.hpp"

namespace abut {

namespace {

/// Walks over a text that is known to be JSON, copies it, and puts other values in.
class JsonEditor {
public:
    JsonEditor(const std::string& text, const std::map<std::string, std::string>& value_at)
        : text_(text), value_at_(value_at), root_(parse_json(text, "").root) {}

    std::string edited() {
        edit(root_);
        return result_ + text_.substr(copied_);
    }

private:
    void edit(const JsonValue& value) {
        skip_blanks();
        const std::size_t begin = place_;
        if (value.kind == JsonValue::Kind::object || value.kind == JsonValue::Kind::array)
            edit_items(value);
        else if (value.kind == JsonValue::Kind::string)
            skip_string();
        else
            place_ = std::min(text_.find_first_of(",]} \t\r\n/", place_), text_.size());
        const auto other = value_at_.find(value.pointer);
        if (other == value_at_.end()) return;
        result_ += text_.substr(copied_, begin - copied_) + other->second;
        copied_ = place_;
    }

    /// What is to be added to an object or a list, as its text.
    std::string added(const JsonValue& value) const {
        std::string text;
        const std::string prefix = value.pointer + "/";
        for (auto own = value_at_.lower_bound(prefix); own != value_at_.end() && own->first.rfind(prefix, 0) == 0; ++own) {
            const std::string key = own->first.substr(prefix.size());
            const bool is_list = value.kind == JsonValue::Kind::array;
            const auto is_there = [&](const JsonValue& item) { return item.pointer == own->first; };
            if (key.find('/') != std::string::npos || is_list != (key == "-")) continue;
            if (std::any_of(value.items.begin(), value.items.end(), is_there)) continue;
            text += (text.empty() ? "" : ", ") + (is_list ? "" : "\"" + key + "\": ") + own->second;
        }
        return text;
    }

    void edit_items(const JsonValue& value) {
        ++place_;  // the bracket
        std::size_t end = place_;
        for (const JsonValue& item : value.items) {
            skip_blanks();
            if (value.kind == JsonValue::Kind::object) {
                skip_string();
                skip_blanks();
                ++place_;  // the colon
            }
            edit(item);
            end = place_;
            skip_blanks();
            if (text_[place_] == ',') ++place_;
        }
        skip_blanks();
        ++place_;
        const std::string more = value_at_.contains(value.pointer) ? "" : added(value);
        if (more.empty()) return;
        result_ += text_.substr(copied_, end - copied_) + (value.items.empty() ? "" : ", ") + more;
        copied_ = end;
    }

    void skip_string() {
        for (++place_; text_[place_] != '"'; ++place_)
            if (text_[place_] == '\\') ++place_;
        ++place_;
    }

    void skip_blanks() {
        const std::string_view text = text_;
        while (place_ < text.size()) {
            if (text.substr(place_, 2) == "//") {
                place_ = std::min(text.find('\n', place_), text.size());
            } else if (text.substr(place_, 2) == "/*") {
                place_ = text.find("*/", place_) + 2;
            } else if (text.substr(place_, 3) == "\xEF\xBB\xBF") {
                place_ += 3;
            } else if (std::string_view(" \t\r\n").find(text[place_]) != std::string_view::npos) {
                ++place_;
            } else {
                return;
            }
        }
    }

    const std::string& text_;
    const std::map<std::string, std::string>& value_at_;
    JsonValue root_;
    std::size_t place_ = 0, copied_ = 0;  // what is before is in the result
    std::string result_;
};

}  // namespace

std::string with_values(const std::string& text, const std::map<std::string, std::string>& value_at) {
    return JsonEditor(text, value_at).edited();
}

}  // namespace abut

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_binary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "geometry/brep/input_error.hpp"
#include "geometry/dxf/dxf_encoding.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr std::string_view sentinel("AutoCAD Binary DXF\r\n\x1a\0", 22);

enum class Type { text, real, int16, int32, int64, byte, chunk, unknown };

struct TypeRange {
    int first, last;
    Type type;
};

/// The types of values by group code ("Group code value types" of the DXF reference).
constexpr std::array type_ranges{
    TypeRange{0, 9, Type::text},        TypeRange{10, 59, Type::real},      TypeRange{60, 79, Type::int16},
    TypeRange{90, 99, Type::int32},     TypeRange{100, 109, Type::text},    TypeRange{110, 149, Type::real},
    TypeRange{160, 169, Type::int64},   TypeRange{170, 179, Type::int16},   TypeRange{210, 239, Type::real},
    TypeRange{270, 289, Type::int16},   TypeRange{290, 299, Type::byte},    TypeRange{300, 309, Type::text},
    TypeRange{310, 319, Type::chunk},   TypeRange{320, 369, Type::text},    TypeRange{370, 389, Type::int16},
    TypeRange{390, 399, Type::text},    TypeRange{400, 409, Type::int16},   TypeRange{410, 419, Type::text},
    TypeRange{420, 429, Type::int32},   TypeRange{430, 439, Type::text},    TypeRange{440, 459, Type::int32},
    TypeRange{460, 469, Type::real},    TypeRange{470, 481, Type::text},    TypeRange{999, 1003, Type::text},
    TypeRange{1004, 1004, Type::chunk}, TypeRange{1005, 1009, Type::text},  TypeRange{1010, 1059, Type::real},
    TypeRange{1060, 1070, Type::int16}, TypeRange{1071, 1071, Type::int32},
};

Type type_of(int code) {
    for (const TypeRange& range : type_ranges)
        if (code >= range.first && code <= range.last) return range.type;
    return Type::unknown;
}

/// A group whose value is still a place in the pool of texts, which moves while it grows.
struct Raw {
    int code, place;
    std::size_t begin, size;
};

class BinaryReader {
public:
    BinaryReader(const std::string& file, std::string_view bytes)
        : file_(file), bytes_(bytes), at_(sentinel.size()), has_short_codes_(codes_are_short()) {}

    void read() {
        bool is_end = false;
        while (!is_end && at_ < bytes_.size()) {
            const std::size_t place = at_, begin = pool_.size();
            const int code = take_code();
            take_value(code, place);
            const std::string_view value = std::string_view(pool_).substr(begin);
            note_code_page(code, value);
            is_end = code == 0 && value == "EOF";
            if (code != 999) raw_.push_back({code, static_cast<int>(place), begin, value.size()});
        }
    }

    Groups groups() && {
        Groups result;
        result.text = std::make_shared<const std::string>(std::move(pool_));
        result.groups.reserve(raw_.size());
        for (const Raw& raw : raw_)
            result.groups.push_back({raw.code, raw.place, std::string_view(*result.text).substr(raw.begin, raw.size)});
        result.is_binary = true;
        result.file = file_;
        result.last_line = static_cast<int>(bytes_.size());
        return result;
    }

private:
    /// The first group is "0 SECTION" or a comment (999): one byte (or 255 and two), or two bytes.
    bool codes_are_short() const {
        if (bytes_.size() < at_ + 2) return true;
        const auto first = static_cast<unsigned char>(bytes_[at_]), second = static_cast<unsigned char>(bytes_[at_ + 1]);
        const bool is_long_comment = first == (999 & 0xFF) && second == (999 >> 8);
        return first == 255 || (second != 0 && !is_long_comment);
    }

    [[noreturn]] void throw_truncated(std::size_t place) const {
        throw InputError(file_ + ", byte " + std::to_string(place),
                         "the file ends within a group, without its closing EOF: it is truncated", "export or copy it again");
    }

    template <class Number>
    Number take() {
        if (bytes_.size() - at_ < sizeof(Number)) throw_truncated(at_);
        std::array<unsigned char, sizeof(Number)> raw{};
        std::memcpy(raw.data(), bytes_.data() + at_, sizeof(Number));
        at_ += sizeof(Number);
        if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
        return std::bit_cast<Number>(raw);
    }

    int take_code() {
        if (!has_short_codes_) return take<std::uint16_t>();
        const int code = take<std::uint8_t>();
        return code == 255 ? take<std::uint16_t>() : code;
    }

    template <class Number>
    void add_number() {
        std::array<char, 32> digits;
        const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), take<Number>());
        pool_.append(digits.data(), written.ptr);
    }

    void add_text(std::size_t place) {
        const std::size_t end = bytes_.find('\0', at_);
        if (end == std::string_view::npos) throw_truncated(place);
        const std::string_view text = bytes_.substr(at_, end - at_);
        pool_ += to_utf8(std::string(text), code_page_);
        at_ = end + 1;
    }

    /// The header comes before all names.
    void note_code_page(int code, std::string_view value) {
        if (code == 3 && is_code_page_next_) code_page_ = value;
        is_code_page_next_ = code == 9 && value == "$DWGCODEPAGE";
    }

    /// Pictures and the like: nothing of it is read.
    void skip_chunk(std::size_t place) {
        const std::size_t size = take<std::uint8_t>();
        if (bytes_.size() - at_ < size) throw_truncated(place);
        at_ += size;
    }

    void take_value(int code, std::size_t place) {
        switch (type_of(code)) {
            case Type::text:
                return add_text(place);
            case Type::real:
                return add_number<double>();
            case Type::int16:
                return add_number<std::int16_t>();
            case Type::int32:
                return add_number<std::int32_t>();
            case Type::int64:
                return add_number<std::int64_t>();
            case Type::byte:
                return add_number<std::uint8_t>();
            case Type::chunk:
                return skip_chunk(place);
            case Type::unknown:
                break;
        }
        throw InputError(file_ + ", byte " + std::to_string(place),
                         "group code " + std::to_string(code) + " is none that DXF knows",
                         "the file is damaged; export it again");
    }

    const std::string& file_;
    std::string_view bytes_;
    std::size_t at_;
    bool has_short_codes_ = false, is_code_page_next_ = false;
    std::string code_page_;
    std::string pool_;
    std::vector<Raw> raw_;
};

}  // namespace

bool is_binary_dxf(std::string_view bytes) {
    return bytes.substr(0, sentinel.size()) == sentinel;
}

Groups split_binary_groups(const std::string& file, std::string_view bytes) {
    BinaryReader reader(file, bytes);
    reader.read();
    return std::move(reader).groups();
}

}  // namespace abut::geometry::dxf

// SPDX-License-Identifier: MIT
#include "base/json.hpp"

// A namespace of our own: other rooms build RapidJSON with other macros, and the two must not be merged.
#define RAPIDJSON_NAMESPACE posepack_base_rapidjson
#define RAPIDJSON_NAMESPACE_BEGIN namespace posepack_base_rapidjson {
#define RAPIDJSON_NAMESPACE_END }
// Strings and blanks are passed sixteen bytes at a time.
#ifdef __SSE2__
#define RAPIDJSON_SSE2
#endif

#include <fmt/format.h>
#include <rapidjson/error/error.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/text.hpp"

namespace posepack::base {
namespace {

namespace rapidjson = posepack_base_rapidjson;

constexpr std::size_t kDetailBytes = 64;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::size_t kVectorBytes = 16;  // what RapidJSON may look at behind the end, never to use it

// RapidJSON works on a copy of it inside a token, so that Tell() of the original is the token's first byte
// when a handler runs. It reads as '\0' behind its end.
using TextStream = rapidjson::InsituStringStream;

// A key of an open object; its bytes live as long as the parse.
struct Key {
    std::string_view name;
    std::size_t text_offset;
};

// The keys of every open object. Small objects compare each new key with the earlier ones; large ones sort
// their keys once when they close, so that no choice of keys costs more than O(n log n).
class KeyStack {
 public:
    void open() { first_keys_.push_back(keys_.size()); }

    // Adds a key; returns false when the object holds it already.
    bool add(std::string_view name, std::size_t text_offset) {
        const std::size_t first = first_keys_.back();
        if (keys_.size() - first < kSmallObject) {
            for (std::size_t i = first; i < keys_.size(); ++i) {
                if (keys_[i].name == name) return false;
            }
        }
        keys_.push_back({name, text_offset});
        return true;
    }

    // Forgets the innermost object. Returns the first repeated key's offset in the text, or npos.
    std::size_t close(std::string_view* repeated) {
        const std::size_t first = first_keys_.back();
        std::size_t offset = std::string::npos;
        if (keys_.size() - first > kSmallObject) offset = first_repeat(first, repeated);
        first_keys_.pop_back();
        keys_.resize(first);
        return offset;
    }

 private:
    static constexpr std::size_t kSmallObject = 16;

    std::size_t first_repeat(std::size_t first, std::string_view* repeated) {
        const auto begin = keys_.begin() + static_cast<std::ptrdiff_t>(first);
        std::sort(begin, keys_.end(), [](const Key& a, const Key& b) {
            const int order = a.name.compare(b.name);
            return order != 0 ? order < 0 : a.text_offset < b.text_offset;
        });
        std::size_t offset = std::string::npos;
        for (auto key = begin + 1; key < keys_.end(); ++key) {
            if (key[-1].name != key[0].name || key->text_offset >= offset) continue;
            offset = key->text_offset;
            *repeated = key->name;
        }
        return offset;
    }

    std::vector<Key> keys_;
    std::vector<std::size_t> first_keys_;
};

// True when decoded text holds half a surrogate pair, which only a lone \uD800..\uDFFF escape can make:
// the raw text has been checked by then, and RapidJSON lets the low half pass.
bool has_lone_surrogate(const char* text, std::size_t size) {
    const char* end = text + size;
    while (text < end) {
        text = static_cast<const char*>(std::memchr(text, 0xED, static_cast<std::size_t>(end - text)));
        if (text == nullptr || ++text == end) return false;
        if (static_cast<std::uint8_t>(*text) >= 0xA0) return true;
    }
    return false;
}

// Receives RapidJSON's events; each returns false to stop at a fault.
class Checker {
 public:
    Checker(TextStream& stream, bool has_escaped_units, JsonVisitor* visitor)
        : stream_(stream), has_escaped_units_(has_escaped_units), visitor_(visitor) {}

    JsonCheck result;

    bool Null() { return true; }
    bool Bool(bool value) {
        if (visitor_ != nullptr) visitor_->truth(value);
        return true;
    }
    bool Int(int value) { return number(value); }
    bool Uint(unsigned value) { return number(value); }
    bool Int64(std::int64_t value) { return number(static_cast<double>(value)); }
    bool Uint64(std::uint64_t value) { return number(static_cast<double>(value)); }
    bool RawNumber(const char*, rapidjson::SizeType, bool) { return true; }

    bool Double(double value) {
        if (!std::isfinite(value)) return stop(JsonFault::number_range, stream_.Tell(), number_detail());
        return number(value);
    }
    bool String(const char* text, rapidjson::SizeType size, bool) {
        if (has_half_pair(text, size)) return stop_at_half_pair();
        if (visitor_ != nullptr) visitor_->text({text, size});
        return true;
    }
    bool Key(const char* text, rapidjson::SizeType size, bool) {
        if (has_half_pair(text, size)) return stop_at_half_pair();
        const std::string_view key(text, size);
        const std::size_t offset = stream_.Tell();
        if (!keys_.add(key, offset)) return stop_at_repeat(key, offset);
        if (visitor_ != nullptr) visitor_->key(key, offset);
        return true;
    }
    bool StartObject() {
        keys_.open();
        return enter(false);
    }
    bool EndObject(rapidjson::SizeType) {
        leave();
        std::string_view repeated;
        const std::size_t offset = keys_.close(&repeated);
        return offset == std::string::npos || stop_at_repeat(repeated, offset);
    }
    bool StartArray() { return enter(true); }
    bool EndArray(rapidjson::SizeType) {
        leave();
        return true;
    }

    std::string number_detail() const { return "expected a number that fits a double, found a larger one"; }

 private:
    bool stop(JsonFault fault, std::size_t offset, std::string detail) {
        result = {fault, offset, std::move(detail)};
        return false;
    }
    bool stop_at_repeat(std::string_view key, std::size_t offset) {
        return stop(JsonFault::duplicate_key, offset,
                    fmt::format("expected each key once in an object, found '{}' twice",
                                printable(shortened(key, kDetailBytes))));
    }
    bool number(double value) {
        if (visitor_ != nullptr) visitor_->number(value);
        return true;
    }
    bool has_half_pair(const char* text, rapidjson::SizeType size) const {
        return has_escaped_units_ && has_lone_surrogate(text, size);
    }
    bool stop_at_half_pair() {
        return stop(JsonFault::syntax, stream_.Tell(),
                    "expected a pair of \\u surrogate escapes, found one half");
    }
    // A bracket is taken before its event.
    std::size_t last_bracket() { return stream_.Tell() - 1; }
    void leave() {
        --depth_;
        if (visitor_ != nullptr) visitor_->close(last_bracket());
    }
    bool enter(bool is_array) {
        if (++depth_ <= kMaxJsonDepth) {
            if (visitor_ != nullptr) visitor_->open(is_array, last_bracket());
            return true;
        }
        return stop(JsonFault::too_deep, last_bracket(),
                    fmt::format("expected at most {} levels of nesting, found more", kMaxJsonDepth));
    }

    TextStream& stream_;
    bool has_escaped_units_;  // the text holds "\u" somewhere; most do not, and skip a search per string
    JsonVisitor* visitor_;    // may be null
    KeyStack keys_;
    std::size_t depth_ = 0;
};

std::string_view expectation(rapidjson::ParseErrorCode code) {
    switch (code) {
        case rapidjson::kParseErrorDocumentEmpty:
            return "a JSON value";
        case rapidjson::kParseErrorDocumentRootNotSingular:
            return "the end of the text after the value";
        case rapidjson::kParseErrorValueInvalid:
            return "a JSON value";
        case rapidjson::kParseErrorObjectMissName:
            return "a key in double quotes";
        case rapidjson::kParseErrorObjectMissColon:
            return "':' after the key";
        case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
            return "',' or '}' in the object";
        case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
            return "',' or ']' in the array";
        case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
            return "four hexadecimal digits after \\u";
        case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
            return "a pair of \\u surrogate escapes";
        case rapidjson::kParseErrorStringEscapeInvalid:
            return "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u";
        case rapidjson::kParseErrorStringMissQuotationMark:
            return "a closing '\"'";
        case rapidjson::kParseErrorStringInvalidEncoding:
            return "no control characters in a string";
        case rapidjson::kParseErrorNumberMissFraction:
            return "a digit after '.'";
        case rapidjson::kParseErrorNumberMissExponent:
            return "a digit in the exponent";
        default:
            return "valid JSON";
    }
}

std::string found_at(std::string_view text, std::size_t offset) {
    if (offset >= text.size()) return "the end of the text";
    if (text.substr(offset, kByteOrderMark.size()) == kByteOrderMark)
        return "a byte-order mark (save as UTF-8 without it)";
    const auto byte = static_cast<std::uint8_t>(text[offset]);
    if (byte < 0x20 || byte >= 0x7F) return fmt::format("byte 0x{:02X}", byte);
    return fmt::format("'{}'", text[offset]);
}

JsonCheck syntax_fault(std::string_view text, std::size_t offset, std::string_view expected) {
    return {JsonFault::syntax, offset,
            fmt::format("expected {}, found {}", expected, found_at(text, offset))};
}

// Index of the first byte that is not ASCII, at or after `index`; the size when there is none.
std::size_t skip_ascii(std::string_view text, std::size_t index) {
    constexpr std::uint64_t kHighBits = 0x8080808080808080;
    for (; index + 8 <= text.size(); index += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + index, 8);
        if ((word & kHighBits) != 0) break;
    }
    while (index < text.size() && static_cast<std::uint8_t>(text[index]) < 0x80) ++index;
    return index;
}

// Index of the first byte that begins no well-formed character, or npos.
std::size_t first_malformed_utf8(std::string_view text) {
    std::size_t index = skip_ascii(text, 0);
    while (index < text.size()) {
        std::size_t size = 2;
        while (size <= 4 && !is_utf8(text.substr(index, size))) ++size;
        if (size > 4) return index;
        index = skip_ascii(text, index + size);
    }
    return std::string_view::npos;
}

}  // namespace

JsonCheck check_json(std::string_view text, JsonVisitor* visitor) {
    const std::size_t malformed = first_malformed_utf8(text);
    if (malformed != std::string_view::npos) {
        return {JsonFault::utf8, malformed,
                fmt::format("expected well-formed UTF-8, found {}", found_at(text, malformed))};
    }
    // Strings are unescaped in place: in a copy, since the text is the caller's.
    std::string copy;
    copy.reserve(text.size() + kVectorBytes);
    copy.append(text).append(kVectorBytes, '\0');
    TextStream stream(copy.data());
    Checker checker(stream, text.find("\\u") != std::string_view::npos, visitor);
    rapidjson::Reader reader;
    // The recursive parser, which is the faster one: the checker stops it at kMaxJsonDepth levels.
    const rapidjson::ParseResult parsed = reader.Parse<rapidjson::kParseInsituFlag>(stream, checker);
    if (checker.result.fault != JsonFault::none) return checker.result;
    if (parsed.Code() == rapidjson::kParseErrorNumberTooBig) {
        return {JsonFault::number_range, parsed.Offset(), checker.number_detail()};
    }
    if (parsed.IsError()) return syntax_fault(text, parsed.Offset(), expectation(parsed.Code()));
    // A zero byte looks like the end to RapidJSON.
    if (stream.Tell() != text.size()) return syntax_fault(text, stream.Tell(), "the end of the text");
    return {};
}

}  // namespace posepack::base

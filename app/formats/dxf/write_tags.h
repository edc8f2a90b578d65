// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <QIODevice>
#include <QString>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace app::dxf::writing {

/// One line of a table of constant tags.
struct Tag {
    int code;
    std::string_view value;
};

/// Writes the tags of a DXF file: a code and its value, each on a line of its own.
class TagWriter {
public:
    explicit TagWriter(QIODevice& out) : out_(out) {}

    void text(int code, std::string_view value);
    void whole(int code, std::int64_t value);
    void number(int code, double value);
    void handle(int code, std::uint64_t value); ///< in hexadecimal digits
    /// The codes `code`, code + 10 and, as 0, code + 20.
    void point(int code, const Point& point);
    void flatPoint(int code, const Point& point); ///< without z
    void all(std::initializer_list<Tag> tags);

    /// Writes the rest. Returns nothing, or what went wrong.
    std::optional<QString> finish();
    bool failed() const { return failed_; }

private:
    void begin(int code);
    void end();
    void flush();

    QIODevice& out_;
    std::string text_;
    bool failed_ = false;
};

} // namespace app::dxf::writing

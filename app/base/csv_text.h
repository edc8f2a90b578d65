// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>
#include <QString>

#include <string>
#include <string_view>
#include <vector>

namespace app::csv {

/// Thrown where the text is not CSV, and caught at the reader's border. `why` ends with a full stop
/// and goes on from "line 12 ".
struct Refused {
    std::size_t line;
    QString why;
};

/// One record of RFC 4180: fields without their quotation marks.
struct Record {
    std::size_t line = 0; ///< 1-based, where it begins in the file
    std::vector<std::string> fields;
};

/// Comma-separated text as records, one after the other: quoted fields, LF or CR LF, a byte order
/// mark; blank lines and lines that begin with # are passed over. Memory is bounded by one record.
class Text {
public:
    explicit Text(QIODevice& in) : in_(in) {}

    /// Reads the next record; false at the end. `record` is reused, so that nothing is allocated.
    bool next(Record& record);

    /// From now on a line that begins with # is a record like others (a colour may come first).
    void endComments() { comments_ = false; }

private:
    int get();  ///< the next byte, or -1
    int peek(); ///< the byte that `get` will give
    void skipLine();
    void readField(std::string& field, std::size_t& size);
    void readQuoted(std::string& field, std::size_t& size);
    void endRecord();

    QIODevice& in_;
    QByteArray buffer_;
    qsizetype at_ = 0;
    std::size_t line_ = 1;
    bool started_ = false;
    bool comments_ = true;
};

/// Appends a field, in quotation marks where it needs them.
void appendField(std::string& text, std::string_view field);

} // namespace app::csv

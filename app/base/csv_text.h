// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>
#include <QString>

#include <string>
#include <string_view>
#include <vector>

namespace app::csv {

/// Thrown if the text is not CSV, and caught inside the reader. `why` continues a sentence that
/// begins with "line 12 ", and ends with a full stop.
struct Refused {
    std::size_t line; ///< 0: `why` is about the whole file
    QString why;
};

constexpr std::size_t longestRecord = 1 << 20; ///< bytes; longer text without an end is not CSV

/// One record of RFC 4180: fields without their quotation marks.
struct Record {
    std::size_t line = 0; ///< 1-based line of the file on which the record begins
    std::vector<std::string> fields;
};

constexpr char anyBlanks = ' '; ///< as a separator: any number of spaces and tabs
/// Whether a character stands between fields.
constexpr bool separates(char c, char separator)
{
    return c == separator || (separator == anyBlanks && c == '\t');
}

/// Reads comma-separated text record by record: quoted fields, LF or CR LF, a byte order mark.
/// Blank lines and lines that begin with # are skipped. The memory used is bounded by one record.
class Records {
public:
    explicit Records(QIODevice& in, char separator = ',') : in_(in), separator_(separator) {}

    /// Reads the next record; false at the end. Reuses the memory of `record`.
    bool next(Record& record);

    /// Treats later lines that begin with # as records (a first field may be a colour).
    void endComments() { comments_ = false; }

    /// The text is a later part of a file: a byte order mark belongs to its first field.
    void beginWithinFile() { started_ = true; }

private:
    int get();  ///< the next byte, or -1
    int peek(); ///< the byte that `get` will return, or -1
    void fill();
    void skipLine();
    void readField(std::string& field, std::size_t& size);
    void readQuoted(std::string& field, std::size_t& size);
    bool endsField(int c) const;
    bool takeSeparator();
    void endRecord();

    QIODevice& in_;
    char separator_;
    QByteArray buffer_;
    qsizetype at_ = 0;
    std::size_t line_ = 1;
    bool started_ = false;
    bool comments_ = true;
};

/// Appends a field, in quotation marks where CSV requires them.
void appendField(std::string& text, std::string_view field);

} // namespace app::csv

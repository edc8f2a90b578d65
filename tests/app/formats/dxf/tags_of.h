// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <QBuffer>
#include <QMap>

#include "tests/app/formats/svg/text.h"

// What is written in a DXF file, as plain lists.

/// A record: its type (the value of code 0), and what follows it.
struct DxfRecord {
    QByteArray type;
    QList<std::pair<int, QByteArray>> tags;

    QByteArray text(int code) const
    {
        for (const auto& [found, value] : tags)
            if (found == code)
                return value;
        return {};
    }
    bool has(int code) const { return !text(code).isNull(); }
    double number(int code) const { return text(code).toDouble(); }
    QList<double> numbers(int code) const
    {
        QList<double> all;
        for (const auto& [found, value] : tags)
            if (found == code)
                all << value.toDouble();
        return all;
    }
    app::Point point(int code) const { return {number(code), number(code + 10)}; }
};

inline QByteArray dxfOf(const app::Document& document, const app::WriteOptions& options = {})
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const auto error = app::findFormat(u"dxf")->write(document, buffer, options);
    return error ? "error: " + error->toUtf8() : buffer.data();
}

inline QList<DxfRecord> recordsOf(const QByteArray& file)
{
    QList<DxfRecord> all;
    const QList<QByteArray> lines = file.split('\n');
    for (qsizetype i = 0; i + 1 < lines.size(); i += 2)
        if (lines[i].trimmed() == "0")
            all.push_back({lines[i + 1], {}});
        else if (!all.isEmpty())
            all.back().tags.emplace_back(lines[i].toInt(), lines[i + 1]);
    return all;
}

/// The records of a section, or of a table: those with that type.
inline QList<DxfRecord> entriesOf(const QByteArray& file, const QByteArray& type)
{
    QList<DxfRecord> all;
    for (const DxfRecord& record : recordsOf(file))
        if (record.type == type)
            all << record;
    return all;
}

inline QList<DxfRecord> entitiesOf(const QByteArray& file)
{
    QList<DxfRecord> all;
    bool inside = false;
    for (const DxfRecord& record : recordsOf(file)) {
        if (record.type == "SECTION" || record.type == "ENDSEC")
            inside = record.text(2) == "ENTITIES";
        else if (inside)
            all << record;
    }
    return all;
}

/// What becomes of elements of SVG on a page of 100 by 100 mm.
inline QByteArray dxfOfSvg(const QByteArray& elements, const app::WriteOptions& options = {})
{
    const auto read =
        readText("<svg xmlns='http://www.w3.org/2000/svg' "
                 "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' width='100mm' "
                 "height='100mm' viewBox='0 0 100 100' fill='none' stroke='black'>"
                 + elements + "</svg>");
    return read ? dxfOf(read.value->document, options) : "error: " + read.error.toUtf8();
}

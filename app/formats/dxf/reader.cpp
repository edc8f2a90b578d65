// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/reader.h"

#include "app/base/memory.h"
#include "app/base/text.h"
#include "app/formats/dxf/binary.h"
#include "app/formats/dxf/drawer.h"
#include "app/formats/dxf/limits.h"
#include "app/formats/dxf/losses.h"
#include "app/formats/painted.h"
#include "app/formats/svg/refused.h"
#include "app/formats/whole_pipe.h"

#include <algorithm>

namespace app::dxf {
namespace {

using svg::Refused;

[[noreturn]] void refuseFile(const QString& why) { throw Refused{why, Refused::wholeFile}; }

/// The parts of a file, found in one pass; entities are drawn when all of them are known.
class FileReader {
public:
    FileReader(std::string_view text, const ReadOptions& options)
        : text_(text), options_(options), records_(text)
    {
    }

    Imported read()
    {
        refuseOther();
        while (records_.next(record_))
            if (record_.type == "SECTION")
                readSection(record_.text(2));
        tellEnd();
        if (options_.unit)
            header_.unit = DrawingUnit{0, infoOf(*options_.unit).millimetres, *options_.unit};
        Drawer drawer(header_, tables_, blocks_, report_, text_.size());
        for (const Records& entities : entities_)
            drawer.drawAll(entities, {});
        Imported imported;
        imported.document = drawer.take();
        if (!header_.unit)
            report_.add(losses::noUnit);
        if (const auto fault = faultOf(imported.document.page()))
            refuseFile(*fault);
        imported.report = report_.losses();
        imported.paged = false;
        return imported;
    }

private:
    void refuseOther() const
    {
        if (text_.empty())
            refuseFile(Text::tr("it is empty."));
        if (records_.nextType() != "SECTION" && records_.nextType() != "EOF")
            refuseFile(Text::tr("it is no DXF file: its first lines are not 0 and SECTION."));
    }

    void readSection(std::string_view name)
    {
        if (name == "HEADER") {
            readHeader(record_, header_, report_);
        } else if (name == "TABLES") {
            while (within())
                readTableEntry(record_, tables_, report_);
        } else if (name == "BLOCKS") {
            while (within())
                if (record_.type == "BLOCK")
                    readBlock();
        } else if (name == "ENTITIES") {
            entities_.push_back(records_);
        }
    }
    // The next record of the section; false at its end.
    bool within()
    {
        return records_.nextType() != "SECTION" && records_.next(record_)
               && record_.type != "ENDSEC";
    }

    void readBlock()
    {
        constexpr int otherDrawing = 4 | 8 | 16 | 32;
        try {
            const bool other = (record_.integer(70) & otherDrawing) != 0;
            blocks_.insert_or_assign(inCapitals(record_.text(2)),
                                     Block{record_.point(10), records_, other});
        } catch (const BadValue&) {
            report_.turnTo(record_.line);
            report_.add(losses::badEntity, record_.type);
        }
    }

    void tellEnd()
    {
        report_.turnTo(records_.line());
        if (records_.damaged())
            report_.add(losses::damage);
        else if (record_.type != "EOF")
            report_.add(losses::truncated);
    }

    std::string_view text_;
    const ReadOptions& options_;
    Records records_;
    Record record_;
    Report report_;
    Header header_;
    Tables tables_;
    Blocks blocks_;
    std::vector<Records> entities_;
};

QByteArray allOf(QIODevice& in)
{
    if (in.isSequential()) {
        auto data = wholePipe(in, mostBytes);
        if (!data)
            refuseFile(data.error);
        return std::move(*data.value);
    }
    if (const QString fault = memoryFault(std::uint64_t(in.size()) * memoryOfByte);
        !fault.isEmpty())
        refuseFile(fault);
    return in.readAll();
}

void refuseDwg(const QByteArray& start)
{
    const bool isDwg = start.size() >= 6 && start.startsWith("AC")
                       && std::all_of(start.begin() + 2, start.begin() + 6,
                                      [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    if (isDwg)
        refuseFile(
            Text::tr("it is a DWG file, which Clearcut does not read. Convert it to DXF first, "
                     "for example with dwg2dxf of LibreDWG or with the ODA File Converter."));
}

QByteArray textOfFile(QIODevice& in)
{
    refuseDwg(in.peek(6));
    QByteArray text = allOf(in);
    if (isBinary(text))
        return textOfBinary(text);
    if (text.startsWith("\xef\xbb\xbf"))
        text.remove(0, 3);
    if (!text.contains('\n'))
        text.replace('\r', '\n');
    return text;
}

} // namespace

Result<Imported> read(QIODevice& in, const ReadOptions& options)
{
    try {
        const QByteArray text = textOfFile(in);
        return Result<Imported>::of(
            FileReader({text.constData(), std::size_t(text.size())}, options).read());
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            refused.line > 0 ? Text::tr("line %1 %2").arg(refused.line).arg(refused.why)
                             : refused.why);
    }
}

} // namespace app::dxf

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/csv/reader.h"

#include "app/base/csv_text.h"
#include "app/formats/csv/lines_by_layer.h"
#include "app/formats/csv/row_reader.h"

#include <QCoreApplication>

namespace app::csv {
namespace {

class Reader {
public:
    explicit Reader(QIODevice& in) : text_(in) {}

    Imported read()
    {
        Record record;
        if (text_.next(record) && !readHeader(record))
            addRow(record);
        while (text_.next(record))
            addRow(record);
        finish();
        return std::move(imported_);
    }

private:
    Fields fieldsOf(const Record& record)
    {
        fields_.assign(record.fields.begin(), record.fields.end());
        return fields_;
    }

    bool readHeader(const Record& record)
    {
        if (!rows_.readHeader(fieldsOf(record), record.line))
            return false;
        if (rows_.beginsWithColour())
            text_.endComments();
        return true;
    }

    void addRow(const Record& record)
    {
        if (lines_.size() == mostRows)
            throw Refused{
                record.line,
                Words::tr("exceeds the limit of %1 lines. Split the file.").arg(mostRows)};
        const Row row = rows_.row(fieldsOf(record), record.line);
        const StyleEntry style = styleOf(row, record.line);
        lines_.turnTo(row.layer);
        lines_.add(row.line, style);
    }

    // Most rows have the style of the previous row.
    StyleEntry styleOf(const Row& row, std::size_t line)
    {
        if (!style_ || row.colour != colour_ || row.width != width_) {
            style_ = lines_.style(csv::styleOf(row, line));
            colour_ = row.colour;
            width_ = row.width;
        }
        return *style_;
    }

    void finish()
    {
        imported_.paged = false;
        imported_.report = rows_.report();
        if (const int beyond = lines_.beyond(); beyond > 0)
            imported_.report.push_back(
                {Words::tr("layer names of lines, beyond the first %1 layers")
                     .arg(Containers::mostLayers),
                 beyond});
        imported_.document = lines_.take();
        imported_.rows = lines_.order();
    }

    Text text_;
    RowReader rows_;
    std::vector<std::string_view> fields_; ///< of the current record
    LinesByLayer lines_;
    std::string colour_, width_; ///< of the last row
    std::optional<StyleEntry> style_;
    Imported imported_;
};

} // namespace

Result<Imported> read(QIODevice& in)
{
    try {
        return Result<Imported>::of(Reader(in).read());
    } catch (const Refused& refused) {
        return Result<Imported>::failure(
            Words::tr("line %1 %2").arg(refused.line).arg(refused.why));
    }
}

} // namespace app::csv

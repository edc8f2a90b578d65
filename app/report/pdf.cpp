// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/report/document.h"
#include "app/report/keep_together.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>

namespace app {
namespace {

constexpr int resolution = 600;
constexpr double footerMillimetres = 8, marginMillimetres = 15;

double dots(double millimetres) { return millimetres / 25.4 * resolution; }

QPageLayout a4()
{
    constexpr double m = marginMillimetres;
    return {QPageSize(QPageSize::A4), QPageLayout::Portrait, {m, m, m, m}, QPageLayout::Millimeter};
}

/// "Title                    2 of 7"
void paintFooter(QPainter& painter, const QSizeF& paper, const QString& title, int page, int pages)
{
    const QRectF line(0, paper.height() - dots(4), paper.width(), dots(4));
    painter.setPen(documentLook().muted);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignBottom, title);
    painter.drawText(line, Qt::AlignRight | Qt::AlignBottom,
                     Text::tr("%1 of %2").arg(page).arg(pages));
}

void paintPages(QPdfWriter& writer, QTextDocument& document, const QString& title)
{
    const QSizeF paper(writer.width(), writer.height());
    const QSizeF page(paper.width(), paper.height() - dots(footerMillimetres));
    document.documentLayout()->setPaintDevice(&writer);
    document.setPageSize(page);
    keepTogether(document);
    QFont font = document.defaultFont();
    font.setPointSizeF(8);
    QPainter painter(&writer);
    for (int number = 0; number < document.pageCount(); ++number) {
        if (number > 0)
            writer.newPage();
        painter.save();
        painter.translate(0, -number * page.height());
        document.drawContents(&painter, QRectF(QPointF(0, number * page.height()), page));
        painter.restore();
        painter.setFont(font);
        paintFooter(painter, paper, title, number + 1, document.pageCount());
    }
}

} // namespace

/// A4 pages, charts and text as vectors.
std::optional<QString> writePdfReport(const Report& report, QIODevice& out)
{
    QBuffer buffer; // QPdfWriter does not report errors of the device
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(resolution);
    writer.setPageLayout(a4());
    writer.setTitle(report.title);
    writer.setCreator(QStringLiteral("Clearcut"));
    const auto document = documentOf(report, resolution);
    paintPages(writer, *document, report.title);
    const QByteArray& bytes = buffer.data();
    const bool all = writeAll(out, {bytes.data(), std::size_t(bytes.size())});
    return all ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace app

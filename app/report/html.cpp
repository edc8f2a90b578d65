// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/charts/chart_file.h"
#include "app/experiment/heading.h"
#include "app/report/report.h"

#include <QRegularExpression>

namespace app {
namespace {

/// Escapes text and attributes, and removes characters that XML forbids.
QString escaped(const QString& text)
{
    QString clean;
    for (const QChar c : text)
        if (c >= u' ' || c == u'\n' || c == u'\t')
            clean += c;
    return clean.toHtmlEscaped();
}

QString element(const char* name, const QString& content)
{
    return QStringLiteral("<%1>%2</%1>\n").arg(QLatin1StringView(name), content);
}

/// The chart's drawing as a part of the page, with unique ids.
QString drawing(const Chart& chart, Ground ground, const QString& id)
{
    const ChartLook look = chartLook(ground);
    QString svg = QString::fromUtf8(chartBytes(chart, *kindOf(chartFormats(), u"svg"), look));
    svg.remove(0, std::max<qsizetype>(svg.indexOf(QStringLiteral("<svg")), 0));
    static const QRegularExpression defined(QStringLiteral("\\bid=\"")),
        used(QStringLiteral("(url\\(#|xlink:href=\"#)")), size(QStringLiteral("^<svg [^>]*>"));
    svg.replace(defined, QStringLiteral("id=\"%1-").arg(id));
    svg.replace(used, QStringLiteral("\\1%1-").arg(id));
    const QSizeF pixels = usualSize(chart, look);
    const QString head =
        QStringLiteral("<svg class=\"%1\" role=\"img\" aria-label=\"%2\" "
                       "xmlns=\"http://www.w3.org/2000/svg\" "
                       "xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
                       "viewBox=\"0 0 %3 %4\">")
            .arg(ground == Ground::Light ? u"light" : u"dark", escaped(chart.title),
                 QString::number(pixels.width()), QString::number(pixels.height()));
    return svg.replace(size, head);
}

QString figure(const Chart& chart, int number)
{
    const QString id = QStringLiteral("chart%1").arg(number);
    return QStringLiteral("<figure>\n%1%2<details><summary>%3</summary><p>%4</p></details>\n"
                          "</figure>\n")
        .arg(drawing(chart, Ground::Light, id + u'l'), drawing(chart, Ground::Dark, id + u'd'),
             escaped(Text::tr("The chart in words")),
             escaped(textOf(chart)).replace(u'\n', QStringLiteral("<br/>\n")));
}

QString rowOf(const QStringList& fields, const std::vector<bool>& numeric)
{
    QString row;
    for (qsizetype i = 0; i < fields.size(); ++i)
        row += QStringLiteral("<td%1>%2</td>")
                   .arg(numeric[std::size_t(i)] ? QStringLiteral(" class=\"n\"") : QString(),
                        escaped(readable(fields[i], numeric[std::size_t(i)])));
    return element("tr", row);
}

QString headRow(const Table& table, const std::vector<bool>& numeric)
{
    QString row;
    for (qsizetype i = 0; i < table.names.size(); ++i) {
        const Heading heading = headingOf(table.names[i]);
        row += QStringLiteral("<th scope=\"col\"%1 title=\"%2\">%3</th>")
                   .arg(numeric[std::size_t(i)] ? QStringLiteral(" class=\"n\"") : QString(),
                        escaped(heading.meaning),
                        escaped(heading.text).replace(u'\n', QStringLiteral("<br/>")));
    }
    return element("tr", row);
}

QString factsText(const Table& table)
{
    QStringList facts;
    for (const auto& [name, value] : table.facts)
        facts << escaped(name) + QStringLiteral(": ") + escaped(value);
    return facts.join(QStringLiteral("; "));
}

QString tableText(const Table& table)
{
    const auto numeric = numericColumns(table);
    QString rows;
    for (const QStringList& row : table.rows)
        rows += rowOf(row, numeric);
    QString text =
        QStringLiteral("<div class=\"table\">\n<table>\n%1<thead>\n%2</thead>\n<tbody>\n"
                       "%3</tbody>\n</table>\n</div>\n")
            .arg(element("caption", escaped(table.title)), headRow(table, numeric), rows);
    for (const QString& note : table.notes)
        text += QStringLiteral("<p class=\"note\">%1</p>\n").arg(escaped(note));
    if (!table.facts.empty())
        text += QStringLiteral("<p class=\"note\">%1.</p>\n").arg(factsText(table));
    return text;
}

QString coloursOf(Ground ground)
{
    const ChartLook look = chartLook(ground);
    return QStringLiteral("--paper: %1; --text: %2; --muted: %3; --rule: %4;")
        .arg(look.paper.name(), look.text.name(), look.muted.name(), look.rule.name());
}

QString styleText()
{
    return QStringLiteral(":root { color-scheme: light dark; %1 }\n"
                          "svg.dark { display: none; }\n"
                          "@media screen and (prefers-color-scheme: dark) {\n"
                          "  :root { %2 }\n  svg.light { display: none; }\n  svg.dark { display: "
                          "block; }\n}\n")
               .arg(coloursOf(Ground::Light), coloursOf(Ground::Dark))
           + QStringLiteral(
               "body { background: var(--paper); color: var(--text); max-width: 60rem; margin: 0 "
               "auto; padding: 1.5rem; font: 0.95rem/1.5 system-ui, sans-serif; }\n"
               "h1 { font-size: 1.7rem; font-weight: 600; margin: 0 0 0.5rem; }\n"
               "h2 { font-size: 1.25rem; font-weight: 600; margin: 2.5rem 0 0.5rem; border-top: "
               "1px solid var(--rule); padding-top: 1rem; }\n"
               "p { max-width: 44rem; margin: 0.5rem 0; }\n"
               ".summary p { font-size: 1.05rem; }\n"
               "nav ul { padding-left: 1.2rem; }\n"
               "a { color: inherit; }\n"
               "figure { margin: 1.5rem 0; }\n"
               "svg { width: 100%; max-width: 720px; height: auto; }\n"
               ".table { overflow-x: auto; margin: 1.5rem 0 0.5rem; }\n"
               "table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: "
               "tabular-nums; }\n"
               "caption { text-align: left; font-weight: 600; padding-bottom: 0.4rem; }\n"
               "th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px "
               "solid var(--rule); white-space: nowrap; }\n"
               "th { color: var(--muted); font-weight: 400; vertical-align: bottom; }\n"
               ".n { text-align: right; }\n"
               ".note, details { color: var(--muted); font-size: 0.85rem; }\n"
               "pre { overflow-x: auto; padding: 0.8rem; border: 1px solid var(--rule); }\n"
               "@media print {\n"
               "  body { padding: 0; max-width: none; font-size: 9pt; }\n"
               "  nav, details { display: none; }\n"
               "  figure, tr { break-inside: avoid; }\n  h2, caption { break-after: avoid; }\n"
               "  .table { overflow: visible; }\n"
               "  table { font-size: 6.5pt; }\n  th, td { padding-right: 0.5rem; white-space: "
               "normal; }\n"
               "  pre { white-space: pre-wrap; }\n}\n");
}

QString paragraphs(const QStringList& sentences)
{
    QString text;
    for (const QString& sentence : sentences)
        text += element("p", escaped(sentence));
    return text;
}

QString contents(const Report& report)
{
    QString rows;
    for (std::size_t i = 0; i < report.sections.size(); ++i)
        rows += QStringLiteral("<li><a href=\"#part%1\">%2</a></li>\n")
                    .arg(i + 1)
                    .arg(escaped(report.sections[i].title));
    return QStringLiteral("<nav>\n<ul>\n%1</ul>\n</nav>\n").arg(rows);
}

QString sectionsText(const Report& report)
{
    QString text;
    int chart = 0, part = 0;
    for (const ReportSection& section : report.sections) {
        text += QStringLiteral("<section id=\"part%1\">\n<h2>%2</h2>\n")
                    .arg(++part)
                    .arg(escaped(section.title));
        text += paragraphs(section.sentences);
        if (!section.code.isEmpty())
            text += element("pre", escaped(section.code));
        for (const Chart& one : section.charts)
            text += figure(one, ++chart);
        for (const Table& table : section.tables)
            text += tableText(table);
        text += QStringLiteral("</section>\n");
    }
    return text;
}

} // namespace

/// One self-contained page, also well-formed XML; light or dark by the reader's setting.
std::optional<QString> writeHtmlReport(const Report& report, QIODevice& out)
{
    const QString title = escaped(report.title);
    const QString text =
        QStringLiteral(
            "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n"
            "<head>\n<meta charset=\"utf-8\"/>\n"
            "<meta name=\"viewport\" content=\"width=device-width, "
            "initial-scale=1\"/>\n"
            "<meta name=\"generator\" content=\"Clearcut\"/>\n")
        + element("title", title) + element("style", styleText())
        + QStringLiteral("</head>\n<body>\n") + element("h1", title)
        + QStringLiteral("<div class=\"summary\">\n") + paragraphs(report.summary)
        + QStringLiteral("</div>\n") + contents(report) + sectionsText(report)
        + QStringLiteral("</body>\n</html>\n");
    const bool all = writeAll(out, text.toStdString());
    return all ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace app

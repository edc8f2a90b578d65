// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/markdown_html.h"

#include <QTextBlock>
#include <QTextDocument>
#include <QTextList>

namespace app {

namespace {

/// A piece of text of one format.
QByteArray fragmentHtml(const QTextFragment& fragment)
{
    const QTextCharFormat format = fragment.charFormat();
    QByteArray html = fragment.text().toHtmlEscaped().toUtf8();
    html.replace("\xE2\x80\xA8", "<br>"); // a line separator
    const auto wrap = [&](bool does, const char* tag) {
        if (does)
            html = QByteArray("<") + tag + '>' + html + "</" + tag + '>';
    };
    wrap(format.fontFixedPitch(), "code");
    wrap(format.fontItalic(), "em");
    wrap(format.fontWeight() > QFont::Medium, "strong");
    return format.isImageFormat() ? QByteArray() : html;
}

/// The element of a block; of its list, "li".
QByteArray tagOf(const QTextBlock& block)
{
    if (block.textList())
        return "li";
    if (block.blockFormat().headingLevel() > 0)
        return "h3";
    return block.blockFormat().hasProperty(QTextFormat::BlockCodeFence) ? "pre" : "p";
}

QByteArray listTagOf(const QTextBlock& block)
{
    if (!block.textList())
        return {};
    return block.textList()->format().style() <= QTextListFormat::ListDecimal ? "ol" : "ul";
}

} // namespace

QByteArray markdownHtml(const QString& markdown)
{
    QTextDocument document;
    document.setMarkdown(markdown,
                         QTextDocument::MarkdownFeatures(QTextDocument::MarkdownDialectGitHub
                                                         | QTextDocument::MarkdownNoHTML));
    QByteArray html, list;
    const auto changeList = [&](const QByteArray& to) {
        if (to == list)
            return;
        html += (list.isEmpty() ? QByteArray() : "</" + list + ">\n")
                + (to.isEmpty() ? QByteArray() : '<' + to + ">\n");
        list = to;
    };
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        QByteArray text;
        for (auto i = block.begin(); !i.atEnd(); ++i)
            text += fragmentHtml(i.fragment());
        if (text.isEmpty())
            continue;
        changeList(listTagOf(block));
        html += '<' + tagOf(block) + '>' + text + "</" + tagOf(block) + ">\n";
    }
    changeList({});
    return html;
}

} // namespace app

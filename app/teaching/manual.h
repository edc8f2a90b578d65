// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace app {

/// A page of the manual: a file in resources/manual/, whose README explains the format.
struct ManualPage {
    QString topic; ///< the file's name without ".md"
    QString title;
    QString markdown;       ///< without comments; links to other pages are "TOPIC.md"
    QStringList explains{}; ///< the commands, by key, whose page this is
    QString shows{};        ///< its steps as the program performs them (shown_steps.h); or empty
};

/// A part of the index: its heading and the topics below it.
struct ManualPart {
    QString title;
    QStringList topics;
};

inline const QString manualIndex = QStringLiteral("index"); ///< the topic of the list of pages

std::vector<ManualPart> manualParts();
/// The topics in the order of the index, which comes first.
QStringList manualTopics();
/// The topic of the page that explains a command; empty: there is none.
QString topicExplaining(const QString& command);
/// Empty if there is no page on the topic.
std::optional<ManualPage> manualPage(const QString& topic);

/// The topic of the page that a link names, such as "snapping.md"; empty for other links.
QString topicOfPage(const QString& link);

/// The page as a terminal shows it: links as "Snapping (snapping)", no pictures and no emphasis.
QString plainText(const ManualPage& page);

/// Markdown as people read it.
QString withoutComments(QString markdown);

/// The link to the page of an algorithm: "skala.md".
QString pageLink(const clipping::Algorithm& algorithm);
/// The page of an algorithm in resources/algorithms/KEY.md, in Markdown; without a page, the
/// description in the algorithm's row. A line {published code} or {corrected code} of the file is
/// replaced by the library's pseudo-code of that form.
QString pageOf(const clipping::Algorithm& algorithm);

/// The lines of a labelled pseudo-code (clipping/pseudo_code.h) as they are shown.
QStringList shownCode(std::string_view code);
/// The same of a form.
QStringList codeOf(const Variant& variant);

} // namespace app

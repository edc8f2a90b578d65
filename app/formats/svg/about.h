// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

#include <QXmlStreamReader>

#include <string>
#include <utility>
#include <vector>

namespace app::svg {

/// Gathers what a file says about itself while its tokens pass by: the <title>, <desc> and
/// <metadata> of the root, and the comments around it. A prefix is declared again where the file
/// writer's own root does not, so the text that is gathered from a written file is the same.
class AboutReader {
public:
    /// Every token in turn.
    void take(const QXmlStreamReader& xml);

    About about() const;
    /// There was more than `mostMetadata` bytes of it: none is kept.
    bool tooLarge() const { return tooLarge_; }
    /// Titles, descriptions and metadata of single elements and groups, which are not kept.
    int ofElements() const { return ofElements_; }

private:
    using Prefix = std::pair<QString, QString>; ///< and its namespace

    void open(const QXmlStreamReader& xml);
    void close(const QXmlStreamReader& xml);
    void openRoot(const QXmlStreamReader& xml);
    void begin();
    std::string* sectionOf(const QXmlStreamReader& xml);
    void write(const QXmlStreamReader& xml);
    void writeStart(const QXmlStreamReader& xml);
    void endStart();
    void declare(const QString& prefix, const QString& given);

    void noteElement(const QXmlStreamReader& xml);

    int depth_ = 0;     ///< elements that are open
    int noteDepth_ = 0; ///< of a title or the like of a single element; 0: none is open
    int ofElements_ = 0;
    int skipped_ = 0;           ///< of them, Clearcut's own and what is in them
    bool inStart_ = false;      ///< the last start tag still lacks its ">"
    bool saysAnything_ = false; ///< the title, description or metadata
    bool tooLarge_ = false;
    bool bare_ = false;     ///< the root has no namespace: what has none is SVG's
    std::size_t begin_ = 0; ///< of the title, description or metadata in its section
    QString id_;
    std::string comments_, title_, description_, metadata_;
    std::string* section_ = nullptr; ///< what is being gathered
    std::vector<Prefix> outer_;      ///< that the root of the file declares
    std::vector<Prefix> scope_;      ///< that are declared where the text goes on
    std::vector<std::size_t> marks_; ///< the scope's size outside of each written element
};

} // namespace app::svg

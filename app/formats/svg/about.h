// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/about.h"

#include <QXmlStreamReader>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app::svg {

/// A <title> or <desc> of an element below the root, as XML.
struct ElementNote {
    bool isTitle = false; ///< else a description
    QString text;
};

/// Gathers what a file says about itself while its tokens pass by: the <title>, <desc> and
/// <metadata> of the root, the comments around it, and the notes of elements. A prefix is declared
/// again where the file writer's own root does not, so the text that is gathered from a written
/// file is the same.
class AboutReader {
public:
    /// Every token in turn. Gives the note that ends with it.
    std::optional<ElementNote> take(const QXmlStreamReader& xml);

    About about() const;
    /// There was more than `mostMetadata` bytes of it: none is kept.
    bool tooLarge() const { return tooLarge_; }
    /// Titles, descriptions and metadata of elements below the root that say anything. Of these,
    /// `take` gives all but metadata and what is too large or nested too deeply.
    int ofElements() const { return ofElements_; }

private:
    using Prefix = std::pair<QString, QString>; ///< and its namespace

    void open(const QXmlStreamReader& xml);
    std::optional<ElementNote> close(const QXmlStreamReader& xml);
    std::optional<ElementNote> endSection();
    void openRoot(const QXmlStreamReader& xml);
    void begin(std::string* section);
    std::string* sectionOf(const QXmlStreamReader& xml);
    void write(const QXmlStreamReader& xml);
    void writeStart(const QXmlStreamReader& xml);
    void endStart();
    void declare(const QString& prefix, const QString& given);

    int depth_ = 0;        ///< elements that are open
    int sectionDepth_ = 0; ///< of the title or the like that is open; 2: one of the root
    int ofElements_ = 0;
    std::size_t noteBytes_ = 0; ///< of all notes that were given
    int skipped_ = 0;           ///< of them, Clearcut's own and what is in them
    bool inStart_ = false;      ///< the last start tag still lacks its ">"
    bool saysAnything_ = false; ///< the title, description or metadata
    bool tooLarge_ = false;
    bool dropped_ = false;  ///< the note is too large, or its markup too deep
    bool bare_ = false;     ///< the root has no namespace: what has none is SVG's
    std::size_t begin_ = 0; ///< of the title, description or metadata in its section
    QString id_;
    std::string comments_, title_, description_, metadata_;
    std::string note_;                  ///< of an element
    std::string* section_ = nullptr;    ///< what is being gathered: a note is gathered in note_
    const std::string* kind_ = nullptr; ///< title_, description_ or metadata_: which of them it is
    std::vector<Prefix> outer_;      ///< that the root of the file declares
    std::vector<Prefix> scope_;      ///< that are declared where the text goes on
    std::vector<std::size_t> marks_; ///< the scope's size outside of each written element
};

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/formats/svg/xml_reader.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app::svg {

/// A <title> or <desc>, as XML, of an element below the root.
struct ElementNote {
    bool isTitle = false; ///< otherwise a description
    QString text;
};

/// Collects what a file says about itself from its tokens: the <title>, <desc> and <metadata>
/// of the root, the comments around the root, and the titles and descriptions of elements. Prefixes
/// that the root element of written files does not declare are declared again, so that a written
/// file gives the same text when it is read.
class AboutReader {
public:
    /// Takes each token in order. Returns the note that ends with this token, if any.
    std::optional<ElementNote> take(const XmlToken& xml);

    About about() const;
    /// Whether the texts exceeded `mostMetadata` bytes; then none is kept.
    bool tooLarge() const { return tooLarge_; }
    /// How many non-empty titles, descriptions and metadata elements below the root were read so
    /// far. This includes those that `take` does not return: metadata, and notes that are too large
    /// or nested too deeply.
    int ofElements() const { return ofElements_; }

private:
    using Prefix = std::pair<std::string, std::string>; ///< a prefix and its namespace

    void open(const XmlToken& xml);
    std::optional<ElementNote> close(const XmlToken& xml);
    std::optional<ElementNote> endSection();
    void openRoot(const XmlToken& xml);
    void begin(std::string* section);
    std::string* sectionOf(const XmlToken& xml);
    void write(const XmlToken& xml);
    void writeStart(const XmlToken& xml);
    void endStart();
    void declare(std::string_view prefix, std::string_view given);

    int depth_ = 0;        ///< number of open elements
    int sectionDepth_ = 0; ///< depth of the open title or the like; 2: a child of the root
    int ofElements_ = 0;
    std::size_t noteBytes_ = 0; ///< total size of the notes returned
    int skipped_ = 0;           ///< open elements skipped: Clearcut's own and their content
    bool inStart_ = false;      ///< the last start tag still lacks its ">"
    bool saysAnything_ = false; ///< whether the open title, description or metadata has content
    bool tooLarge_ = false;
    bool dropped_ = false;  ///< whether the note is too large, or its markup too deep
    bool bare_ = false;     ///< the root has no namespace, so elements without one count as SVG
    std::size_t begin_ = 0; ///< where the open title, description or metadata begins in its section
    QString id_;
    std::string comments_, title_, description_, metadata_;
    std::string note_;                  ///< the note of an element
    std::string* section_ = nullptr;    ///< the text being collected: note_ for notes
    const std::string* kind_ = nullptr; ///< which kind it is: title_, description_ or metadata_
    std::vector<Prefix> outer_;         ///< declared by the root of the file
    std::vector<Prefix> scope_;         ///< declared at the current position of the text
    std::vector<std::size_t> marks_;    ///< size of scope_ outside each open element
};

} // namespace app::svg

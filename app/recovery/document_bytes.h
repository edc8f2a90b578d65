// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/recovery/object_bytes.h"

// Documents and edits as bytes that restore every bit: unlike SVG, also the placements of paths, so
// that later moves round in the same way, and the ids of containers.

namespace app {

void writeDocument(ByteWriter& out, const Document& document, ObjectBytes& objects);
std::optional<Document> readDocument(ByteReader& in, ObjectReader& objects);

void writeEdit(ByteWriter& out, const Edit& edit, ObjectBytes& objects);
/// The objects will use the style table of `styles`. Empty if the bytes are not valid; whether the
/// edit fits a document says `fits`.
std::optional<Edit> readEdit(ByteReader& in, ObjectReader& objects, const Objects& styles);

void writeSplices(ByteWriter& out, std::span<const Splice> splices);
std::vector<Splice> readSplices(ByteReader& in);
/// Parts of an edit that are not objects.
void writeSetting(ByteWriter& out, const Edit& edit, KnownImages& images);
void readSetting(ByteReader& in, Edit& edit, KnownImages& images);

/// Whether the edit can be applied to a document of so many objects.
bool fits(const Edit& edit, const Document& document);

} // namespace app

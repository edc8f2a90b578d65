// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"
#include "app/recovery/document_bytes.h"

namespace app {

/// Writes the change that `command` has just made; `now` is the document after it. A move is
/// written as its ranges and its vector, a restyling without paths: some bytes, however many
/// objects. Anything else is written with all added objects. What is removed is not written.
/// Returns the objects that were written; their lines are lent, and lie in them.
Objects writeChange(ByteWriter& out, const EditCommand& command, const Document& now);

/// A change that was read, for the document to which it is then applied.
struct Change {
    Edit edit;
    Derivation derivation;
};
/// Empty if the bytes are not valid or do not fit `document`, the state before the change. The
/// same numbers as when it was made, bit for bit.
std::optional<Change> readChange(ByteReader& in, const Document& document);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/undo_command.h"
#include "app/session/session.h"

namespace app {

/// More selected texts are not changed together: their letters are laid out at once.
constexpr std::size_t mostTextsAtOnce = 100;

/// The selected texts; empty if anything else is selected, too, or more of them.
std::vector<TextRecipe> selectedTexts(const Session& session);

/// What all texts have; empty: it differs.
template <class Member>
std::optional<Member> commonOf(std::span<const TextRecipe> texts, Member TextRecipe::*member)
{
    for (const TextRecipe& text : texts)
        if (!(text.*member == texts.front().*member))
            return std::nullopt;
    return texts.front().*member;
}

// Each changes the selected texts as one undo step, and nothing if nothing changes. Returns one
// sentence about what could not be done as wished, or nothing.

/// Writes them in this font; bold and italic where it has these letters.
std::optional<QString> setTextFont(Session& session, const QString& font);
/// Makes them bold or italic, or no longer, where their fonts have these letters.
std::optional<QString> setTextFace(Session& session, bool FontFace::*part, bool on);
/// Gives them this height of capital letters, in user units. Each stays where it begins, and keeps
/// its letters, also those of a font that is not installed.
std::optional<QString> setTextSize(Session& session, double size, Merging merging = Merging::Never);

} // namespace app

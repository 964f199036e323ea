#pragma once

namespace bosk {

// Numbers of keys as the window system's library gives them and Dear ImGui 1.86 keeps them;
// letters, digits and signs are their capital ASCII. window.cpp checks that they agree.
inline constexpr int kKeySpace = 32, kKeyMinus = '-', kKeyEqual = '=', kKeyLeftBracket = '[',
                     kKeyRightBracket = ']';
inline constexpr int kKeyEscape = 256, kKeyEnter = 257, kKeyTab = 258, kKeyBackspace = 259,
                     kKeyDelete = 261, kKeyRight = 262, kKeyLeft = 263, kKeyDown = 264,
                     kKeyUp = 265, kKeyPageUp = 266, kKeyPageDown = 267, kKeyHome = 268,
                     kKeyEnd = 269, kKeyF1 = 290;

}  // namespace bosk

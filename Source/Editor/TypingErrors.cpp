#include "Editor/TypingErrors.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace idiophone {

// The optimal string alignment distance (Damerau's with adjacent exchanges), its last row over all
// beginnings of the word.
int typingErrors(const Letters& typed, const Letters& word) {
    std::vector<int> beforeLast, last, row(word.size() + 1);
    for (std::size_t j = 0; j <= word.size(); ++j)
        row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= typed.size(); ++i) {
        beforeLast = std::exchange(last, row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= word.size(); ++j) {
            const bool isWrong = typed[i - 1] != word[j - 1];
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (isWrong ? 1 : 0)});
            if (i > 1 && j > 1 && typed[i - 1] == word[j - 2] && typed[i - 2] == word[j - 1])
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return *std::ranges::min_element(row);
}

int permittedErrors(int letters) {
    return letters < 4 ? 0 : letters < 8 ? 1 : 2;
}

} // namespace idiophone

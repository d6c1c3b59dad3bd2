// What a script may write in `pair_style gran` and `fix wall/gran`, for messages about what is
// misspelt: the host tells that it does not know a word or a model, not what it knows.
#pragma once

#include <string>
#include <vector>

namespace gasgrain {

// A word of a law of ours that the script has named.
void know_contact_word(const std::string& word);

// Those, the names of all our laws, and the words before them.
std::vector<std::string> contact_words();

// Of a line's words: which model is none, with the nearest name; '' where all are known.
std::string misspelt_model(const std::vector<std::string>& words);

}  // namespace gasgrain

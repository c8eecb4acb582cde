// SPDX-License-Identifier: MIT
// A command line, a word a line. It is understood or refused; nothing of it is run.
#include <vector>

#include "engine/core/error.h"
#include "game/app/commands.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> words{"secondlight"};
    for (std::string_view rest = sl::text_of(data, size); !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find('\n'));
        words.emplace_back(word.substr(0, word.find('\0')));
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    }
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    struct Understood {};
    sl::GlobalFlags flags;
    sl::Program program = sl::whole_program(flags);
    program.prepare = [] { throw Understood{}; };
    try {
        (void)program.run(static_cast<int>(words.size()), arguments.data());
    } catch (const Understood&) {
        // It would run now.
    }
    for (const std::string& word : words) {
        try {
            (void)sl::parse_size(word);
        } catch (const sl::Error&) {
            // Refused: that is an answer.
        }
    }
    return 0;
}

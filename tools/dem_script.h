// Reads a LIGGGHTS script as the host does, from its top to its bottom, without running it:
// continued lines, comments, quotes, `include`, variables (${name}, $x) and their formulas, `if`,
// and jumps forward to a label. A jump back, the end of a loop, is passed over: its lines are read
// once. What only a run knows (thermo keywords, computes, values of fixes) is an error where it is
// used.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gasgrain {

struct ScriptCommand {
  std::string file;
  int line = 0;                    // where it begins
  int last_line = 0;               // where it ends, when continued
  std::string text;                // as written, continued lines joined, without comment
  std::vector<std::string> words;  // variables put in, quotes removed

  // "file:line", for messages.
  [[nodiscard]] std::string place() const;
  // The word after the first one that is `key`, from word `from` on; empty when there is none.
  [[nodiscard]] std::string after(const std::string& key, std::size_t from = 0) const;
};

struct ScriptVariable {
  std::string style;  // index, equal, string
  std::string value;  // text of an index, formula of an equal
  std::string file;
  int line = 0;
};

class DemScript {
 public:
  // `given`: variables of the command line, which a script does not set again. Throws an Error that
  // names file, line and remedy.
  explicit DemScript(const std::filesystem::path& script,
                     const std::vector<std::pair<std::string, std::string>>& given = {});

  [[nodiscard]] const std::vector<ScriptCommand>& commands() const { return commands_; }
  [[nodiscard]] const std::map<std::string, ScriptVariable>& variables() const {
    return variables_;
  }
  // Text with its variables put in.
  [[nodiscard]] std::string substituted(const std::string& text) const;

 private:
  struct Line {
    int first = 0;
    int last = 0;
    std::string text;
  };
  static std::vector<Line> lines_of(const std::filesystem::path& script, const std::string& from);

  void read(const std::filesystem::path& script, const std::string& from, int depth);
  void run(const std::string& file, const Line& line, const std::filesystem::path& folder,
           std::string& label, int depth);
  void set_variable(const ScriptCommand& command);
  // The commands that an `if` chooses.
  [[nodiscard]] std::vector<std::string> chosen(const ScriptCommand& command) const;
  [[nodiscard]] std::string value(const std::string& name) const;
  [[nodiscard]] double formula(const std::string& text) const;

  std::vector<ScriptCommand> commands_;
  std::map<std::string, ScriptVariable> variables_;
  bool ended_ = false;  // by `quit`
};

// Words of a line: separated by blanks, quoted ones kept together and without their quotes.
std::vector<std::string> script_words(const std::string& text);

}  // namespace gasgrain

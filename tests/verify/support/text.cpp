#include <nipref/verify/support/text.hpp>

#include "support/on_terminal.hpp"

using namespace nipref::verify;

TEST_CASE("text is folded at spaces, below its last column or a little to the right") {
  const auto folded = [](const std::string& text) { return nipref::verify::folded(text, 80); };
  const std::string word(30, 'w');
  CHECK(folded("short\n\n  as it stands\n") == "short\n\n  as it stands\n");
  CHECK(folded("  " + word + " " + word + " " + word + "\nnext") ==
        "  " + word + " " + word + "\n      " + word + "\nnext");
  CHECK(folded("name     " + word + " " + word + " " + word) ==
        "name     " + word + " " + word + "\n         " + word);
  const std::string number(200, '7');
  CHECK(folded("value  " + number) == "value  " + number);
  CHECK(folded(std::string(80, 'w')) == std::string(80, 'w'));
  CHECK(folded("a " + number + " b") == "a " + number + "\n    b");
}

TEST_CASE("text is as wide as the terminal, and 80 columns wide elsewhere") {
  if (!has_terminals()) return;
  const int output = dup(STDOUT_FILENO), terminal = posix_openpt(O_RDWR | O_NOCTTY),
            nothing = open("/dev/null", O_WRONLY);
  const auto width_on = [&](int descriptor, unsigned short columns) {
    const winsize size{24, columns, 0, 0};
    ioctl(descriptor, TIOCSWINSZ, &size);
    dup2(descriptor, STDOUT_FILENO);
    const std::size_t width = text_width();
    dup2(output, STDOUT_FILENO);
    return width;
  };
  CHECK(width_on(terminal, 132) == 132);
  CHECK(width_on(terminal, 20) == 40);
  CHECK(width_on(nothing, 132) == 80);
  for (const int descriptor : {output, terminal, nothing}) close(descriptor);
}

TEST_CASE("colours take no columns, and can be taken away") {
  const std::string coloured = good("kept") + " and " + bad("BROKEN");
  CHECK(coloured != plain(coloured));
  CHECK(plain(coloured) == "kept and BROKEN");
  CHECK(width_of(coloured) == 15);
  CHECK(width_of("\u03bd = 1") == 5);
  const std::string wide = coloured + " " + std::string(60, 'w');
  CHECK(folded(wide, 80) == wide);
}

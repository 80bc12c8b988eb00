#include "view/input.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom::input_test {
namespace {

Event key_event(int value) {
  return {Event::Kind::key, value, {}};
}
Event mouse_event(Mouse mouse) {
  return {Event::Kind::mouse, 0, mouse};
}

std::vector<Event> taken(Input& input) {
  std::vector<Event> events;
  while (const auto event = input.next()) events.push_back(*event);
  return events;
}

std::vector<Event> read_all(const std::string& bytes) {
  Input input;
  input.feed(bytes);
  input.settle();
  return taken(input);
}

using Events = std::vector<Event>;

TEST(Input, ACharacterIsAKey) {
  EXPECT_EQ(read_all("aA "), (Events{key_event('a'), key_event('A'), key_event(' ')}));
  EXPECT_EQ(read_all("\r\n\t"),
            (Events{key_event(key::kEnter), key_event(key::kEnter), key_event(key::kTab)}));
  EXPECT_EQ(read_all("\x7F\b"), (Events{key_event(key::kBackspace), key_event(key::kBackspace)}));
}

TEST(Input, ArrowsAreKnownInBothForms) {
  for (const std::string begin : {"\x1B[", "\x1BO"}) {
    EXPECT_EQ(read_all(begin + "A"), Events{key_event(key::kUp)});
    EXPECT_EQ(read_all(begin + "B"), Events{key_event(key::kDown)});
    EXPECT_EQ(read_all(begin + "C"), Events{key_event(key::kRight)});
    EXPECT_EQ(read_all(begin + "D"), Events{key_event(key::kLeft)});
  }
}

TEST(Input, AnUnknownSequenceIsOneKeyThatMeansNothing) {
  for (const std::string sequence :
       {"\x1B[1;5A", "\x1BO5A", "\x1B[[A", "\x1B[15~", "\x1B[Z", "\x1BOP", "\x1Bx", "\x1B\xC3\xA9",
        "\x1B[27;5;97~", "\x1B[97;5u", "\xC3\xA9", "\xF0\x9F\x8E\xB1"}) {
    EXPECT_EQ(read_all(sequence + "q"), (Events{key_event(key::kOther), key_event('q')}))
        << sequence;
  }
}

TEST(Input, AnswersOfTheTerminalAreNoKeys) {
  for (const std::string answer : {"\x1B]11;rgb:00/00/00\a", "\x1B]11;rgb:AA/AA/AA\x1B\\",
                                   "\x1BP1$r0mA\x1B\\", "\x1B_Gxa\x1B\\", "\x1B[Mxax"}) {
    EXPECT_EQ(read_all(answer + "q"), Events{key_event('q')}) << answer;
  }
}

TEST(Input, EscapeAloneIsAKeyOnceNothingFollows) {
  Input input;
  input.feed("\x1B");
  EXPECT_EQ(taken(input), Events{});
  EXPECT_TRUE(input.waiting());
  input.settle();
  EXPECT_EQ(taken(input), Events{key_event(key::kEscape)});
  EXPECT_EQ(read_all("\x1B\x1B"), (Events{key_event(key::kEscape), key_event(key::kEscape)}));
}

TEST(Input, ASequenceMayComeInPieces) {
  const std::string bytes = "a\x1B[1;5A\x1B[<0;3;4M\x1B[200~axq\x1B[201~\xC3\xA9z";
  const Events whole = read_all(bytes);
  EXPECT_EQ(whole, (Events{key_event('a'),
                           key_event(key::kOther),
                           mouse_event({Mouse::Action::press, 0, 2, 3}),
                           {Event::Kind::pasted, 0, {}},
                           key_event(key::kOther),
                           key_event('z')}));
  Input input;
  for (const char byte : bytes) input.feed(std::string(1, byte));
  EXPECT_EQ(taken(input), whole);
}

TEST(Input, PastedTextIsOneEventHoweverLong) {
  EXPECT_EQ(read_all("\x1B[200~" + std::string(100000, 'A') + "\x1B[1;5A\x1B[201~q"),
            (Events{{Event::Kind::pasted, 0, {}}, key_event('q')}));
}

TEST(Input, TellsTheMouse) {
  EXPECT_EQ(read_all("\x1B[<0;10;5M"), Events{mouse_event({Mouse::Action::press, 0, 9, 4})});
  EXPECT_EQ(read_all("\x1B[<2;1;1m"), Events{mouse_event({Mouse::Action::release, 2, 0, 0})});
  EXPECT_EQ(read_all("\x1B[<32;300;99M"), Events{mouse_event({Mouse::Action::drag, 0, 299, 98})});
  EXPECT_EQ(read_all("\x1B[<64;2;3M"), Events{mouse_event({Mouse::Action::wheel_up, 0, 1, 2})});
  EXPECT_EQ(read_all("\x1B[<65;2;3M"), Events{mouse_event({Mouse::Action::wheel_down, 0, 1, 2})});
  // Moved with no button down, a report that is none.
  EXPECT_EQ(read_all("\x1B[<35;2;3M\x1B[<1;2M\x1B[<;;M"), Events{});
}

TEST(Input, TakesAnyBytesWithoutHarm) {
  std::uint64_t state = 1;
  for (int round = 0; round < 2000; ++round) {
    Input input;
    std::string bytes;
    for (int i = 0; i < 30; ++i) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      static constexpr char kCommon[] = "\x1B\x1B[[O<;0123M~Aq]P\\\a\x80\xC3\xF0";
      bytes += kCommon[(state >> 33U) % (sizeof kCommon - 1)];
    }
    input.feed(bytes);
    input.settle();
    input.settle();
    for (const Event& event : taken(input)) EXPECT_NE(event.kind, Event::Kind::none);
  }
}

}  // namespace
}  // namespace carom::input_test

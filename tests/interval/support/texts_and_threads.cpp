// Texts of others made fit to be shown; threads that throw; a line of progress.
#include <atomic>
#include <catch2/catch.hpp>
#include <graze/support/progress.hpp>
#include <graze/support/text.hpp>
#include <graze/support/threads.hpp>
#include <nlohmann/json.hpp>

using namespace graze::support;

TEST_CASE("support.text: UTF-8, or U+FFFD for each byte that is none", "[unit]") {
  const std::string good = "a\u00e9\u20ac\U0001f600";
  CHECK(utf8(good) == good);
  CHECK(utf8("a\xff"
             "b") == "a\uFFFDb");
  CHECK(utf8("\xc0\x80") == "\uFFFD\uFFFD");           // overlong
  CHECK(utf8("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD"); // a surrogate
  CHECK(utf8("\xf4\x90\x80\x80").size() == 12);        // beyond U+10FFFF
  CHECK(utf8("\xe2\x82") == "\uFFFD\uFFFD");           // cut off
}

TEST_CASE("support.text: one line, without controls, cut", "[unit]") {
  CHECK(shown("a\nb\tc\r\n") == "a b c  ");
  CHECK(shown("\x1b[31m\x7f\x01") == "?[31m??");
  CHECK(shown("\u202eabc\u2028\u0085\u009f") == "?abc  ?");
  CHECK(shown(std::string(500, 'x'), 20).size() <= 23);
  CHECK(shown("\u20ac\u20ac\u20ac\u20ac", 7) == "\u20ac\u20ac..."); // no half character
  CHECK(is_content_hash("0123456789abcdef0123456789abcdef"));
  CHECK_FALSE(is_content_hash("0123456789ABCDEF0123456789abcdef"));
  CHECK_FALSE(is_content_hash("../../../../../../../../../../x."));
  CHECK_FALSE(is_content_hash(""));
}

TEST_CASE("support.text: a JSON number is whole, and held by the integer, or is refused",
          "[unit]") {
  using json = nlohmann::json;
  const auto read = [](const char* text) { return json::parse(text); };
  CHECK(whole_number<std::uint64_t>(read("18446744073709551615")) == UINT64_MAX);
  CHECK(whole_number<int>(read("-2147483648")) == INT32_MIN);
  CHECK_FALSE(whole_number<int>(read("2147483648")));
  CHECK_FALSE(whole_number<std::uint64_t>(read("-1")));
  for (const char* const text :
       {"18446744073709551616", "1e300", "1.5", "1.0", "null", "\"1\"", "[1]", "true", "-1e300"}) {
    CAPTURE(text);
    CHECK_FALSE(whole_number<std::uint64_t>(read(text)));
    CHECK_FALSE(whole_number<int>(read(text)));
  }
}

TEST_CASE("support.threads: what a thread throws ends all and is thrown again", "[unit]") {
  std::atomic<bool> stop{false};
  std::atomic<int> first{0};
  thread_group group(
      4,
      [&] {
        if (first++ == 0)
          throw std::bad_alloc();
        while (!stop)
          std::this_thread::yield();
      },
      [&] { stop = true; });
  CHECK(group.size() == 4);
  CHECK_THROWS_AS(group.join(), std::bad_alloc);
  CHECK(group.wait_for(std::chrono::milliseconds(0)));
}

TEST_CASE("support.progress: how much, how fast, how long still", "[unit]") {
  CHECK(progress_text({50, 200, 1}, "pixels") == " 25 %  50 pixels/s  3.0 s left");
  CHECK(progress_text({2'000'000, 0, 2}, "rays") == "2 Mrays  1 Mrays/s");
  CHECK(progress_text({100, 0, 1, 4}, "rays") == "100 rays  100 rays/s  3.0 s left");
  CHECK(progress_text({300, 400, 11, 0, 200, 10}, "rays") == " 75 %  100 rays/s  1.0 s left");
  CHECK(progress_text({}, "rays") == "0 rays  0 rays/s");
}

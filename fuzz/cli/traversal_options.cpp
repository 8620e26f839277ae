#include <cli/traversal_options.hpp>
#include <cmath>
#include <external/libraries.hpp>
#include <fmt/format.h>
#include <graze/support/output.hpp>
#include <graze/support/text.hpp>
#include <report/reproducer/test_file.hpp>

namespace graze::fuzz {

void add_traversal_options(CLI::App& app, CLI::Option& other, traversal_options& options) {
  CLI::Option* command =
      app.add_option("--command", options.external.command,
                     "Under test is this program, driven over stdin and stdout (docs/adapters.md)")
          ->excludes(&other);
  app.add_option("--promise", options.promised, "What it promises: " + promise_names())
      ->needs(command);
  app.add_option("--timeout", options.external.seconds_a_ray,
                 "Seconds of silence after which a ray counts as a hang, if the traversal is in "
                 "another process")
      ->capture_default_str();
  CLI::Option* plain = app.add_flag("--plain", options.plain,
                                    "Send plain numbers in hex, for scanf, instead of JSON")
                           ->needs(command);
  app.add_flag("--bits", options.bits,
               "The same, each double as the 16 hex digits of its bits, which any language reads")
      ->needs(command)
      ->excludes(plain);
  app.add_option("--batch", options.external.batch, "Send so many requests in one message")
      ->check(CLI::Range(1, 1'000'000))
      ->needs(command);
  app.add_flag("--received", options.external.needs_received,
               "An answer without the ray that the traversal worked on is malformed")
      ->needs(command);
  app.add_option(
         "--tolerance", options.external.tolerance,
         "Ulps by which the entry into the first cell may be off (16, with --float those of "
         "float)")
      ->needs(command);
  app.add_flag("--float", options.external.as_float,
               "Round rays and boxes to float before they are sent, and judge them so")
      ->needs(command);
}

void add_language_option(CLI::App& app, std::string& language) {
  app.add_option("--language", language,
                 "Of a reproducer's test: rust, go, java, javascript, python, c++ (default: what "
                 "the words of "
                 "--command look like, or c++)")
      ->check(CLI::IsMember({"rust", "go", "java", "javascript", "python", "c++"}));
}

reader_of_test reader_of(const std::string& language, const traversal_options& options,
                         const traversal_entry& chosen) {
  reader_of_test reader;
  reader.written = language_of(language).value_or(language_of_command(options.external.command));
  if (chosen.external)
    reader.external = *chosen.external;
  return reader;
}

void tell_of_test(const written_reproducer& written) {
  if (written.test.empty())
    support::complain(fmt::format("{}: no test is written of a ray in a map: use graze-fuzz replay "
                                  "{}.json",
                                  support::shown(written.path), support::shown(written.path)));
}

expected<external_options> external_of(const traversal_options& options) {
  external_options external = options.external;
  if (!std::isfinite(external.seconds_a_ray) || external.seconds_a_ray <= 0 ||
      external.seconds_a_ray > 1e6)
    return unexpected{"--timeout is not a number of seconds above 0, to 1e6"};
  if (!options.promised.empty()) {
    external.promised = promise_of(options.promised);
    if (!external.promised)
      return unexpected{
          fmt::format("promise \"{}\" is none of {}", options.promised, promise_names())};
  }
  if (external.tolerance && !(*external.tolerance >= 0 && std::isfinite(*external.tolerance)))
    return unexpected{"--tolerance is not a number of ulps, 0 or more"};
  external.format =
      options.plain ? line_format::plain : (options.bits ? line_format::bits : line_format::json);
  return external;
}

expected<traversal_entry> tried_traversal(const external_options& options) {
  auto entry = external_traversal(options);
  if (entry)
    for (const std::string& notice : entry->notices)
      support::complain(notice);
  return entry;
}

expected<traversal_entry> chosen_traversal(const std::string& name,
                                           const traversal_options& options, bool show_errors) {
  auto external = external_of(options);
  if (!external)
    return unexpected{external.reason()};
  external->show_errors = show_errors;
  return external->command.empty() ? named_traversal(name, *external) : tried_traversal(*external);
}

} // namespace graze::fuzz

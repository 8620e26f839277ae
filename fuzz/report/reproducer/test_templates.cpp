#include <array>
#include <report/reproducer/test_templates.hpp>

// An answer is read in each of its forms by the same steps in each language: the words of a line are those of
// its members, of a JSON object or of a plain line, whose cells have no name. "#" marks a double's bits.

namespace graze::fuzz {

namespace {

constexpr std::string_view rust = R"TEMPLATE(@TITLE@#![allow(dead_code, non_snake_case)]
use std::collections::HashMap;
use std::io::{Read, Write};
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;

type Cell = [u64; @AXES@]; // @WHAT@
// The bits of the doubles.
@SCENE@const CELL: Cell = @CELL@;
const OCCUPIED: &[Cell] = &[@OCCUPIED@];
// What a right answer holds.
const MUST: &[Cell] = &[@MUST@];
const ONE_OF: &[Cell] = &[@ONE_OF@];
const NONE_OF: &[Cell] = &[@NONE_OF@];
const IN_ORDER: &[Cell] = &[@IN_ORDER@];
const COUNTS: Cell = [@COUNTS@];
const ONCE: bool = @ONCE@;
const INSIDE: bool = @INSIDE@;
const FIRST: bool = @FIRST@; // one of ONE_OF, or, if NOTHING, no cell
const NOTHING: bool = @NOTHING@;
const SAID: &str = "@SAID@";
// Of each of ONE_OF: from, to; and the faces by which the ray may come in.
const T: &[u64] = &[@T@];
const DISTANCE: &[u64] = &[@DISTANCE@];
const FACES: &[&str] = &[@FACES@];
// How the adapter is asked, and what it answers.
const BITS: bool = @BITS@;
const NEEDS_RECEIVED: bool = @NEEDS_RECEIVED@;
const KNOWN: &[&str] = &[@KNOWN@];
const COMMAND: &str = "@COMMAND@";
const REQUEST: &str = "@REQUEST@";

#[derive(Default, Debug)]
struct Answer {
    cells: Vec<Cell>, // in the traversal's order
    t: Option<f64>,
    distance: Option<f64>,
    face: Option<String>, // "-x", "none"
    said: String,         // "true", "false", or a count
}

/// What the traversal says: put your own call here. As it stands, it asks the adapter.
fn visited() -> Answer {
    assert!(!COMMAND.is_empty(), "put your traversal into visited()");
    read(&answer())
}

/// The adapter's line, without what it says first of all.
fn answer() -> String {
    let mut child = Command::new("sh")
        .args(["-c", COMMAND])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .process_group(0)
        .spawn()
        .expect("sh");
    let _ = child.stdin.take().unwrap().write_all(REQUEST.as_bytes());
    let mut out = child.stdout.take().unwrap();
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        let _ = out.read_to_end(&mut bytes);
        let _ = sender.send(String::from_utf8_lossy(&bytes).into_owned());
    });
    let text = receiver.recv_timeout(Duration::from_secs(@SECONDS@));
    let group = format!("-{}", child.id());
    let _ = Command::new("kill").args(["-9", "--", &group]).stderr(Stdio::null()).status();
    let _ = child.wait();
    let text = text.expect("no answer within @SECONDS@ s");
    let greeting = ["promise", "cells", "segments", "batch", "numbers", "tolerance", "float", "echo true"];
    let lines: Vec<_> = text.lines().skip_while(|l| greeting.iter().any(|g| l.contains(g))).collect();
    assert!(!lines.is_empty(), "the program ended before it answered");
    assert!(lines.len() == 1, "there is another line behind the answer");
    lines[0].to_string()
}

fn members(line: &str) -> HashMap<String, Vec<String>> {
    let line = match line.find("\"answers\"") {
        Some(at) => line[at..].split_once('[').expect("no answer").1,
        None => line,
    };
    let mut all = HashMap::from([(String::new(), Vec::new())]);
    let (mut key, mut word, mut depth, mut quoted) = (String::new(), String::new(), 0, false);
    for c in line.chars().chain(" ".chars()) {
        if !" \t\r[]{},:\"".contains(c) {
            word.push(c);
            continue;
        }
        if !word.is_empty() {
            if depth == 0 && ["t", "distance", "face", "received", "id", "echo"].contains(&word.as_str()) {
                key = word.clone();
                all.insert(key.clone(), Vec::new());
            } else {
                let mark = if quoted && is_bits(&word) { "#" } else { "" };
                all.get_mut(&key).unwrap().push(mark.to_string() + &word);
            }
            word.clear();
        }
        if c == ':' && depth == 1 {
            key = all.get_mut(&key).unwrap().pop().expect("no answer");
            all.insert(key.clone(), Vec::new());
        }
        quoted ^= c == '"';
        depth += (c == '[' || c == '{') as i32 - (c == ']' || c == '}') as i32;
    }
    all
}

fn is_bits(word: &str) -> bool {
    word.len() == 16 && word.chars().all(|c| c.is_ascii_hexdigit())
}

fn number(word: &str) -> f64 {
    let text = word.trim_start_matches('#');
    if text.len() < word.len() || (BITS && is_bits(word)) {
        return f64::from_bits(u64::from_str_radix(text, 16).unwrap());
    }
    let text = text.to_lowercase();
    let Some((sign, hex)) = text.split_once("0x") else {
        return text.parse().expect("no answer: no number");
    };
    let (digits, power) = hex.split_once('p').unwrap_or((hex, "0"));
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let digits = u64::from_str_radix(&format!("{}{}", whole, part), 16).expect("no answer: no number") as f64;
    let mut power: i32 = power.parse::<i32>().expect("no answer: no number") - 4 * part.len() as i32;
    let mut x = if sign == "-" { -digits } else { digits };
    while power != 0 {
        let step = power.clamp(-1000, 1000); // 2^-1074 is no power of powi's
        x *= 2f64.powi(step);
        power -= step;
    }
    x
}

fn read(line: &str) -> Answer {
    let members = members(line);
    for key in members.keys() {
        assert!(KNOWN.contains(&key.as_str()), "no answer: {}", line);
    }
    let of = |key: &str| members.get(key).cloned().unwrap_or_default();
    let words: Vec<String> = ["", "visited", "first", "hit", "count"].iter().flat_map(|k| of(k))
        .filter(|w| w != "null" && w != "none").collect();
    assert!(!words.contains(&"skip".into()) && !of("skip").contains(&"true".into()), "the adapter declines this ray");
    assert!(of("id").iter().all(|w| w == "0"), "no answer: its id is not 0: {}", line);
    assert!(!NEEDS_RECEIVED || !of("received").is_empty(), "there is no \"received\": {}", line);
    let one = |key: &str| of(key).first().map(|w| number(w));
    let mut answer = Answer { t: one("t"), distance: one("distance"), ..Answer::default() };
    answer.face = of("face").first().map(|w| if w == "null" { "none".into() } else { w.clone() });
    if !SAID.is_empty() {
        answer.said = words.first().expect("no answer").clone();
        return answer;
    }
    assert!(words.len() % @AXES@ == 0, "no answer: {}", line);
    for cell in words.chunks(@AXES@) {
        let place: Vec<i64> = cell.iter().map(|w| w.parse::<f64>().expect("no answer") as i64).collect();
        answer.cells.push(std::array::from_fn(|a| place[a] as u64));
    }
    answer
}

#[test]
fn @NAME@() {
    let answer = visited();
    let visited = &answer.cells;
    for (i, cell) in visited.iter().enumerate() {
        assert!(!ONCE || !visited[..i].contains(cell), "{:?} is told twice: {:?}", cell, visited);
        assert!(!INSIDE || (0..@AXES@).all(|a| cell[a] < COUNTS[a]), "{:?} is not in the grid", cell);
    }
    for cell in MUST {
        assert!(visited.contains(cell), "{:?} is not visited: {:?}", cell, visited);
    }
    for cell in NONE_OF {
        assert!(!visited.contains(cell), "{:?} is visited: {:?}", cell, visited);
    }
    let places: Vec<_> = visited.iter().filter_map(|v| IN_ORDER.iter().position(|o| o == v)).collect();
    let ordered = places.windows(2).all(|p| p[0] < p[1]);
    assert!(ordered, "not in the order {:?}: {:?}", IN_ORDER, visited);
    if !FIRST && !ONE_OF.is_empty() {
        let any = visited.iter().any(|v| ONE_OF.contains(v));
        assert!(any, "none of {:?} is visited: {:?}", ONE_OF, visited);
    }
    for x in [answer.t, answer.distance].iter().flatten() {
        assert!(!x.is_nan(), "a NaN");
    }
    if SAID == "odd" || SAID == "even" {
        let n: f64 = answer.said.parse().expect("no count");
        assert!((n % 2.0 == 1.0) == (SAID == "odd"), "{} is not {}", n, SAID);
    } else {
        let said = match answer.said.as_str() {
            "1" if SAID == "true" || SAID == "false" => "true",
            "0" if SAID == "true" || SAID == "false" => "false",
            said => said,
        };
        assert!(said == SAID, "{} is not {}", said, SAID);
    }
    if !FIRST {
        return;
    }
    assert!(visited.len() <= 1, "more than one first cell: {:?}", visited);
    let Some(cell) = visited.iter().find(|v| OCCUPIED.contains(v)) else {
        assert!(NOTHING, "none of {:?} is the first: {:?}", ONE_OF, visited);
        return;
    };
    let place = ONE_OF.iter().position(|o| o == cell);
    let place = place.unwrap_or_else(|| panic!("{:?} is none of {:?}", cell, ONE_OF));
    let right = |x: Option<f64>, range: &[u64]| {
        let (from, to) = (f64::from_bits(range[2 * place]), f64::from_bits(range[2 * place + 1]));
        let within = x.map_or(true, |x| from <= x && x <= to);
        assert!(within, "{:?} is not from {:?} to {:?}", answer, from, to);
    };
    if !T.is_empty() {
        assert!(answer.t.or(answer.distance).is_some(), "neither t nor distance is told");
        right(answer.t, T);
        right(answer.distance, DISTANCE);
    }
    if !FACES.is_empty() {
        let face = answer.face.as_deref().expect("no face is told");
        assert!(FACES[place].split(' ').any(|f| f == face), "the face {} is none of {}", face, FACES[place]);
    }
}
)TEMPLATE";

constexpr std::string_view go = R"TEMPLATE(@TITLE@package graze_test

import (
	"bytes"
	"math"
	"os/exec"
	"regexp"
	"strconv"
	"strings"
	"syscall"
	"testing"
	"time"
)

type cell_@NAME@ = [@AXES@]int64 // @WHAT@

type answer_@NAME@ struct {
	cells       []cell_@NAME@ // in the traversal's order
	t, distance *float64
	face        string // "-x", "none"; "" where none is told
	said        string // "true", "false", or a count
}

func doubles_@NAME@(bits ...uint64) (all []float64) {
	for _, b := range bits {
		all = append(all, math.Float64frombits(b))
	}
	return all
}

// visited_@NAME@ gives what the traversal says: put your own call here. As it stands, it asks the adapter.
func visited_@NAME@(t *testing.T) answer_@NAME@ {
	type cell = cell_@NAME@
	doubles := doubles_@NAME@
@SCENE@	subject := cell@CELL@
	occupied := []cell{@OCCUPIED@}
	_, _, _ = subject, occupied, doubles

	command := "@COMMAND@"
	request := "@REQUEST@"
	if command == "" {
		t.Fatal("put your traversal into visited")
	}
	process := exec.Command("sh", "-c", command)
	process.Stdin = strings.NewReader(request)
	process.SysProcAttr = &syscall.SysProcAttr{Setpgid: true}
	process.WaitDelay = time.Second
	var out bytes.Buffer
	process.Stdout = &out
	if err := process.Start(); err != nil {
		t.Fatal(err)
	}
	late := time.AfterFunc(@SECONDS@*time.Second, func() { syscall.Kill(-process.Process.Pid, syscall.SIGKILL) })
	process.Wait()
	if !late.Stop() {
		t.Fatal("no answer within @SECONDS@ s")
	}
	lines := strings.Split(out.String(), "\n")
	lines = lines[:len(lines)-1] // what follows the last end of a line
	greeting := regexp.MustCompile("promise|cells|segments|batch|numbers|tolerance|float|echo true")
	for len(lines) > 0 && greeting.MatchString(lines[0]) {
		lines = lines[1:] // what an adapter says first of all
	}
	if len(lines) == 0 {
		t.Fatal("the program ended before it answered")
	}
	if len(lines) > 1 {
		t.Fatal("there is another line behind the answer")
	}
	return read_@NAME@(t, lines[0])
}

func read_@NAME@(t *testing.T, line string) (answer answer_@NAME@) {
	wrong := func() { t.Fatal("no answer: ", line) }
	members := map[string][]string{"": nil}
	isBits := regexp.MustCompile("^#?[0-9a-fA-F]{16}$").MatchString
	text := line
	if at := strings.Index(line, `"answers"`); at >= 0 {
		text = line[at+strings.Index(line[at:], "[")+1:]
	}
	key, word, depth, quoted := "", "", 0, false
	for _, c := range text + " " {
		if !strings.ContainsRune(" \t\r[]{},:\"", c) {
			word += string(c)
			continue
		}
		if word != "" {
			name := regexp.MustCompile("^(t|distance|face|received|id|echo)$").MatchString(word)
			if depth == 0 && name {
				key = word
				members[key] = nil
			} else if quoted && isBits(word) {
				members[key] = append(members[key], "#"+word)
			} else {
				members[key] = append(members[key], word)
			}
			word = ""
		}
		if c == ':' && depth == 1 {
			of := members[key]
			if len(of) == 0 {
				wrong()
			}
			members[key] = of[:len(of)-1]
			key = of[len(of)-1]
			members[key] = nil
		}
		if c == '"' {
			quoted = !quoted
		}
		depth += strings.Count("[{", string(c)) - strings.Count("]}", string(c))
	}
	for key := range members {
		known := false
		for _, k := range []string{@KNOWN@} {
			known = known || k == key
		}
		if !known {
			wrong()
		}
	}
	var words []string
	for _, key := range []string{"", "visited", "first", "hit", "count"} {
		for _, word := range members[key] {
			if word == "skip" {
				t.Fatal("the adapter declines this ray")
			}
			if word != "null" && word != "none" {
				words = append(words, word)
			}
		}
	}
	if of := members["skip"]; len(of) > 0 && of[0] == "true" {
		t.Fatal("the adapter declines this ray")
	}
	if of := members["id"]; len(of) > 0 && of[0] != "0" {
		wrong()
	}
	if @NEEDS_RECEIVED@ && len(members["received"]) == 0 {
		t.Fatal("there is no \"received\": ", line)
	}
	number := func(word string) float64 {
		if word[0] == '#' || (@BITS@ && isBits(word)) {
			bits, _ := strconv.ParseUint(strings.TrimPrefix(word, "#"), 16, 64)
			return math.Float64frombits(bits)
		}
		x, err := strconv.ParseFloat(word, 64)
		if err != nil && !math.IsInf(x, 0) {
			wrong()
		}
		return x
	}
	one := func(key string) *float64 {
		if len(members[key]) == 0 {
			return nil
		}
		x := number(members[key][0])
		return &x
	}
	answer.t, answer.distance = one("t"), one("distance")
	if of := members["face"]; len(of) > 0 {
		answer.face = strings.Replace(of[0], "null", "none", 1)
	}
	if "@SAID@" != "" {
		if len(words) == 0 {
			wrong()
		}
		answer.said = words[0]
		return answer
	}
	if len(words)%@AXES@ != 0 {
		wrong()
	}
	for i := 0; i < len(words); i += @AXES@ {
		var cell cell_@NAME@
		for a := range cell {
			x, err := strconv.ParseFloat(words[i+a], 64)
			if err != nil {
				wrong()
			}
			cell[a] = int64(x)
		}
		answer.cells = append(answer.cells, cell)
	}
	return answer
}

func Test_@NAME@(t *testing.T) {
	type cell = cell_@NAME@
	answer := visited_@NAME@(t)
	visited := answer.cells
	place := func(list []cell, one cell) int {
		for i, v := range list {
			if v == one {
				return i
			}
		}
		return -1
	}
	for _, one := range []cell{@MUST@} {
		if place(visited, one) < 0 {
			t.Error(one, "is not visited:", visited)
		}
	}
	oneOf, any := []cell{@ONE_OF@}, false
	for _, one := range oneOf {
		any = any || place(visited, one) >= 0
	}
	if !@FIRST@ && len(oneOf) > 0 && !any {
		t.Error("none of", oneOf, "is visited:", visited)
	}
	for _, one := range []cell{@NONE_OF@} {
		if place(visited, one) >= 0 {
			t.Error(one, "is visited:", visited)
		}
	}
	inOrder, last := []cell{@IN_ORDER@}, -1
	for i, one := range visited {
		if at := place(inOrder, one); at >= 0 {
			if at <= last {
				t.Error("not in the order", inOrder, ":", visited)
			}
			last = at
		}
		if @ONCE@ && place(visited, one) < i {
			t.Error(one, "is told twice:", visited)
		}
		for a, count := range []int64{@COUNTS@} {
			if @INSIDE@ && (one[a] < 0 || one[a] >= count) {
				t.Error(one, "is not in the grid")
			}
		}
	}
	for _, x := range []*float64{answer.t, answer.distance} {
		if x != nil && math.IsNaN(*x) {
			t.Error("a NaN")
		}
	}
	said := answer.said
	if s := "@SAID@"; s == "odd" || s == "even" {
		n, _ := strconv.ParseUint(said, 10, 64)
		said = []string{"even", "odd"}[n%2]
	} else if s == "true" || s == "false" {
		said = strings.NewReplacer("1", "true", "0", "false").Replace(said)
	}
	if said != "@SAID@" {
		t.Error(answer.said, "is not @SAID@")
	}
	if !@FIRST@ {
		return
	}
	if len(visited) > 1 {
		t.Fatal("more than one first cell: ", visited)
	}
	if len(visited) == 0 || place([]cell{@OCCUPIED@}, visited[0]) < 0 {
		if !@NOTHING@ {
			t.Error("none of", oneOf, "is the first:", visited)
		}
		return
	}
	at := place(oneOf, visited[0])
	if at < 0 {
		t.Fatal(visited[0], "is none of", oneOf)
	}
	right := func(x *float64, ranges []float64) {
		if x != nil && !(ranges[2*at] <= *x && *x <= ranges[2*at+1]) {
			t.Error(*x, "is not from", ranges[2*at], "to", ranges[2*at+1])
		}
	}
	if ranges := doubles_@NAME@(@T@); len(ranges) > 0 {
		if answer.t == nil && answer.distance == nil {
			t.Error("neither t nor distance is told")
		}
		right(answer.t, ranges)
		right(answer.distance, doubles_@NAME@(@DISTANCE@))
	}
	if faces := []string{@FACES@}; len(faces) > 0 {
		if answer.face == "" || !strings.Contains(" "+faces[at]+" ", " "+answer.face+" ") {
			t.Errorf("the face %q is none of %s", answer.face, faces[at])
		}
	}
}
)TEMPLATE";

constexpr std::string_view java = R"TEMPLATE(@TITLE@import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

class Graze_@NAME@ {
  // The bits of the doubles. Cells: @WHAT@.
@SCENE@  static final long[] CELL = @CELL@;
  static final long[][] OCCUPIED = {@OCCUPIED@};
  // What a right answer holds.
  static final long[][] MUST = {@MUST@};
  static final long[][] ONE_OF = {@ONE_OF@};
  static final long[][] NONE_OF = {@NONE_OF@};
  static final long[][] IN_ORDER = {@IN_ORDER@};
  static final long[] COUNTS = {@COUNTS@};
  static final boolean ONCE = @ONCE@, INSIDE = @INSIDE@;
  static final boolean FIRST = @FIRST@; // one of ONE_OF, or, if NOTHING, no cell
  static final boolean NOTHING = @NOTHING@;
  static final String SAID = "@SAID@";
  // Of each of ONE_OF: from, to; and the faces by which the ray may come in.
  static final long[] T = {@T@};
  static final long[] DISTANCE = {@DISTANCE@};
  static final String[] FACES = {@FACES@};
  // How the adapter is asked, and what it answers.
  static final boolean BITS = @BITS@, NEEDS_RECEIVED = @NEEDS_RECEIVED@;
  static final List<String> KNOWN = List.of(@KNOWN@);
  static final String COMMAND = "@COMMAND@";
  static final String REQUEST = "@REQUEST@";

  static class Answer {
    List<long[]> cells = new ArrayList<>(); // in the traversal's order
    Double t, distance;
    String face; // "-x", "none"
    String said = ""; // "true", "false", or a count
  }

  static double[] doubles(long[] bits) {
    return Arrays.stream(bits).mapToDouble(Double::longBitsToDouble).toArray();
  }

  /** What the traversal says: put your own call here. As it stands, it asks the adapter. */
  static Answer visited() throws Exception {
    check(!COMMAND.isEmpty(), "put your traversal into visited()");
    return read(answer());
  }

  /** The adapter's line, without what it says first of all. */
  static String answer() throws Exception {
    File out = File.createTempFile("graze", null), in = File.createTempFile("graze", null);
    try {
      Files.writeString(in.toPath(), REQUEST);
      Process process =
          new ProcessBuilder("sh", "-c", COMMAND).redirectInput(in).redirectOutput(out)
              .redirectError(ProcessBuilder.Redirect.INHERIT).start();
      boolean ended = process.waitFor(@SECONDS@, TimeUnit.SECONDS);
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
      check(ended, "no answer within @SECONDS@ s");
      List<String> lines = new ArrayList<>(Files.readAllLines(out.toPath(), StandardCharsets.ISO_8859_1));
      String greeting = ".*(promise|cells|segments|batch|numbers|tolerance|float|echo true).*";
      while (!lines.isEmpty() && lines.get(0).matches(greeting)) lines.remove(0);
      check(!lines.isEmpty(), "the program ended before it answered");
      check(lines.size() == 1, "there is another line behind the answer");
      return lines.get(0);
    } finally {
      out.delete();
      in.delete();
    }
  }

  static Map<String, List<String>> members(String line) {
    int answers = line.indexOf("\"answers\"");
    if (answers >= 0) line = line.substring(line.indexOf('[', answers) + 1);
    Map<String, List<String>> all = new HashMap<>();
    String key = "", word = "";
    all.put(key, new ArrayList<>());
    int depth = 0;
    boolean quoted = false;
    for (char c : (line + " ").toCharArray()) {
      if (" \t\r[]{},:\"".indexOf(c) < 0) {
        word += c;
        continue;
      }
      if (!word.isEmpty()) {
        if (depth == 0 && word.matches("t|distance|face|received|id|echo")) {
          key = word;
          all.put(key, new ArrayList<>());
        } else {
          all.get(key).add((quoted && isBits(word) ? "#" : "") + word);
        }
        word = "";
      }
      if (c == ':' && depth == 1) {
        List<String> of = all.get(key);
        check(!of.isEmpty(), "no answer: " + line);
        key = of.remove(of.size() - 1);
        all.put(key, new ArrayList<>());
      }
      quoted ^= c == '"';
      depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }
    return all;
  }

  static boolean isBits(String word) {
    return word.matches("[0-9a-fA-F]{16}");
  }

  static Double number(List<String> words) {
    if (words == null || words.isEmpty()) return null;
    String word = words.get(0);
    if (word.startsWith("#") || (BITS && isBits(word)))
      return Double.longBitsToDouble(Long.parseUnsignedLong(word.replace("#", ""), 16));
    if (word.matches("[+-]?inf(inity)?")) return word.startsWith("-") ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    return Double.parseDouble(word.contains("0x") && !word.contains("p") ? word + "p0" : word);
  }

  static Answer read(String line) {
    Map<String, List<String>> members = members(line);
    for (String key : members.keySet()) check(KNOWN.contains(key), "no answer: " + line);
    List<String> none = List.of(), words = new ArrayList<>();
    for (String key : List.of("", "visited", "first", "hit", "count")) words.addAll(members.getOrDefault(key, none));
    words.removeIf(w -> w.equals("null") || w.equals("none"));
    check(!words.contains("skip") && !members.getOrDefault("skip", none).contains("true"),
        "the adapter declines this ray");
    check(members.getOrDefault("id", List.of("0")).equals(List.of("0")), "its id is not 0: " + line);
    check(!NEEDS_RECEIVED || !members.getOrDefault("received", none).isEmpty(), "there is no \"received\": " + line);
    Answer answer = new Answer();
    answer.t = number(members.get("t"));
    answer.distance = number(members.get("distance"));
    List<String> face = members.getOrDefault("face", none);
    if (!face.isEmpty()) answer.face = face.get(0).replace("null", "none");
    if (!SAID.isEmpty()) {
      check(!words.isEmpty(), "no answer: " + line);
      answer.said = words.get(0);
      return answer;
    }
    check(words.size() % @AXES@ == 0, "no answer: " + line);
    for (int i = 0; i < words.size(); i += @AXES@)
      answer.cells.add(words.subList(i, i + @AXES@).stream().mapToLong(w -> (long) Double.parseDouble(w)).toArray());
    return answer;
  }

  static int place(List<long[]> list, long[] cell) {
    for (int i = 0; i < list.size(); ++i)
      if (Arrays.equals(list.get(i), cell)) return i;
    return -1;
  }

  static void check(boolean good, String message) {
    if (!good) throw new AssertionError(message);
  }

  static void test() throws Exception {
    Answer answer = visited();
    List<long[]> visited = answer.cells;
    String all = Arrays.deepToString(visited.toArray()), oneOf = Arrays.deepToString(ONE_OF);
    for (long[] cell : MUST)
      check(place(visited, cell) >= 0, Arrays.toString(cell) + " is not visited: " + all);
    check(FIRST || ONE_OF.length == 0 || Arrays.stream(ONE_OF).anyMatch(v -> place(visited, v) >= 0),
        "none of " + oneOf + " is visited: " + all);
    for (long[] cell : NONE_OF)
      check(place(visited, cell) < 0, Arrays.toString(cell) + " is visited: " + all);
    int last = -1;
    for (int i = 0; i < visited.size(); ++i) {
      long[] cell = visited.get(i);
      int at = place(Arrays.asList(IN_ORDER), cell);
      check(at < 0 || at > last, "not in the order " + Arrays.deepToString(IN_ORDER) + ": " + all);
      last = Math.max(at, last);
      check(!ONCE || place(visited, cell) == i, Arrays.toString(cell) + " is told twice: " + all);
      for (int a = 0; a < @AXES@; ++a)
        check(!INSIDE || (0 <= cell[a] && cell[a] < COUNTS[a]), Arrays.toString(cell) + " is not in the grid");
    }
    for (Double x : new Double[] {answer.t, answer.distance}) check(x == null || !x.isNaN(), "a NaN");
    String said = answer.said;
    if (SAID.equals("odd") || SAID.equals("even")) said = Long.parseLong(said) % 2 != 0 ? "odd" : "even";
    if (SAID.equals("true") || SAID.equals("false")) said = said.replace("1", "true").replace("0", "false");
    check(said.equals(SAID), answer.said + " is not " + SAID);
    if (!FIRST) return;
    check(visited.size() <= 1, "more than one first cell: " + all);
    if (visited.isEmpty() || place(Arrays.asList(OCCUPIED), visited.get(0)) < 0) {
      check(NOTHING, "none of " + oneOf + " is the first: " + all);
      return;
    }
    int place = place(Arrays.asList(ONE_OF), visited.get(0));
    check(place >= 0, all + " is none of " + oneOf);
    if (T.length > 0) {
      check(answer.t != null || answer.distance != null, "neither t nor distance is told");
      right(answer.t, doubles(T), place);
      right(answer.distance, doubles(DISTANCE), place);
    }
    if (FACES.length > 0)
      check(answer.face != null && Arrays.asList(FACES[place].split(" ")).contains(answer.face),
          "the face " + answer.face + " is none of " + FACES[place]);
  }

  static void right(Double x, double[] range, int place) {
    check(x == null || (range[2 * place] <= x && x <= range[2 * place + 1]),
        x + " is not from " + range[2 * place] + " to " + range[2 * place + 1]);
  }

  public static void main(String[] arguments) throws Exception {
    test();
    System.out.println("passed");
  }
}
)TEMPLATE";

constexpr std::string_view javascript = R"TEMPLATE(@TITLE@import assert from "node:assert";
import { spawn } from "node:child_process";
import test from "node:test";

// The bits of the doubles. Cells: @WHAT@.
const doubles = (...bits) => [...new Float64Array(new BigUint64Array(bits).buffer)];
@SCENE@const cell = @CELL@;
const occupied = [@OCCUPIED@];
// What a right answer holds.
const must = [@MUST@];
const oneOf = [@ONE_OF@];
const noneOf = [@NONE_OF@];
const inOrder = [@IN_ORDER@];
const counts = [@COUNTS@];
const [once, inside] = [@ONCE@, @INSIDE@];
const [isFirst, nothing] = [@FIRST@, @NOTHING@]; // one of oneOf, or, if nothing, no cell
const said = "@SAID@";
// Of each of oneOf: from, to; and the faces by which the ray may come in.
const tRange = doubles(@T@);
const distanceRange = doubles(@DISTANCE@);
const faces = [@FACES@];
// How the adapter is asked, and what it answers.
const [bits, needsReceived] = [@BITS@, @NEEDS_RECEIVED@];
const known = [@KNOWN@];
const command = "@COMMAND@";
const request = "@REQUEST@";

/**
 * What the traversal says, { cells, t, distance, face, said }: put your own call here. As it stands, it asks the
 * adapter.
 */
async function visited() {
  assert(command !== "", "put your traversal into visited()");
  const adapter = spawn("sh", ["-c", command], { stdio: ["pipe", "pipe", "inherit"], detached: true });
  const late = setTimeout(() => process.kill(-adapter.pid, "SIGKILL"), @SECONDS@000);
  adapter.stdin.on("error", () => {}); // it need not read
  adapter.stdin.end(request);
  let stdout = "";
  for await (const some of adapter.stdout.setEncoding("utf8")) stdout += some;
  if (adapter.exitCode === null && adapter.signalCode === null) await new Promise((ended) => adapter.on("exit", ended));
  clearTimeout(late);
  assert(adapter.signalCode !== "SIGKILL", "no answer within @SECONDS@ s");
  const lines = stdout.split("\n").slice(0, -1);
  while (lines.length && /promise|cells|segments|batch|numbers|tolerance|float|echo true/.test(lines[0])) lines.shift();
  assert(lines.length > 0, "the program ended before it answered");
  assert(lines.length === 1, "there is another line behind the answer");
  return read(lines[0]);
}

const isBits = (word) => /^[0-9a-fA-F]{16}$/.test(word);

function membersOf(line) {
  if (line.includes('"answers"')) line = line.slice(line.indexOf("[", line.indexOf('"answers"')) + 1);
  const all = new Map([["", []]]);
  let [key, word, depth, quoted] = ["", "", 0, false];
  for (const c of line + " ") {
    if (!' \t\r[]{},:"'.includes(c)) {
      word += c;
      continue;
    }
    if (word) {
      if (depth === 0 && /^(t|distance|face|received|id|echo)$/.test(word)) all.set((key = word), []);
      else all.get(key).push(quoted && isBits(word) ? "#" + word : word);
      word = "";
    }
    if (c === ":" && depth === 1) {
      assert(all.get(key).length > 0, "no answer: " + line);
      all.set((key = all.get(key).pop()), []);
    }
    quoted = quoted !== (c === '"');
    depth += "[{".includes(c) ? 1 : "]}".includes(c) ? -1 : 0;
  }
  return all;
}

function number(word) {
  if (word === undefined) return undefined;
  if (word[0] === "#" || (bits && isBits(word))) return doubles(BigInt("0x" + word.replace("#", "")))[0];
  const hex = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)(?:p([+-]?\d+))?$/i.exec(word);
  if (!hex) return /^[+-]?inf/i.test(word) ? (word[0] === "-" ? -Infinity : Infinity) : Number(word);
  let [x, power] = [parseInt(hex[2] + hex[3], 16), Number(hex[4] ?? 0) - 4 * hex[3].length];
  for (let step; power !== 0; power -= step) x *= 2 ** (step = Math.max(-1000, Math.min(1000, power)));
  return hex[1] === "-" ? -x : x;
}

function read(line) {
  const members = membersOf(line);
  for (const key of members.keys()) assert(known.includes(key), "no answer: " + line);
  const of = (key) => members.get(key) ?? [];
  const words = ["", "visited", "first", "hit", "count"].flatMap(of).filter((w) => w !== "null" && w !== "none");
  assert(!words.includes("skip") && !of("skip").includes("true"), "the adapter declines this ray");
  assert(of("id").every((w) => w === "0"), "its id is not 0: " + line);
  assert(!needsReceived || of("received").length > 0, 'there is no "received": ' + line);
  const answer = { cells: [], t: number(of("t")[0]), distance: number(of("distance")[0]), said: "" };
  answer.face = of("face")[0]?.replace("null", "none");
  if (said !== "") {
    assert(words.length > 0, "no answer: " + line);
    return { ...answer, said: words[0] };
  }
  const numbers = words.map(Number);
  assert(numbers.length % @AXES@ === 0 && numbers.every(Number.isInteger), "no answer: " + line);
  for (let i = 0; i < numbers.length; i += @AXES@) answer.cells.push(numbers.slice(i, i + @AXES@));
  return answer;
}

test("@NAME@", async () => {
  const answer = await visited();
  const list = answer.cells.map(String);
  const all = list.join(" ");
  const has = (v) => list.includes(String(v));
  for (const v of must) assert(has(v), `${v} is not visited: ${all}`);
  assert(isFirst || oneOf.length === 0 || oneOf.some(has), `none of ${oneOf.join(" ")} is visited: ${all}`);
  for (const v of noneOf) assert(!has(v), `${v} is visited: ${all}`);
  const order = inOrder.map(String);
  const places = list.map((v) => order.indexOf(v)).filter((place) => place >= 0);
  assert(places.every((p, i) => i === 0 || places[i - 1] < p), `not in the order ${order.join(" ")}: ${all}`);
  if (once) assert(new Set(list).size === list.length, `told twice: ${all}`);
  if (inside)
    for (const v of answer.cells) assert(v.every((x, a) => 0 <= x && x < counts[a]), `${v} is not in the grid`);
  for (const x of [answer.t, answer.distance]) assert(!Number.isNaN(x), "a NaN");
  let word = answer.said;
  if (said === "odd" || said === "even") word = Number(word) % 2 === 1 ? "odd" : "even";
  if (said === "true" || said === "false") word = { 1: "true", 0: "false" }[word] ?? word;
  assert(word === said, `${answer.said} is not ${said}`);
  if (!isFirst) return;
  assert(list.length <= 1, `more than one first cell: ${all}`);
  if (!occupied.some(has)) return assert(nothing, `none of ${oneOf.join(" ")} is the first: ${all}`);
  const place = oneOf.map(String).indexOf(list[0]);
  assert(place >= 0, `${all} is none of ${oneOf.join(" ")}`);
  const right = (x, [from, to]) => assert(x === undefined || (from <= x && x <= to), `${x} is not from ${from} to ${to}`);
  if (tRange.length > 0) {
    assert((answer.t ?? answer.distance) !== undefined, "neither t nor distance is told");
    right(answer.t, tRange.slice(2 * place));
    right(answer.distance, distanceRange.slice(2 * place));
  }
  if (faces.length > 0)
    assert(faces[place].split(" ").includes(answer.face), `the face ${answer.face} is none of ${faces[place]}`);
});
)TEMPLATE";

constexpr std::string_view python = R"TEMPLATE(@TITLE@import os
import re
import signal
import struct
import subprocess
import unittest


def doubles(*bits):
    return [struct.unpack("<d", struct.pack("<Q", b))[0] for b in bits]


# Cells: @WHAT@.
@SCENE@CELL = @CELL@
OCCUPIED = [@OCCUPIED@]
# What a right answer holds.
MUST = [@MUST@]
ONE_OF = [@ONE_OF@]
NONE_OF = [@NONE_OF@]
IN_ORDER = [@IN_ORDER@]
COUNTS = [@COUNTS@]
ONCE, INSIDE = @ONCE@, @INSIDE@
FIRST, NOTHING = @FIRST@, @NOTHING@  # one of ONE_OF, or, if NOTHING, no cell
SAID = "@SAID@"
# Of each of ONE_OF: from, to; and the faces by which the ray may come in.
T = doubles(@T@)
DISTANCE = doubles(@DISTANCE@)
FACES = [@FACES@]
# How the adapter is asked, and what it answers.
BITS, NEEDS_RECEIVED = @BITS@, @NEEDS_RECEIVED@
KNOWN = [@KNOWN@]
COMMAND = "@COMMAND@"
REQUEST = "@REQUEST@"


class Answer:
    def __init__(self, cells=(), t=None, distance=None, face=None, said=""):
        self.cells = [list(c) for c in cells]  # in the traversal's order
        self.t, self.distance = t, distance
        self.face = face  # "-x", "none"
        self.said = said  # "true", "false", or a count


def visited():
    """What the traversal says: put your own call here. As it stands, it asks the adapter."""
    assert COMMAND, "put your traversal into visited()"
    process = subprocess.Popen(["sh", "-c", COMMAND], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                               errors="replace", start_new_session=True)
    try:
        out, _ = process.communicate(REQUEST, timeout=@SECONDS@)
    except subprocess.TimeoutExpired:
        raise AssertionError("no answer within @SECONDS@ s") from None
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    lines = out.split("\n")[:-1]
    while lines and re.search("promise|cells|segments|batch|numbers|tolerance|float|echo true", lines[0]):
        del lines[0]
    assert lines, "the program ended before it answered"
    assert len(lines) == 1, "there is another line behind the answer"
    return read(lines[0])


def is_bits(word):
    return re.fullmatch("[0-9a-fA-F]{16}", word)


def members_of(line):
    if '"answers"' in line:
        line = line.split('"answers"')[1].split("[", 1)[1]
    members, key, word, depth, quoted = {"": []}, "", "", 0, False
    for c in line + " ":
        if c not in ' \t\r[]{},:"':
            word += c
            continue
        if word:
            if depth == 0 and word in ("t", "distance", "face", "received", "id", "echo"):
                key = word
                members[key] = []
            else:
                members[key].append("#" + word if quoted and is_bits(word) else word)
            word = ""
        if c == ":" and depth == 1:
            key = members[key].pop()
            members[key] = []
        quoted ^= c == '"'
        depth += (c in "[{") - (c in "]}")
    return members


def number(words):
    if not words:
        return None
    word = words[0]
    if word[0] == "#" or (BITS and is_bits(word)):
        return doubles(int(word.strip("#"), 16))[0]
    return float.fromhex(word) if "0x" in word.lower() else float(word)


def read(line):
    members = members_of(line)
    for key in members:
        assert key in KNOWN, "no answer: " + line
    words = [w for key in ("", "visited", "first", "hit", "count") for w in members.get(key, [])
             if w not in ("null", "none")]
    assert "skip" not in words and "true" not in members.get("skip", []), "the adapter declines this ray"
    assert members.get("id", ["0"]) == ["0"], "its id is not 0: " + line
    assert members.get("received") or not NEEDS_RECEIVED, 'there is no "received": ' + line
    face = members.get("face") and members["face"][0].replace("null", "none")
    answer = Answer([], number(members.get("t")), number(members.get("distance")), face)
    if SAID:
        assert words, "no answer: " + line
        answer.said = words[0]
        return answer
    assert len(words) % @AXES@ == 0, "no answer: " + line
    numbers = [int(float(w)) if "." in w or "e" in w else int(w) for w in words]
    answer.cells = [numbers[i:i + @AXES@] for i in range(0, len(numbers), @AXES@)]
    return answer


class Ray(unittest.TestCase):
    def right(self, x, low, high):
        if x is not None:
            self.assertTrue(low <= x <= high, f"{x!r} is not from {low!r} to {high!r}")

    def test_@NAME@(self):
        answer = visited()
        cells = answer.cells
        for cell in MUST:
            self.assertIn(cell, cells, "not visited")
        if ONE_OF and not FIRST:
            self.assertTrue(any(v in cells for v in ONE_OF), f"none of {ONE_OF} is visited: {cells}")
        for cell in NONE_OF:
            self.assertNotIn(cell, cells, "visited")
        places = [IN_ORDER.index(v) for v in cells if v in IN_ORDER]
        self.assertEqual(places, sorted(places), f"not in the order {IN_ORDER}: {cells}")
        if ONCE:
            self.assertEqual(len(cells), len(set(map(tuple, cells))), f"told twice: {cells}")
        if INSIDE:
            for cell in cells:
                self.assertTrue(all(0 <= x < n for x, n in zip(cell, COUNTS)), f"{cell} is not in the grid")
        for x in (answer.t, answer.distance):
            self.assertFalse(x is not None and x != x, "a NaN")
        said = answer.said
        if SAID in ("odd", "even"):
            said = "odd" if int(said) % 2 else "even"
        if SAID in ("true", "false"):
            said = {"1": "true", "0": "false"}.get(said, said)
        self.assertEqual(said, SAID)
        if not FIRST:
            return
        self.assertLessEqual(len(cells), 1, "more than one first cell")
        if not any(cell in OCCUPIED for cell in cells):
            self.assertTrue(NOTHING, f"none of {ONE_OF} is the first: {cells}")
            return
        self.assertIn(cells[0], ONE_OF)
        place = ONE_OF.index(cells[0])
        if T:
            self.assertFalse(answer.t is None and answer.distance is None, "neither t nor distance is told")
            self.right(answer.t, *T[2 * place:2 * place + 2])
            self.right(answer.distance, *DISTANCE[2 * place:2 * place + 2])
        if FACES:
            self.assertIn(answer.face, FACES[place].split())


if __name__ == "__main__":
    unittest.main()
)TEMPLATE";

constexpr std::string_view cpp = R"TEMPLATE(@TITLE@#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using cell = std::array<std::int64_t, @AXES@>; // @WHAT@
using cells = std::vector<cell>;
using words = std::vector<std::string>;
using bits_of_doubles = std::vector<std::uint64_t>;

@SCENE@[[maybe_unused]] const cells about{@CELL@};
const cells occupied{@OCCUPIED@};
// What a right answer holds.
const cells must{@MUST@};
const cells one_of{@ONE_OF@};
const cells none_of{@NONE_OF@};
const cells in_order{@IN_ORDER@};
const cell counts{@COUNTS@};
const bool once = @ONCE@, inside = @INSIDE@;
const bool is_first = @FIRST@, nothing = @NOTHING@; // one of one_of, or, if nothing, no cell
const std::string said = "@SAID@";
// Of each of one_of: from, to; and the faces by which the ray may come in.
const bits_of_doubles t_range{@T@};
const bits_of_doubles distance_range{@DISTANCE@};
const words faces{@FACES@};
// How the adapter is asked, and what it answers.
const bool bits = @BITS@, needs_received = @NEEDS_RECEIVED@;
const words known{@KNOWN@};
const std::string command = "@COMMAND@";
const std::string request = "@REQUEST@";

struct answer {
  cells list{};                // in the traversal's order
  std::vector<double> t{}, distance{}; // one, or none
  std::string face{};          // "-x", "none"
  std::string said{};          // "true", "false", or a count
};

void check(bool good, const char* what) {
  if (good)
    return;
  std::printf("failed: %s\n", what);
  std::exit(1);
}

double number(std::uint64_t of_bits) {
  double x;
  std::memcpy(&x, &of_bits, sizeof x);
  return x;
}

volatile pid_t adapter = 0;

/// The adapter's line, without what it says first of all.
std::string line_of_adapter() {
  std::signal(SIGALRM, [](int) {
    const char late[] = "failed: no answer within @SECONDS@ s\n";
    kill(-adapter, SIGKILL);
    _exit(write(1, late, sizeof late - 1) > 0 ? 1 : 2);
  });
  alarm(@SECONDS@);
  std::signal(SIGPIPE, SIG_IGN); // it need not read
  int to[2], from[2];
  check(pipe(to) == 0 && pipe(from) == 0, "no pipe");
  adapter = fork();
  check(adapter >= 0, "no process");
  if (adapter == 0) {
    setpgid(0, 0);
    dup2(to[0], 0);
    dup2(from[1], 1);
    for (int end : {to[0], to[1], from[0], from[1]})
      close(end);
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  setpgid(adapter, adapter);
  close(to[0]);
  close(from[1]);
  const bool sent = write(to[1], request.data(), request.size()) >= 0;
  close(to[1]);
  std::FILE* out = fdopen(from[0], "r");
  check(sent || out != nullptr, "no pipe");
  words lines{std::string()};
  for (int c; (c = std::getc(out)) != EOF;)
    if (c != '\n') {
      lines.back() += static_cast<char>(c);
    } else {
      bool greets = false;
      for (const char* word : {"promise", "cells", "segments", "batch", "numbers", "tolerance", "float", "echo true"})
        greets = greets || (lines.size() == 1 && lines[0].find(word) != std::string::npos);
      if (greets)
        lines[0].clear();
      else
        lines.emplace_back();
    }
  alarm(0);
  kill(-adapter, SIGKILL);
  check(lines.size() > 1, "the program ended before it answered");
  check(lines.size() == 2, "there is another line behind the answer");
  return lines[0];
}

bool is_bits(const std::string& word) {
  return word.size() == 16 && std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isxdigit(c); });
}

std::map<std::string, words> members_of(std::string line) {
  if (const auto at = line.find("\"answers\""); at != std::string::npos)
    line = line.substr(line.find('[', at) + 1);
  std::map<std::string, words> all{{"", {}}};
  std::string key, word;
  int depth = 0;
  bool quoted = false;
  for (char c : line + " ") {
    if (std::strchr(" \t\r[]{},:\"", c) == nullptr || c == 0) {
      word += c;
      continue;
    }
    if (!word.empty()) {
      const words names{"t", "distance", "face", "received", "id", "echo"};
      if (depth == 0 && std::find(names.begin(), names.end(), word) != names.end())
        all[key = word] = {};
      else
        all[key].push_back(quoted && is_bits(word) ? "#" + word : word);
      word.clear();
    }
    if (c == ':' && depth == 1) {
      check(!all[key].empty(), "no answer");
      const std::string name = all[key].back();
      all[key].pop_back();
      all[key = name] = {};
    }
    quoted = quoted != (c == '"');
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
  }
  return all;
}

std::vector<double> numbers_of(const words& list) {
  if (list.empty())
    return {};
  std::string word = list[0];
  if (word[0] == '#' || (bits && is_bits(word)))
    return {number(std::strtoull(word.c_str() + (word[0] == '#' ? 1 : 0), nullptr, 16))};
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  check(*end == 0, "no answer: no number");
  return {x};
}

answer read(const std::string& line) {
  std::map<std::string, words> members = members_of(line);
  for (const auto& member : members)
    check(std::find(known.begin(), known.end(), member.first) != known.end(), "no answer");
  words all;
  for (const char* key : {"", "visited", "first", "hit", "count"})
    for (const std::string& word : members[key]) {
      check(word != "skip", "the adapter declines this ray");
      if (word != "null" && word != "none")
        all.push_back(word);
    }
  check(members["skip"] != words{"true"}, "the adapter declines this ray");
  check(members["id"].empty() || members["id"] == words{"0"}, "no answer: its id is not 0");
  check(!needs_received || !members["received"].empty(), "there is no \"received\"");
  answer a;
  a.t = numbers_of(members["t"]);
  a.distance = numbers_of(members["distance"]);
  if (!members["face"].empty())
    a.face = members["face"][0] == "null" ? "none" : members["face"][0];
  if (!said.empty()) {
    check(!all.empty(), "no answer");
    a.said = all[0];
    return a;
  }
  check(all.size() % @AXES@ == 0, "no answer");
  for (std::size_t i = 0; i < all.size(); i += @AXES@) {
    cell c;
    for (std::size_t axis = 0; axis < @AXES@; ++axis) {
      char* end = nullptr;
      c[axis] = static_cast<std::int64_t>(std::strtod(all[i + axis].c_str(), &end));
      check(*end == 0, "no answer: no cell");
    }
    a.list.push_back(c);
  }
  return a;
}

/// What the traversal says: put your own call here. As it stands, it asks the adapter.
answer visited() {
  check(!command.empty(), "put your traversal into visited()");
  return read(line_of_adapter());
}

std::size_t place(const cells& list, const cell& c) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), c) - list.begin());
}

bool is_within(const std::vector<double>& x, const bits_of_doubles& range, std::size_t at) {
  return x.empty() || (number(range[2 * at]) <= x[0] && x[0] <= number(range[2 * at + 1]));
}

} // namespace

int main() {
  const answer a = visited();
  const cells& list = a.list;
  const auto has = [&](const cell& c) { return place(list, c) < list.size(); };
  check(std::all_of(must.begin(), must.end(), has), "a cell is not visited that must be");
  check(is_first || one_of.empty() || std::any_of(one_of.begin(), one_of.end(), has), "none of the cells is visited");
  check(std::none_of(none_of.begin(), none_of.end(), has), "a cell is visited that must not be");
  std::size_t next = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::size_t at = place(in_order, list[i]);
    check(at == in_order.size() || at >= next, "cells are not visited in their order");
    next = at == in_order.size() ? next : at + 1;
    check(!once || place(list, list[i]) == i, "a cell is told twice");
    for (std::size_t axis = 0; axis < @AXES@; ++axis)
      check(!inside || (0 <= list[i][axis] && list[i][axis] < counts[axis]), "a cell is not in the grid");
  }
  for (const std::vector<double>& x : {a.t, a.distance})
    check(x.empty() || x[0] == x[0], "a NaN");
  std::string word = a.said;
  if (said == "odd" || said == "even")
    word = std::strtoull(word.c_str(), nullptr, 10) % 2 != 0 ? "odd" : "even";
  if (said == "true" || said == "false")
    word = word == "1" ? "true" : word == "0" ? "false" : word;
  check(word == said, "what is said is wrong");
  if (is_first) {
    check(list.size() <= 1, "there is more than one first cell");
    if (std::none_of(occupied.begin(), occupied.end(), has)) {
      check(nothing, "no first cell is told");
    } else {
      const std::size_t at = place(one_of, list[0]);
      check(at < one_of.size(), "the first cell is another");
      if (!t_range.empty()) {
        check(!a.t.empty() || !a.distance.empty(), "neither t nor distance is told");
        check(is_within(a.t, t_range, at), "t is wrong");
        check(is_within(a.distance, distance_range, at), "the distance is wrong");
      }
      if (!faces.empty())
        check(!a.face.empty() && (" " + faces[at] + " ").find(" " + a.face + " ") != std::string::npos,
              "the face is wrong");
    }
  }
  std::puts("passed");
}
)TEMPLATE";

} // namespace

std::string_view test_template(language l) {
  constexpr std::array<std::string_view, 6> all{rust, go, java, javascript, python, cpp};
  return all[static_cast<unsigned>(l)];
}

} // namespace graze::fuzz

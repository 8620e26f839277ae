#include <array>
#include <report/reproducer/test_templates.hpp>

namespace graze::fuzz {

namespace {

constexpr std::string_view rust = R"TEMPLATE(@TITLE@#![allow(dead_code, non_snake_case)]
use std::io::{Read, Write};
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::Duration;

type Voxel = [u64; 3];
// The bits of the doubles.
const ORIGIN: [u64; 3] = [@ORIGIN@];
const DIRECTION: [u64; 3] = [@DIRECTION@];
const ROOT_LO: [u64; 3] = [@LO@];
const ROOT_SIZE: u64 = @SIZE@;
const LEVEL: u32 = @LEVEL@; // the grid has 2^LEVEL voxels an axis
const VOXEL: Voxel = @CELL@;
const OCCUPIED: &[Voxel] = &[@BLOCK@];
// What a right answer holds.
const MUST: &[Voxel] = &[@MUST@];
const ONE_OF: &[Voxel] = &[@ONE_OF@];
const NONE_OF: &[Voxel] = &[@NONE_OF@];
const IN_ORDER: &[Voxel] = &[@IN_ORDER@];
const ONCE: bool = @ONCE@;
const INSIDE: bool = @INSIDE@;
const COMMAND: &str = "@COMMAND@";
const REQUEST: &str = "@REQUEST@";

/// The voxels that the traversal visits, in order: put your own call here. As it stands, it asks the adapter.
fn visited() -> Vec<Voxel> {
    let (_origin, _direction) = (ORIGIN.map(f64::from_bits), DIRECTION.map(f64::from_bits));
    assert!(!COMMAND.is_empty(), "put your traversal into visited()");
    voxels_of(&answer())
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
    let is_first = |l: &str| "@FIRST@".split('|').any(|word| l.contains(word));
    let line = text.lines().find(|l| !is_first(l));
    line.expect("the program ended before it answered").to_string()
}

/// Reads [[x,y,z],...], {"visited":[[x,y,z],...]} or x y z ...
fn voxels_of(line: &str) -> Vec<Voxel> {
    assert!(!line.contains("skip"), "the adapter declines this ray");
    let line = line.split("received").next().unwrap();
    let line = line.split("\"visited\"").last().unwrap();
    let (mut numbers, mut depth, mut opened) = (Vec::new(), 0, false);
    let mut word = String::new();
    for c in line.chars().chain(" ".chars()) {
        if c.is_ascii_digit() || c == '-' {
            word.push(c);
            continue;
        }
        if !word.is_empty() {
            numbers.push(word.parse::<i64>().expect("no answer") as u64);
            word.clear();
        }
        depth += (c == '[') as i32 - (c == ']') as i32;
        opened |= c == '[';
        if opened && depth == 0 {
            break;
        }
    }
    assert!(numbers.len() % 3 == 0, "no answer: {}", line);
    numbers.chunks(3).map(|v| [v[0], v[1], v[2]]).collect()
}

#[test]
fn @NAME@() {
    let visited = visited();
    for voxel in MUST {
        assert!(visited.contains(voxel), "{:?} is not visited: {:?}", voxel, visited);
    }
    if !ONE_OF.is_empty() {
        let any = visited.iter().any(|v| ONE_OF.contains(v));
        assert!(any, "none of {:?} is visited: {:?}", ONE_OF, visited);
    }
    for voxel in NONE_OF {
        assert!(!visited.contains(voxel), "{:?} is visited: {:?}", voxel, visited);
    }
    let places: Vec<_> = visited.iter().filter_map(|v| IN_ORDER.iter().position(|o| o == v)).collect();
    let ordered = places.windows(2).all(|p| p[0] < p[1]);
    assert!(ordered, "not in the order {:?}: {:?}", IN_ORDER, visited);
    for (i, voxel) in visited.iter().enumerate() {
        assert!(!ONCE || !visited[..i].contains(voxel), "{:?} is visited twice: {:?}", voxel, visited);
        assert!(!INSIDE || voxel.iter().all(|&x| x < @COUNT@), "{:?} is not in the grid", voxel);
    }
}
)TEMPLATE";

constexpr std::string_view go = R"TEMPLATE(@TITLE@package graze_test

import (
	"bytes"
	"encoding/json"
	"math"
	"os/exec"
	"regexp"
	"strconv"
	"strings"
	"syscall"
	"testing"
	"time"
)

// visited_@NAME@ gives the voxels that the traversal visits, in order: put your own call here. As it
// stands, it asks the adapter.
func visited_@NAME@(t *testing.T) [][3]uint64 {
	bits := func(b [3]uint64) (v [3]float64) {
		for a := range b {
			v[a] = math.Float64frombits(b[a])
		}
		return v
	}
	origin := bits([3]uint64{@ORIGIN@})
	direction := bits([3]uint64{@DIRECTION@})
	rootLo := bits([3]uint64{@LO@})
	rootSize := math.Float64frombits(@SIZE@)
	level := @LEVEL@ // the grid has 2^level voxels an axis
	voxel := [3]uint64@CELL@
	occupied := [][3]uint64{@BLOCK@}
	_, _, _, _, _, _, _ = origin, direction, rootLo, rootSize, level, voxel, occupied

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
	for _, line := range strings.Split(out.String(), "\n") {
		if line == "" || regexp.MustCompile("@FIRST@").MatchString(line) {
			continue // what an adapter says first of all
		}
		if strings.Contains(line, "skip") {
			t.Fatal("the adapter declines this ray")
		}
		var list [][3]uint64
		var object struct{ Visited [][3]uint64 }
		if json.Unmarshal([]byte(line), &list) == nil {
			return list
		}
		if json.Unmarshal([]byte(line), &object) == nil {
			return object.Visited
		}
		var numbers []uint64 // x y z ...
		for _, word := range regexp.MustCompile(`\S+`).FindAllString(strings.Split(line, "received")[0], -1) {
			number, err := strconv.ParseUint(word, 10, 64)
			if err != nil {
				t.Fatal("no answer: ", line)
			}
			numbers = append(numbers, number)
		}
		for i := 0; i+2 < len(numbers); i += 3 {
			list = append(list, [3]uint64(numbers[i:i+3]))
		}
		return list
	}
	if strings.HasPrefix(out.String(), "\n") || strings.Contains(out.String(), "\n\n") {
		return nil // an empty line: nothing is visited
	}
	t.Fatal("the program ended before it answered")
	return nil
}

func Test_@NAME@(t *testing.T) {
	visited := visited_@NAME@(t)
	place := func(list [][3]uint64, voxel [3]uint64) int {
		for i, v := range list {
			if v == voxel {
				return i
			}
		}
		return -1
	}
	for _, voxel := range [][3]uint64{@MUST@} {
		if place(visited, voxel) < 0 {
			t.Error(voxel, "is not visited:", visited)
		}
	}
	oneOf, any := [][3]uint64{@ONE_OF@}, false
	for _, voxel := range oneOf {
		any = any || place(visited, voxel) >= 0
	}
	if len(oneOf) > 0 && !any {
		t.Error("none of", oneOf, "is visited:", visited)
	}
	for _, voxel := range [][3]uint64{@NONE_OF@} {
		if place(visited, voxel) >= 0 {
			t.Error(voxel, "is visited:", visited)
		}
	}
	inOrder, last := [][3]uint64{@IN_ORDER@}, -1
	for i, voxel := range visited {
		if at := place(inOrder, voxel); at >= 0 {
			if at <= last {
				t.Error("not in the order", inOrder, ":", visited)
			}
			last = at
		}
		if @ONCE@ && place(visited, voxel) < i {
			t.Error(voxel, "is visited twice:", visited)
		}
		if @INSIDE@ && (voxel[0] >= @COUNT@ || voxel[1] >= @COUNT@ || voxel[2] >= @COUNT@) {
			t.Error(voxel, "is not in the grid")
		}
	}
}
)TEMPLATE";

constexpr std::string_view java = R"TEMPLATE(@TITLE@import java.io.File;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

class Graze_@NAME@ {
  // The bits of the doubles.
  static final long[] ORIGIN = {@ORIGIN@};
  static final long[] DIRECTION = {@DIRECTION@};
  static final long[] ROOT_LO = {@LO@};
  static final long ROOT_SIZE = @SIZE@;
  static final int LEVEL = @LEVEL@; // the grid has 2^LEVEL voxels an axis
  static final long[] VOXEL = @CELL@;
  static final long[][] OCCUPIED = {@BLOCK@};
  // What a right answer holds.
  static final long[][] MUST = {@MUST@};
  static final long[][] ONE_OF = {@ONE_OF@};
  static final long[][] NONE_OF = {@NONE_OF@};
  static final long[][] IN_ORDER = {@IN_ORDER@};
  static final boolean ONCE = @ONCE@, INSIDE = @INSIDE@;
  static final String COMMAND = "@COMMAND@";
  static final String REQUEST = "@REQUEST@";

  static double[] doubles(long[] bits) {
    return Arrays.stream(bits).mapToDouble(Double::longBitsToDouble).toArray();
  }

  /** The voxels that the traversal visits, in order: put your own call here. As it stands, it asks the adapter. */
  static List<long[]> visited() throws Exception {
    double[] origin = doubles(ORIGIN), direction = doubles(DIRECTION);
    check(!COMMAND.isEmpty(), "put your traversal into visited()");
    return voxels(answer());
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
      for (String line : Files.readAllLines(out.toPath()))
        if (!line.matches(".*(@FIRST@).*")) return line;
    } finally {
      out.delete();
      in.delete();
    }
    throw new AssertionError("the program ended before it answered");
  }

  /** Reads [[x,y,z],...], {"visited":[[x,y,z],...]} or x y z ... */
  static List<long[]> voxels(String line) {
    check(!line.contains("skip"), "the adapter declines this ray");
    int received = line.indexOf("received"), at = line.indexOf("\"visited\"");
    if (received > at) line = line.substring(0, received);
    if (at >= 0) line = line.substring(at + 9);
    List<Long> numbers = new ArrayList<>();
    int depth = 0;
    boolean opened = false;
    StringBuilder word = new StringBuilder();
    for (char c : (line + " ").toCharArray()) {
      if (Character.isDigit(c) || c == '-') {
        word.append(c);
        continue;
      }
      if (word.length() > 0) numbers.add(Long.parseLong(word.toString()));
      word.setLength(0);
      depth += c == '[' ? 1 : c == ']' ? -1 : 0;
      opened |= c == '[';
      if (opened && depth == 0) break;
    }
    check(numbers.size() % 3 == 0, "no answer: " + line);
    List<long[]> voxels = new ArrayList<>();
    for (int i = 0; i < numbers.size(); i += 3)
      voxels.add(new long[] {numbers.get(i), numbers.get(i + 1), numbers.get(i + 2)});
    return voxels;
  }

  static int place(List<long[]> list, long[] voxel) {
    for (int i = 0; i < list.size(); ++i)
      if (Arrays.equals(list.get(i), voxel)) return i;
    return -1;
  }

  static void check(boolean good, String message) {
    if (!good) throw new AssertionError(message);
  }

  static void test() throws Exception {
    List<long[]> visited = visited();
    String all = Arrays.deepToString(visited.toArray());
    for (long[] voxel : MUST)
      check(place(visited, voxel) >= 0, Arrays.toString(voxel) + " is not visited: " + all);
    check(ONE_OF.length == 0 || Arrays.stream(ONE_OF).anyMatch(v -> place(visited, v) >= 0),
        "none of " + Arrays.deepToString(ONE_OF) + " is visited: " + all);
    for (long[] voxel : NONE_OF)
      check(place(visited, voxel) < 0, Arrays.toString(voxel) + " is visited: " + all);
    int last = -1;
    for (int i = 0; i < visited.size(); ++i) {
      long[] voxel = visited.get(i);
      int at = place(Arrays.asList(IN_ORDER), voxel);
      check(at < 0 || at > last, "not in the order " + Arrays.deepToString(IN_ORDER) + ": " + all);
      last = Math.max(at, last);
      check(!ONCE || place(visited, voxel) == i, Arrays.toString(voxel) + " is visited twice: " + all);
      check(!INSIDE || Arrays.stream(voxel).allMatch(x -> 0 <= x && x < @COUNT@),
          Arrays.toString(voxel) + " is not in the grid");
    }
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

// The bits of the doubles.
const doubles = (...bits) => [...new Float64Array(new BigUint64Array(bits).buffer)];
const origin = doubles(@ORIGIN@);
const direction = doubles(@DIRECTION@);
const root = { lo: doubles(@LO@), size: doubles(@SIZE@)[0] };
const level = @LEVEL@; // the grid has 2^level voxels an axis
const voxel = @CELL@;
const occupied = [@BLOCK@];
// What a right answer holds.
const must = [@MUST@];
const oneOf = [@ONE_OF@];
const noneOf = [@NONE_OF@];
const inOrder = [@IN_ORDER@];
const [once, inside] = [@ONCE@, @INSIDE@];
const command = "@COMMAND@";
const request = "@REQUEST@";

/** The voxels that the traversal visits, in order: put your own call here. As it stands, it asks the adapter. */
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
  const line = stdout.split("\n").slice(0, -1).find((l) => !/@FIRST@/.test(l));
  assert(line !== undefined, "the program ended before it answered");
  assert(!line.includes("skip"), "the adapter declines this ray");
  if (/^\s*[[{]/.test(line)) {
    const answer = JSON.parse(line);
    return Array.isArray(answer) ? answer : answer.visited;
  }
  const numbers = line.split("received")[0].split(/\s+/).filter(Boolean).map(Number); // x y z ...
  assert(numbers.every(Number.isInteger), "no answer: " + line);
  return Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
}

test("@NAME@", async () => {
  const list = (await visited()).map(String);
  const all = list.join(" ");
  const has = (v) => list.includes(String(v));
  for (const v of must) assert(has(v), `${v} is not visited: ${all}`);
  assert(oneOf.length === 0 || oneOf.some(has), `none of ${oneOf.join(" ")} is visited: ${all}`);
  for (const v of noneOf) assert(!has(v), `${v} is visited: ${all}`);
  const order = inOrder.map(String);
  const places = list.map((v) => order.indexOf(v)).filter((place) => place >= 0);
  assert(places.every((p, i) => i === 0 || places[i - 1] < p), `not in the order ${order.join(" ")}: ${all}`);
  if (once) assert(new Set(list).size === list.length, `visited twice: ${all}`);
  if (inside)
    for (const v of list)
      assert(v.split(",").every((x) => Number.isInteger(+x) && 0 <= +x && +x < @COUNT@), `${v} is not in the grid`);
});
)TEMPLATE";

constexpr std::string_view python = R"TEMPLATE(@TITLE@import json
import os
import re
import signal
import struct
import subprocess
import unittest


def doubles(*bits):
    return [struct.unpack("<d", struct.pack("<Q", b))[0] for b in bits]


ORIGIN = doubles(@ORIGIN@)
DIRECTION = doubles(@DIRECTION@)
ROOT_LO = doubles(@LO@)
ROOT_SIZE = doubles(@SIZE@)[0]
LEVEL = @LEVEL@  # the grid has 2^LEVEL voxels an axis
VOXEL = @CELL@
OCCUPIED = [@BLOCK@]
# What a right answer holds.
MUST = [@MUST@]
ONE_OF = [@ONE_OF@]
NONE_OF = [@NONE_OF@]
IN_ORDER = [@IN_ORDER@]
ONCE, INSIDE = @ONCE@, @INSIDE@
COMMAND = "@COMMAND@"
REQUEST = "@REQUEST@"


def visited():
    """The voxels that the traversal visits, in order: put your own call here. As it stands, it asks the adapter."""
    assert COMMAND, "put your traversal into visited()"
    process = subprocess.Popen(["sh", "-c", COMMAND], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                               start_new_session=True)
    try:
        out, _ = process.communicate(REQUEST, timeout=@SECONDS@)
    except subprocess.TimeoutExpired:
        raise AssertionError("no answer within @SECONDS@ s") from None
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    lines = [line for line in out.split("\n")[:-1] if not re.search("@FIRST@", line)]
    assert lines, "the program ended before it answered"
    line = lines[0]
    assert "skip" not in line, "the adapter declines this ray"
    if line.lstrip()[:1] in ("[", "{"):
        answer = json.loads(line)
        return answer if isinstance(answer, list) else answer["visited"]
    numbers = [int(word) for word in line.split("received")[0].split()]  # x y z ...
    return [numbers[i:i + 3] for i in range(0, len(numbers), 3)]


class Ray(unittest.TestCase):
    def test_@NAME@(self):
        voxels = [list(v) for v in visited()]
        for voxel in MUST:
            self.assertIn(voxel, voxels, "not visited")
        if ONE_OF:
            self.assertTrue(any(v in voxels for v in ONE_OF), f"none of {ONE_OF} is visited: {voxels}")
        for voxel in NONE_OF:
            self.assertNotIn(voxel, voxels, "visited")
        places = [IN_ORDER.index(v) for v in voxels if v in IN_ORDER]
        self.assertEqual(places, sorted(places), f"not in the order {IN_ORDER}: {voxels}")
        if ONCE:
            self.assertEqual(len(voxels), len(set(map(tuple, voxels))), f"visited twice: {voxels}")
        if INSIDE:
            for voxel in voxels:
                self.assertTrue(all(0 <= x < @COUNT@ for x in voxel), f"{voxel} is not in the grid")


if __name__ == "__main__":
    unittest.main()
)TEMPLATE";

constexpr std::string_view cpp = R"TEMPLATE(@TITLE@#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

using voxel = std::array<std::uint64_t, 3>;
using voxels = std::vector<voxel>;

// The bits of the doubles.
const std::uint64_t origin_bits[] = {@ORIGIN@};
const std::uint64_t direction_bits[] = {@DIRECTION@};
const std::uint64_t root_lo_bits[] = {@LO@};
const std::uint64_t root_size_bits = @SIZE@;
const int level = @LEVEL@; // the grid has 2^level voxels an axis
const voxels about{@CELL@};
const voxels occupied{@BLOCK@};
// What a right answer holds.
const voxels must{@MUST@};
const voxels one_of{@ONE_OF@};
const voxels none_of{@NONE_OF@};
const voxels in_order{@IN_ORDER@};
const bool once = @ONCE@, inside = @INSIDE@;
const std::string command = "@COMMAND@";
const std::string request = "@REQUEST@";

void check(bool good, const char* what) {
  if (good)
    return;
  std::printf("failed: %s\n", what);
  std::exit(1);
}

double number(std::uint64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

volatile pid_t adapter = 0;

/// The adapter's line, without what it says first of all.
std::string answer() {
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
  std::string line;
  for (int c; (c = std::getc(out)) != EOF;) {
    if (c != '\n') {
      line += static_cast<char>(c);
    } else if (std::regex_search(line, std::regex("@FIRST@"))) {
      line.clear();
    } else {
      alarm(0);
      kill(-adapter, SIGKILL);
      return line;
    }
  }
  check(false, "the program ended before it answered");
  return line;
}

/// Reads [[x,y,z],...], {"visited":[[x,y,z],...]} or x y z ...
voxels read(std::string line) {
  check(line.find("skip") == std::string::npos, "the adapter declines this ray");
  if (const auto at = line.find("\"visited\""); at != std::string::npos)
    line = line.substr(at + 9);
  line = line.substr(0, line.find("received")) + " ";
  std::vector<std::uint64_t> numbers;
  std::string word;
  int depth = 0;
  for (char c : line) {
    if ((c >= '0' && c <= '9') || c == '-') {
      word += c;
      continue;
    }
    if (!word.empty())
      numbers.push_back(static_cast<std::uint64_t>(std::strtoll(word.c_str(), nullptr, 10)));
    word.clear();
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ']' && depth == 0)
      break;
  }
  check(numbers.size() % 3 == 0, "no answer");
  voxels all;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    all.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return all;
}

/// The voxels that the traversal visits, in order: put your own call here. As it stands, it asks the adapter.
voxels visited() {
  const double origin[] = {number(origin_bits[0]), number(origin_bits[1]), number(origin_bits[2])};
  const double direction[] = {number(direction_bits[0]), number(direction_bits[1]), number(direction_bits[2])};
  (void)origin, (void)direction, (void)root_lo_bits, (void)root_size_bits, (void)level;
  check(!command.empty(), "put your traversal into visited()");
  return read(answer());
}

std::size_t place(const voxels& list, const voxel& v) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), v) - list.begin());
}

} // namespace

int main() {
  const voxels list = visited();
  const auto has = [&](const voxel& v) { return place(list, v) < list.size(); };
  check(std::all_of(must.begin(), must.end(), has), "a voxel is not visited that must be");
  check(one_of.empty() || std::any_of(one_of.begin(), one_of.end(), has), "none of the voxels is visited");
  check(std::none_of(none_of.begin(), none_of.end(), has), "a voxel is visited that must not be");
  std::size_t next = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::size_t at = place(in_order, list[i]);
    check(at == in_order.size() || at >= next, "voxels are not visited in their order");
    next = at == in_order.size() ? next : at + 1;
    check(!once || place(list, list[i]) == i, "a voxel is visited twice");
    for (std::uint64_t x : list[i])
      check(!inside || x < @COUNT@, "a voxel is not in the grid");
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

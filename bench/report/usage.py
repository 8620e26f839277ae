"""usage.py FILE COMMAND...: runs the command and writes what it took, as JSON, to FILE.

A process of its own, because a child's peak memory begins with that of the process that starts it:
this one's is about 9 MB, and what needs less is told as that much.
"""
import json
import os
import sys
import time

start = time.monotonic()
try:
    child = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
except OSError as error:
    sys.exit(f"{sys.argv[2]}: {error.strerror}")
_, status, usage = os.wait4(child, 0)
seconds = time.monotonic() - start
with open(sys.argv[1], "w") as file:
    json.dump({"seconds": seconds, "processor": usage.ru_utime + usage.ru_stime,
               "peak_bytes": 1024 * usage.ru_maxrss}, file)
code = os.waitstatus_to_exitcode(status)
sys.exit(code if code >= 0 else 128 - code)

#!/usr/bin/env python3
"""data/golden/ACCURACY.md on standard output: how accurate fast and the peers of its bench are, and what ref takes.
   nipref audit QUANTITY... --json >audit.json; nipref bench QUANTITY... --json >bench.json
   accuracy.py NIPREF audit.json bench.json >data/golden/ACCURACY.md
The widths are the bounds of golden values; `golden check` fails if they grow."""
import csv
import json
import resource
import subprocess
import sys


def answer(*arguments):
    done = subprocess.run([sys.argv[1], *arguments, "--json"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def saved(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def width(path):
    """The largest ratio of bound to scale; rows with the scale 0 are left out."""
    with open(path, encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return max((float(row["bound"]) / float(row["scale"]) for row in rows if float(row["scale"]) > 0), default=0)


def milliseconds(name):
    """The processor time for each value that `golden check` recomputes by ref."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    made = answer("golden", "check", name)["files"][0]["recomputed"]
    return 1000 * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before) / made


def domain(quantity):
    return "; ".join(f"{argument['name']}: {argument['domain']}" for argument in quantity["arguments"]).replace("|", "\\|")


def table(heads, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [heads, ["---"] * len(heads), *rows])


known = {quantity["name"]: quantity for quantity in answer("list", "--full")["quantities"]}
golden = {file["quantity"]: file for file in answer("golden", "list")["files"]}
audit, bench = saved(sys.argv[2]), saved(sys.argv[3])
machine = audit["nipref"]
fast = []
for row in audit["rows"]:
    file = golden.get(row["quantity"])
    ref = [file["header"]["digits"], f"{width(file['file']):.1e}", f"{milliseconds(row['quantity']):.2g}"] if file else 3 * ["in whole contacts"]
    fast.append([f"`{row['quantity']}`", domain(known[row["quantity"]]), str(row["points"]),
                 *(f"{row[name]:.3g}" for name in ("max_error_ulp", "mean_error_ulp", "percentile_99_9_ulp", "promise_ulp")), *ref])
errors = ("max_error_ulp", "mean_error_ulp", "percentile_99_9_ulp", "max_relative_error")
peers = [[f"`{row['quantity']}`", row["range"], row["method"], *("" if row[name] is None else f"{row[name]:.3g}" for name in errors),
          f"{row['times']['nanoseconds']:.3g}"] for row in bench["rows"] if "rtol" not in row["method"]]
print(f"""# How accurate

Made by `verify/golden/accuracy.py` with nipref {machine['version']}, commit {machine['commit']}, {machine['compiler']}, on
{machine['processor']}, where `fast` runs its code for {machine['instruction_set']}.

## fast, over whole domains

Errors in units in the last place of the scale, which `nipref list QUANTITY` says, as an audit finds them at so many points. Of `ref` what it
takes to make the golden values: their digits; the largest error over the scale, where `nipref golden check` fails if one grows to 1.5 times
what is stored; and the time of a processor for a value, of all that `nipref golden check` makes anew, the start of the program among it.

{table(["quantity", "arguments", "points", "largest", "mean", "99.9 %", "promised", "digits of ref", "its width", "its time, ms"], fast)}

## Beside other libraries

As `nipref bench` finds them, at 1000 arguments of each range, in the same units; N digits have one of 10^-N of the scale. Times are medians of
wall clock, longer where the machine has other work.

{table(["quantity", "range", "method", "largest", "mean", "99.9 %", "largest relative", "time, ns"], peers)}""")

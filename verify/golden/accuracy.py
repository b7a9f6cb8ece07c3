#!/usr/bin/env python3
"""data/golden/ACCURACY.md on standard output: how accurate fast and the peers of its bench are, and how wide the enclosures of ref.
   nipref audit QUANTITY... --json >audit.json; nipref bench QUANTITY... --json >bench.json
   accuracy.py NIPREF audit.json bench.json >data/golden/ACCURACY.md
Widths are the bounds of golden values, which `golden check` keeps."""
import csv
import json
import subprocess
import sys


def answer(*arguments):
    done = subprocess.run([sys.argv[1], *arguments, "--json"], stdout=subprocess.PIPE, check=True)
    return json.loads(done.stdout)


def saved(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def width(path):
    """The largest bound over the scale, or the value where there is no scale."""
    with open(path, encoding="utf-8") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return max((float(row["bound"]) / float(row["scale"]) for row in rows if float(row["scale"]) > 0), default=0)


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
    ref = f"{width(file['file']):.1e} at {file['header']['digits']} digits" if file else "in whole contacts"
    fast.append([f"`{row['quantity']}`", domain(known[row["quantity"]]), str(row["points"]),
                 *(f"{row[name]:.3g}" for name in ("max_error_ulp", "mean_error_ulp", "percentile_99_9_ulp", "promise_ulp")), ref])
peers = [[f"`{row['quantity']}`", row["range"], row["method"], f"{row['max_error_ulp']:.3g}", f"{row['max_relative_error']:.2g}"]
         for row in bench["rows"] if "rtol" not in row["method"] and None not in (row["max_error_ulp"], row["max_relative_error"])]
print(f"""# How accurate

Made by `verify/golden/accuracy.py` with nipref {machine['version']}, commit {machine['commit']}, {machine['compiler']}, on
{machine['processor']}, where `fast` runs its code for {machine['instruction_set']}.

## fast, over whole domains

Errors in units in the last place of the scale, which `nipref list QUANTITY` says, as an audit finds them at so many points. Width: the largest
error of `ref` over the scale among the golden values; `nipref golden check` fails if one grows to 1.5 times what is stored.

{table(["quantity", "arguments", "points", "largest", "mean", "99.9 %", "promised", "width of ref"], fast)}

## Beside other libraries

As `nipref bench` finds them, at the arguments of its ranges.

{table(["quantity", "range", "method", "largest error, ulp", "largest relative error"], peers)}""")

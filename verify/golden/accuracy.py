#!/usr/bin/env python3
"""data/golden/ACCURACY.md on standard output: how accurate fast and the peers of its bench are, and how wide the enclosures of ref.
   accuracy.py PROGRAM >data/golden/ACCURACY.md
Errors are those that audits and benches of this program find now, widths the bounds of golden values, which `golden check` keeps."""
import csv
import json
import subprocess
import sys


def answer(*arguments):
    done = subprocess.run([sys.argv[1], *arguments, "--json", "--quiet"], stdout=subprocess.PIPE, check=False)
    return json.loads(done.stdout)


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
audit = answer("audit", "--density", "0.3", *known)
machine = audit["nipref"]
fast = []
for row in audit["rows"]:
    file = golden.get(row["quantity"])
    ref = f"{width(file['file']):.1e} at {file['header']['digits']} digits" if file else "in whole contacts"
    fast.append([f"`{row['quantity']}`", domain(known[row["quantity"]]), str(row["points"]),
                 *(f"{row[name]:.3g}" for name in ("max_error_ulp", "mean_error_ulp", "percentile_99_9_ulp", "promise_ulp")), ref])
bench = [[f"`{row['quantity']}`", row["range"], row["method"], f"{row['max_error_ulp']:.3g}", f"{row['max_relative_error']:.2g}"]
         for row in answer("bench")["rows"] if "rtol" not in row["method"] and row["max_error_ulp"] is not None and row["max_relative_error"] is not None]
print(f"""# How accurate

Made by `verify/golden/accuracy.py` with nipref {machine['version']}, commit {machine['commit']}, {machine['compiler']}, on
{machine['processor']}, where `fast` runs its code for {machine['instruction_set']}.

## fast, over whole domains

Errors in units in the last place of the scale, which `nipref list QUANTITY` says, as an audit of density 0.3 finds them. Width: the largest
error of `ref` over the scale among the golden values; `nipref golden check` fails if one grows to 1.5 times what is stored.

{table(["quantity", "arguments", "points", "largest", "mean", "99.9 %", "promised", "width of ref"], fast)}

## Beside other libraries

As `nipref bench` finds them, at the arguments of its ranges.

{table(["quantity", "range", "method", "largest error, ulp", "largest relative error"], bench)}""")

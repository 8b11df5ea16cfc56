"""Print pip constraints that pin every dependency of a pyproject.toml to its lower bound."""

import re
import sys
import tomllib
from pathlib import Path

project = tomllib.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["project"]
# The package never needs what the benchmarks compare it with.
extras = {name: items for name, items in project["optional-dependencies"].items() if name != "bench"}
for requirement in [*project["dependencies"], *(item for extra in extras.values() for item in extra)]:
    match = re.fullmatch(r"([A-Za-z0-9._-]+)(?:\[[a-z,]+\])?>=([0-9.]+)", requirement)
    if match is None:
        sys.exit(f"{requirement}: needs a name and a lower bound, such as numpy>=1.26")
    print(f"{match[1]}=={match[2]}")

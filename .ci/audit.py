"""Look for known vulnerabilities of the packages in this environment with pip-audit.

Status 1 where there are any. Where no database can be reached, or it knows none of the packages, say so: nothing is
audited then.
"""

import json
import subprocess
import sys

audit = [sys.executable, "-m", "pip_audit", "--skip-editable", "--format", "json", "--progress-spinner", "off"]
done = subprocess.run(audit, capture_output=True, encoding="utf-8")
try:
    packages = json.loads(done.stdout)["dependencies"]
except ValueError:
    print("NOT AUDITED: no database of vulnerabilities can be reached:", done.stderr.strip().rpartition("\n")[2])
    sys.exit(0)
audited = [package for package in packages if "vulns" in package]
for package in audited:
    for found in package["vulns"]:
        print(package["name"], package["version"], found["id"], "fixed in", ", ".join(found["fix_versions"]) or "none")
print(
    f"{len(audited)} of {len(packages)} packages audited" if audited else "NOT AUDITED: the database knows none of them"
)
sys.exit(any(package["vulns"] for package in audited))

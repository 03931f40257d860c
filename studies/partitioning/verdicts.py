#!/usr/bin/env python3
"""For studies/run.sh and studies/check.sh, which call it in this folder after the campaigns.

  verdicts.py           figures and tables in results/, verdicts in README.md and on the standard output (report.py)
  verdicts.py --test    tests the reduced form (check.py); exit status 1 if a property does not hold

Other arguments are ignored: the databases of the campaigns are read.
"""
import os
import sys

import check
import report

if __name__ == "__main__":
    if "--test" in sys.argv:
        sys.exit(check.main())
    report.main(os.path.dirname(os.path.abspath(__file__)))

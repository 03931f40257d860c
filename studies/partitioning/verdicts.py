#!/usr/bin/env python3
"""Figures, tables and verdicts of the campaigns (report.py); with --test a test of the reduced form (check.py), whose exit
status is 1 if a property does not hold. It reads the databases in this folder; other arguments are ignored."""
import os
import sys

import check
import report

if __name__ == "__main__":
    if "--test" in sys.argv:
        sys.exit(check.main())
    report.main(os.path.dirname(os.path.abspath(__file__)))

"""The report: every suite and benchmark run by one command, and ``docs/measured`` made from their records."""

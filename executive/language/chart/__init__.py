"""The grammar of sentences, the chart that finds every reading of one, and what each comes to."""

"""From a sentence to commands: words, grammar, chart, meanings."""

"""Commands of a field's exam, carried out in an arena and judged by what they should bring about."""

"""How episodes are run: by processes here or by a cluster, kept in a file as they end, and gone on with."""

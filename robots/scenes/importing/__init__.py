"""Making objects of meshes, with the extra ``import``, which running does not need."""

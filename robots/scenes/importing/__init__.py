"""Making objects of meshes: up axis, outline, convex parts; needs the extra ``import``, which running does not."""

"""What compiled code needs: the compiler's settings, the cache on disk, arrays by address."""

"""Where a segment must be drawn so that the stream strikes it as wanted."""

// In the alpha of blocks of pixels, see block_mark.frag. Interpolated between the middles of blocks, an edge weighs at least 1 / 64.
const float EDGE_MARK = 256.0;

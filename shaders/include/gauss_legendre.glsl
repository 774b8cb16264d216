// Gauss-Legendre nodes on [0, 1] and weights that sum to 1 (Abramowitz and Stegun, table 25.4). Compiled as GLSL and as C++.

Real gaussNode4(int i) {
    return i == 0 ? Real(0.06943184420297371) : i == 1 ? Real(0.33000947820757187)
         : i == 2 ? Real(0.6699905217924281) : Real(0.9305681557970263);
}

Real gaussWeight4(int i) { return i == 0 || i == 3 ? Real(0.17392742256872693) : Real(0.32607257743127307); }

// The rule of 2 * pairs nodes, pairs = 2, 3 or 4: nodes 1/2 -+ x, both of weight y, as (x, y). Pair 0 is the innermost.
Real2 gaussPair(int pair, int pairs) {
    if (pairs == 2) {
        return pair == 0 ? Real2(Real(0.16999052179242813), Real(0.32607257743127307)) : Real2(Real(0.43056815579702629), Real(0.17392742256872693));
    }
    if (pairs == 3) {
        return pair == 0 ? Real2(Real(0.11930959304159845), Real(0.23395696728634552))
             : pair == 1 ? Real2(Real(0.33060469323313226), Real(0.1803807865240693)) : Real2(Real(0.46623475710157603), Real(0.08566224618958517));
    }
    return pair == 0 ? Real2(Real(0.09171732124782490), Real(0.1813418916891810)) : pair == 1 ? Real2(Real(0.26276620495816449), Real(0.1568533229389436))
         : pair == 2 ? Real2(Real(0.39833323870681337), Real(0.1111905172266872)) : Real2(Real(0.48014492824876812), Real(0.05061426814518813));
}

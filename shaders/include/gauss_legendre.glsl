// Gauss-Legendre nodes on [0, 1] and weights that sum to 1 (Abramowitz and Stegun, table 25.4). Compiled as GLSL and as C++.

Real gaussNode4(int i) {
    return i == 0 ? Real(0.06943184420297371) : i == 1 ? Real(0.33000947820757187)
         : i == 2 ? Real(0.6699905217924281) : Real(0.9305681557970263);
}

Real gaussWeight4(int i) { return i == 0 || i == 3 ? Real(0.17392742256872693) : Real(0.32607257743127307); }

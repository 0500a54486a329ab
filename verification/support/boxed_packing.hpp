#pragma once

#include <vector>

#include "trapezoid/plane.hpp"

namespace stokesbook::test {

/// Places the centres of unit disks at random in a square box, by the definition of the dense
/// packings in Broms, Tornberg and Barnett 2026 (arXiv 2606.11273), so that counts can be compared.
///
/// The box has the side \f$ L = \sqrt{P\pi/\phi} \f$, and all disks are inside. The start is a
/// square grid or staggered rows, whichever keeps the larger distances. In each sweep every disk
/// proposes a move to a random point of the disk of radius s about its place; a move that leaves
/// the box or comes too close to another disk is refused. After each sweep, s is adapted to the
/// rate of accepted moves. The random numbers are those of the Mersenne twister with 53 bits, as in MATLAB
/// and NumPy; the places agree on every machine to rounding, which grows with the sweeps.
/// @param  count     number of disks P
/// @param  fraction  area fraction phi
/// @param  gap       least gap of two disks, in radii
/// @throws std::invalid_argument when the start does not keep the gap
std::vector<Complex> boxed_packing(int count, double fraction, double gap, unsigned seed,
                                   int sweeps = 200);

}  // namespace stokesbook::test

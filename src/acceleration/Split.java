package acceleration;

/** The things of a node divided in two: where in the order, the boxes of the sides, and the extents of their centres. */
final class Split {

  int middle;
  final Extent left = new Extent();
  final Extent right = new Extent();
  final Extent leftCentres = new Extent();
  final Extent rightCentres = new Extent();
}

package acceleration;

/** The primitives of a node divided in two: where in the order, the boxes of the sides, and the extents of their centres. */
final class Split {

  int middle;
  final BoxBuilder left = new BoxBuilder();
  final BoxBuilder right = new BoxBuilder();
  final BoxBuilder leftCentres = new BoxBuilder();
  final BoxBuilder rightCentres = new BoxBuilder();
}

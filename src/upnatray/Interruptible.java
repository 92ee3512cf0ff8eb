package upnatray;

/** Work that Ctrl-C may end early. */
@FunctionalInterface
interface Interruptible {

  /** Called once the work has stopped or the grace period is over: saves or reports what is done of it. */
  void interrupted();
}

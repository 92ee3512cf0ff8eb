package window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

import javax.swing.TransferHandler;

/** Accepts files dropped onto a component and passes on the first of them. */
final class FileDrop extends TransferHandler {

  private static final long serialVersionUID = 1L;

  private final transient Consumer<Path> receiver;

  FileDrop(final Consumer<Path> receiver) {
    this.receiver = receiver;
  }

  @Override
  public boolean canImport(final TransferSupport support) {
    return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
  }

  @Override
  public boolean importData(final TransferSupport support) {
    if (!canImport(support)) {
      return false;
    }
    try {
      final Object files = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
      if (files instanceof List<?> list && !list.isEmpty() && list.get(0) instanceof File file) {
        receiver.accept(file.toPath());
        return true;
      }
      return false;
    } catch (final UnsupportedFlavorException | IOException unavailable) {
      return false;
    }
  }
}
